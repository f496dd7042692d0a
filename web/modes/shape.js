// What a mode shape says in words, its largest value, its motions as they are drawn, and how fast it moves on the page.

/** The value farthest from zero and where it is; null where all are zero. */
export function largest(at, values) {
  const i = values.reduce((best, value, i) => (Math.abs(value) > Math.abs(values[best]) ? i : best), 0);
  return values[i] === 0 || values.length === 0 ? null : { at: at[i], value: values[i] };
}

/** The leading motion of a shape: its displacement, or twist, and its moment along the span. */
export function leadingOf({ dof, components, displacement, moment }) {
  if (components === undefined) return { displacement, moment };
  return { displacement: components[dof].displacement ?? components[dof].twist, moment: components[dof].moment };
}

/**
 * The motions of a shape along the span, as they are drawn: one that is alone or leads is 1 at its largest, the
 * others are so large beside it as their energy is. In metres and radians, twist would hide all bending or none.
 */
export function motionsDrawn(shape) {
  const { dof, shares } = shape;
  const drawn = (motion) => {
    const values = leadingOf({ ...shape, dof: motion }).displacement;
    const most = Math.max(...values.map(Math.abs));
    const size = shares === undefined ? 1 : Math.sqrt(Math.max(0, shares[motion]) / shares[dof]);
    return values.map((value) => (most > 0 ? (value * size) / most : 0));
  };
  return Object.fromEntries((shares === undefined ? [dof] : Object.keys(shares)).map((motion) => [motion, drawn(motion)]));
}

/** "Nodes at r/R 0.47 and 0.87". */
export function nodeWords(nodes) {
  if (nodes.length === 0) return "No node between root and tip";
  const shown = nodes.map((node) => node.toFixed(2));
  const last = shown.pop();
  return shown.length === 0 ? `Node at r/R ${last}` : `Nodes at r/R ${shown.join(", ")} and ${last}`;
}

/** The rotor's nominal revolution takes so many seconds on the page. */
export const REVOLUTION_S = 2;
/** Faster swings than this cannot be followed by eye; they are slowed down together with the rotor. */
const FASTEST_HZ = 5;
/** Swings per second where each mode has the same pace. */
const EVEN_HZ = 0.6;

/**
 * How fast a mode and the rotor move on the page, in turns per second, and how much slower that is
 * than real. Their ratio to each other is always the real one. `even` is the same pace for every
 * mode, else one nominal revolution takes the same time for all.
 */
export function pace({ frequency, speed, nominal }, even) {
  if (!(frequency > 0)) return { mode: 0, rotor: speed > 0 && nominal > 0 ? speed / nominal / REVOLUTION_S : 0, slower: 1, held: false };
  const wanted = even || !(nominal > 0) ? EVEN_HZ : frequency / nominal / REVOLUTION_S;
  const most = Math.min(FASTEST_HZ, speed > 0 ? (FASTEST_HZ * frequency) / speed : FASTEST_HZ);
  const mode = Math.min(wanted, most);
  return { mode, rotor: (mode * speed) / frequency, slower: frequency / (2 * Math.PI) / mode, held: mode < wanted };
}
