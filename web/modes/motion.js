// The chosen mode: its shape along the span, its moment, and the blade in motion.

import { at, element, make } from "../lib/dom.js";
import { fieldNumber, figures } from "../lib/format.js";
import { modeOf, motionsOf, nameOf } from "../lib/labels.js";
import { shownSpeed } from "../lib/speed-words.js";
import { optionsOf } from "../solver/keep-up.js";
import { STAGE, camera, chordAt, hubPaths, platePaths } from "./plate.js";
import { isSeen, plot } from "./plot.js";
import { largest, leadingOf, motionsDrawn, nodeWords, pace } from "./shape.js";
import { modeWords, paceWords } from "./words.js";

const POINTS = 121;
/** The plate is drawn from every so many points. */
const COARSE = 3;
const VIEWS = { side: "side", above: "above", twist: "twist" };
const FROM = { side: "from the side", above: "from above", twist: "from the tip" };
const BEST = { flap: "side", lag: "above", torsion: "twist" };
const MOMENTS = { flap: "flapwise bending moment", lag: "lagwise bending moment", torsion: "torsional moment" };
/** Frames further apart than this are taken as this far, so that nothing jumps after a pause. */
const LONGEST_S = 0.1;
/** While the numbers go on changing, as when the speed is dragged, the shape waits. */
const SETTLE_MS = 80;
/** The blade stands still so long after a slider has moved: the chart comes first. */
const YIELD_MS = 200;

/**
 * The mark of a root of this kind.
 * @param {string} kind
 * @param {number[]} place on the stage
 */
function rootMark(kind, [x, y]) {
  if (kind === "hingeless" || kind === "rigid") return [element("rect", { x: x - 4, y: y - 6, width: 8, height: 12 })];
  const circle = element("circle", { cx: x, cy: y, r: 4 });
  if (kind === "hinged") return [circle];
  return [element("path", { d: `M${x - 9} ${y - 8}l3 -5l3 5l3 -5l3 5l3 -5l3 5` }), circle];
}

/** The root that holds a motion, and where: as a share of the radius. */
function rootOf({ rotor, ...blade }, dof) {
  const { root: kind, offset = 0, offset_ratio: ratio } = blade[dof];
  return { kind, at: ratio ?? offset / rotor.radius };
}

/** A mode that is mixed with torsion shows both of its motions from the tip. */
function bestView({ label, dof }) {
  return motionsOf(label).includes("torsion") ? "twist" : BEST[dof];
}

/** Shows the chosen mode from now on. */
export function startMotion(store, client) {
  const host = at("motion");
  const still = matchMedia("(prefers-reduced-motion: reduce)");
  let playing = !still.matches;
  let seen = true; // on screen
  let view = null; // null: the best for the mode
  let kindSeen = null; // a view that was chosen holds for modes of the same kind
  let frame = null;
  let last = null;
  let turns = { mode: 0, rotor: 0 };
  let report = null;
  let yielding = 0;
  let nominalSeen;
  let settling;
  let stage = null; // what the frames need: {dof, at, motions, project, pace}

  const title = make("h3", { id: "motion-title" });
  const detail = make("p", { className: "note", id: "motion-detail" });
  const play = make("button", { type: "button", id: "motion-play" });
  const views = make("fieldset", { className: "views" }, make("legend", { textContent: "Seen from" }));
  const radios = {};
  for (const [name, words] of Object.entries(VIEWS)) {
    const radio = (radios[name] = make("input", { type: "radio", name: "motion-view", value: name, id: `motion-${name}` }));
    radio.addEventListener("change", () => {
      view = name;
      setStage();
    });
    views.append(make("label", {}, radio, words));
  }
  const relative = make("input", { type: "checkbox", checked: true, id: "motion-relative" });
  relative.addEventListener("change", setStage);
  const tools = make(
    "div",
    { className: "motion-tools", role: "group", ariaLabel: "Motion" },
    play,
    views,
    make("label", { className: "toggle" }, relative, "all modes at true relative frequency"),
  );
  const paths = Object.fromEntries(
    ["shaft", "faint", "other", "hub", "arm", "face", "ribs", "edge", "nodes"].map((name) => [name, element("path", { class: name })]),
  );
  const root = element("g", { class: "root" });
  const spoke = element("g", {}, element("path", { d: "M0 0L0 -11" }), element("circle", { cx: 0, cy: -11, r: 2.5 }));
  const rotor = element(
    "g",
    { class: "rotor", transform: `translate(20 18)` },
    element("circle", { r: 11 }),
    spoke,
    element("text", { y: 23, "text-anchor": "middle" }, "rotor"),
  );
  const picture = element(
    "svg",
    { viewBox: `0 0 ${STAGE.width} ${STAGE.height}`, class: "stage", role: "img" },
    ...Object.values(paths),
    root,
    rotor,
  );
  const paceNote = make("p", { className: "note", id: "motion-pace" });
  const plotPlace = make("div", { className: "plot-place" });
  const nodeNote = make("p", { id: "motion-nodes" });
  const momentNote = make("p", { className: "key moment-key", id: "motion-moment" });
  const shapeNote = make("p", { className: "key shape-key", id: "motion-shape" });
  host.append(title, picture, tools, paceNote, shapeNote, momentNote, plotPlace, nodeNote, detail);
  host.hidden = true;

  const chosenMode = ({ modes, chosen }) => modeOf(modes?.modes ?? [], chosen);
  const shapeOf = (mode) => report?.value.shapes.find((shape) => nameOf(shape) === nameOf(mode)) ?? null;

  function showFrame() {
    if (stage === null) return;
    const share = Math.cos(2 * Math.PI * turns.mode);
    const { face, edge, ribs } = platePaths(stage.dof, stage.at, stage.motions, share, stage.project);
    paths.face.setAttribute("d", face);
    paths.edge.setAttribute("d", edge);
    paths.ribs.setAttribute("d", ribs);
    spoke.setAttribute("transform", `rotate(${(360 * turns.rotor).toFixed(1)})`);
  }

  function step(now) {
    frame = requestAnimationFrame(step);
    const passed = Math.min(LONGEST_S, (now - (last ?? now)) / 1000);
    last = now;
    if (now < yielding) return;
    for (const key of ["mode", "rotor"]) turns[key] = (turns[key] + passed * stage.pace[key]) % 1;
    showFrame();
  }

  /** Frames are asked for only while something is to be seen moving. */
  function run() {
    const runs = playing && seen && !document.hidden && !host.hidden && stage !== null && stage.pace.mode > 0;
    if (runs && frame === null) {
      last = null;
      frame = requestAnimationFrame(step);
    } else if (!runs && frame !== null) {
      cancelAnimationFrame(frame);
      frame = null;
    }
    host.dataset.runs = String(runs);
    host.dataset.pace = String(stage?.pace.mode ?? 0);
    play.textContent = playing ? "Pause" : "Play";
    paths.other.toggleAttribute("hidden", playing);
  }

  /** A blade at rest stands at an extreme; both are dashed while it does not move. */
  function rest() {
    turns = { mode: 0, rotor: 0 };
    showFrame();
  }

  function setStage() {
    const state = store.get();
    const mode = chosenMode(state);
    const shape = mode === null ? null : shapeOf(mode);
    if (shape === null) return;
    const { dof } = shape;
    const shown = view ?? bestView(mode);
    radios[shown].checked = true;
    const { r_m: radii, radius_m: radius } = report.value;
    const coarse = (values) => values.filter((_, i) => i % COARSE === 0 || i === values.length - 1);
    const ratio = radii.map((r) => r / radius);
    const motions = motionsDrawn(shape);
    const most = Math.abs(largest(ratio, leadingOf(shape).displacement)?.value ?? 1);
    const sizes = Object.fromEntries(Object.entries(motions).map(([motion, values]) => [motion, Math.max(...values.map(Math.abs))]));
    const project = camera(shown, dof, sizes);
    const even = !relative.checked;
    stage = {
      dof,
      at: coarse(ratio),
      motions: Object.fromEntries(Object.entries(motions).map(([motion, values]) => [motion, coarse(values)])),
      project,
      pace: pace({ frequency: mode.frequency_rad_s, speed: state.modes.speed_rad_s, nominal: state.fan?.nominal.speed_rad_s ?? 0 }, even),
    };
    const nodes = shape.nodes_m.map((r) => r / radius);
    host.dataset.dof = dof;
    host.dataset.view = shown;
    for (const [name, d] of Object.entries(hubPaths(ratio[0], project))) paths[name].setAttribute("d", d);
    paths.faint.setAttribute("d", platePaths(dof, stage.at, stage.motions, 0, project).face);
    paths.other.setAttribute("d", [1, -1].map((share) => platePaths(dof, stage.at, stage.motions, share, project).face).join(""));
    paths.nodes.setAttribute(
      "d",
      nodes
        .map(
          (node) =>
            `M${chordAt(dof, node, {})
              .map((point) =>
                project(point)
                  .map((v) => v.toFixed(1))
                  .join(" "),
              )
              .join("L")}`,
        )
        .join(""),
    );
    const { kind, at: place } = rootOf(state.blade, dof);
    root.replaceChildren(...rootMark(kind, project([place, 0, 0])));
    const where = `Mode ${mode.label}, ${motionsOf(mode.label).join(" and ")}`;
    const rootWords = `${kind} at r/R ${fieldNumber(place, 2)}`;
    picture.setAttribute(
      "aria-label",
      `${where}: the blade seen ${FROM[shown]}, ${rootWords}, swinging about its undeformed place. ${nodeWords(nodes)}. Deflection and chord are not to scale.`,
    );
    paceNote.textContent = paceWords(mode, stage.pace, even);
    if (!playing) rest();
    else showFrame();
    run();
    return { shape, mode, ratio, motions, nodes, most, rootWords };
  }

  function show() {
    const state = store.get();
    const staged = setStage();
    if (staged === undefined) return;
    const { shape, mode, ratio, motions, nodes, most, rootWords } = staged;
    const words = `${fieldNumber(shownSpeed(state.solvedSpeed, state))} ${state.speedUnit}`;
    title.textContent = `Mode ${mode.label} at ${words}`;
    detail.textContent = `${modeWords(mode, state.modes.classical_functions)}.`;
    nodeNote.textContent = `${nodeWords(nodes)}; ${rootWords}.`;
    const { moment: moments } = leadingOf(shape);
    const moment = largest(ratio, moments);
    const per = mode.dof === "torsion" ? "rad of twist" : "m of deflection";
    const kept = moment !== null && Math.abs(moment.value) > 0;
    const beside = Object.keys(motions).filter((motion) => motion !== mode.dof && isSeen(motions[motion]));
    shapeNote.textContent = `${mode.dof === "torsion" ? "twist" : "displacement"}, 1 at its largest${beside.length > 0 ? `; thin: ${beside.join(" and ")}, by energy` : ""}`;
    momentNote.textContent = kept
      ? `${MOMENTS[mode.dof]}, largest ${figures(Math.abs(moment.value) / most)} N·m per ${per} at r/R ${moment.at.toFixed(2)}`
      : `no ${MOMENTS[mode.dof]}`;
    const drawing = plot(mode.dof, motions, ratio, moments, nodes);
    drawing.setAttribute(
      "aria-label",
      `Shape of mode ${mode.label} along the span, with its ${MOMENTS[mode.dof]}. ${nodeWords(nodes)}. ${momentNote.textContent}.`,
    );
    plotPlace.replaceChildren(drawing);
  }

  async function ask() {
    const state = store.get();
    const mode = chosenMode(state);
    if (mode === null || state.blade === null) {
      host.hidden = true;
      run();
      return;
    }
    const { blade, modes } = state;
    // The motions of a coupled blade are solved together, and one answer has all.
    const dof = modes.model.kind === "coupled" ? null : [mode.dof];
    if (report?.modes !== modes || (dof !== null && report.dof !== mode.dof)) {
      const options = { ...optionsOf("shapes", { ...state, speed: state.solvedSpeed }), dof, points: POINTS };
      const result = await client.call("motion", "shapes", blade, options);
      if (result?.status !== "ok") return;
      if (store.get().modes !== modes) return; // newer ones are on their way
      report = { modes, dof: mode.dof, value: result.value };
    }
    host.hidden = false;
    show();
  }

  play.addEventListener("click", () => {
    playing = !playing;
    run();
  });
  document.addEventListener("visibilitychange", run);
  new IntersectionObserver((entries) => {
    seen = entries.at(-1).isIntersecting;
    run();
  }).observe(picture);
  still.addEventListener("change", () => {
    if (!still.matches) return;
    playing = false;
    rest();
    run();
  });
  store.subscribe((state, changed) => {
    const kind = chosenMode(state)?.dof;
    if (kind !== undefined && kind !== kindSeen) [kindSeen, view] = [kind, null];
    if (changed.has("modes") || changed.has("chosen")) {
      clearTimeout(settling);
      if (changed.has("chosen")) ask();
      else settling = setTimeout(ask, SETTLE_MS);
    }
    if (changed.has("whatIf") || changed.has("speed")) yielding = performance.now() + YIELD_MS;
    const nominal = state.fan?.nominal.speed_rad_s;
    if ((changed.has("speedUnit") || nominal !== nominalSeen) && report?.modes === state.modes) show();
    nominalSeen = nominal;
  });
  run();
}
