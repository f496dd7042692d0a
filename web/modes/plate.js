// A rotor blade as a thin plate in light perspective: where its points stand on the stage.

/** Degrees round the vertical and down from the horizon that the blade is looked at from. */
const CAMERAS = {
  side: { turn: -8, down: 13 },
  above: { turn: -5, down: 68 },
  twist: { turn: -34, down: 22 },
};
/** Distance of the eye, in radii. */
const FAR = 4;
/** Drawn chord, by leading motion, and deflections, in radii and radians; not the blade's own. */
const CHORDS = { flap: [0.035, -0.085], lag: [0.035, -0.085], torsion: [0.06, -0.14] };
const SWING = { flap: 0.17, lag: 0.15, torsion: 0.75 };
/** Room beside and above the undeformed blade where one motion leads. */
const ROOM = { flap: [0.1, 0.18], lag: [0.24, 0.06], torsion: [0.12, 0.1] };
export const STAGE = { width: 400, height: 170 };
const HUB = 0.05;

const radians = (degrees) => (degrees * Math.PI) / 180;

/** The same with the motions beside it, which are at most `sizes`. */
function room(dof, sizes) {
  const beside = (motion) => (motion === dof ? 0 : (sizes[motion] ?? 0));
  const edge = Math.max(...CHORDS[dof].map(Math.abs));
  return [ROOM[dof][0] + SWING.lag * beside("lag"), ROOM[dof][1] + SWING.flap * beside("flap") + edge * Math.sin(SWING.torsion * beside("torsion"))];
}

/**
 * What takes a point (span, chord, up; in radii) to the stage, for one view of a mode that `dof` leads; motions
 * beside it are at most `sizes`, 1 being as large as one that leads.
 */
export function camera(view, dof, sizes = {}) {
  const { turn, down } = CAMERAS[view];
  const [ct, st, cd, sd] = [Math.cos(radians(turn)), Math.sin(radians(turn)), Math.cos(radians(down)), Math.sin(radians(down))];
  const flat = ([x, y, z]) => {
    const across = (x - 0.5) * ct - y * st;
    const away = (x - 0.5) * st + y * ct;
    const near = FAR / (FAR + away * cd - z * sd);
    return [across * near, -(away * sd + z * cd) * near];
  };
  // Everything that can move stays on the stage: the corners of the room that it may take.
  const [beside, up] = room(dof, sizes);
  const corners = [];
  for (const x of [-HUB, 1]) for (const y of [-beside, beside]) for (const z of [-up, up]) corners.push(flat([x, y, z]));
  const [xs, ys] = [0, 1].map((i) => corners.map((corner) => corner[i]));
  const [left, right, top, bottom] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
  const scale = Math.min((STAGE.width - 16) / (right - left), (STAGE.height - 8) / (bottom - top));
  const [dx, dy] = [(STAGE.width - scale * (left + right)) / 2, (STAGE.height - scale * (top + bottom)) / 2];
  return (point) => flat(point).map((value, i) => value * scale + (i === 0 ? dx : dy));
}

/** The two ends of the chord at r/R `x`, where the motions are as large as given (1 at the largest of one that leads). */
export function chordAt(dof, x, { flap = 0, lag = 0, torsion = 0 }) {
  const angle = SWING.torsion * torsion;
  return CHORDS[dof].map((y) => [x, y * Math.cos(angle) + SWING.lag * lag, y * Math.sin(angle) + SWING.flap * flap]);
}

const trace = (points, project) =>
  points
    .map((point) =>
      project(point)
        .map((value) => value.toFixed(1))
        .join(" "),
    )
    .join("L");

/** Paths of the plate with `motions` along the span, at a share of its full deflection: its face, its leading edge, its ribs. */
export function platePaths(dof, at, motions, share, project) {
  const moved = Object.entries(motions);
  const chords = at.map((x, i) => chordAt(dof, x, Object.fromEntries(moved.map(([motion, values]) => [motion, values[i] * share]))));
  const lead = chords.map((chord) => chord[0]);
  const trail = chords.map((chord) => chord[1]);
  const every = Math.max(1, Math.round(chords.length / 10));
  return {
    face: `M${trace([...lead, ...trail.reverse()], project)}Z`,
    edge: `M${trace(lead, project)}`,
    ribs: chords
      .filter((_, i) => i % every === 0)
      .map((chord) => `M${trace(chord, project)}`)
      .join(""),
  };
}

/** The hub: a disc round the axis of rotation, and the arm out to the root. */
export function hubPaths(root, project) {
  const round = Array.from({ length: 24 }, (_, i) => [HUB * Math.cos((i * Math.PI) / 12), HUB * Math.sin((i * Math.PI) / 12)]);
  const disc = (z) =>
    `M${trace(
      round.map(([x, y]) => [x, y, z]),
      project,
    )}Z`;
  const side = [
    [-HUB, 0, 0.025],
    [-HUB, 0, -0.025],
    [HUB, 0, -0.025],
    [HUB, 0, 0.025],
  ];
  return {
    hub: `${disc(-0.025)}M${trace(side, project)}Z${disc(0.025)}`,
    arm: `M${trace(
      [
        [0, 0, 0],
        [root, 0, 0],
      ],
      project,
    )}`,
    shaft: `M${trace(
      [
        [0, 0, -0.15],
        [0, 0, 0.1],
      ],
      project,
    )}`,
  };
}
