// The chosen mode: its shape along the span, its moment, and the blade in motion.

import { at, element, make } from "../lib/dom.js";
import { boundsWords, fieldNumber, figures, marginWords, paperWords, perRevWords } from "../lib/format.js";
import { shownSpeed } from "../lib/speed-words.js";
import { optionsOf } from "../solver/keep-up.js";
import { STAGE, camera, chordAt, hubPaths, platePaths } from "./plate.js";
import { largest, nodeWords, pace } from "./shape.js";

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

/** The chosen mode in one line, with what the table has no room for. */
export function modeWords(mode, functions) {
  const parts = [`${figures(mode.frequency_rad_s)} rad/s`, `${figures(mode.frequency_hz)} Hz`];
  if (mode.per_rev !== null) parts.push(`${perRevWords(mode.per_rev)}/rev, ${marginWords(mode)}`);
  parts.push(`bounds ${boundsWords(mode, " rad/s")}`);
  if (mode.classical_rad_s !== null) parts.push(`the paper’s ${functions} functions ${figures(mode.classical_rad_s)} rad/s, ${paperWords(mode)}`);
  return parts.join("; ");
}

/** "33 times slower than real". */
export function slowerWords(slower) {
  if (slower >= 0.95 && slower < 1.05) return "as fast as real";
  const times = slower >= 1 ? slower : 1 / slower;
  return `${times >= 10 ? times.toFixed(0) : fieldNumber(times, 2)} times ${slower >= 1 ? "slower" : "faster"} than real`;
}

/** Displacement and moment along the span. */
function plot(shape, ratio, moments, nodes) {
  const [width, height] = [400, 150];
  const frame = { left: 26, right: 388, top: 10, bottom: 122 };
  const x = (r) => frame.left + r * (frame.right - frame.left);
  const y = (value) => (frame.top + frame.bottom) / 2 - 0.92 * value * ((frame.bottom - frame.top) / 2);
  const line = (values, scale) => values.map((value, i) => `${i === 0 ? "M" : "L"}${x(ratio[i]).toFixed(1)} ${y(value / scale).toFixed(1)}`).join("");
  const svg = element("svg", { viewBox: `0 0 ${width} ${height}`, class: "shape-plot", role: "img" });
  for (const r of [0, 0.2, 0.4, 0.6, 0.8, 1]) {
    svg.append(
      element("path", { class: "grid", d: `M${x(r)} ${frame.top}V${frame.bottom}` }),
      element("text", { x: x(r), y: frame.bottom + 13, "text-anchor": "middle" }, r === 0 ? "0" : r.toFixed(1)),
    );
  }
  for (const value of [-1, 0, 1]) {
    svg.append(
      element("path", { class: value === 0 ? "zero" : "grid", d: `M${frame.left} ${y(value)}H${frame.right}` }),
      element("text", { x: frame.left - 4, y: y(value) + 3.5, "text-anchor": "end" }, String(value).replace("-", "−")),
    );
  }
  svg.append(element("text", { x: (frame.left + frame.right) / 2, y: height - 3, "text-anchor": "middle" }, "span r/R"));
  const most = largest(ratio, moments);
  if (most !== null) svg.append(element("path", { class: "moment", d: line(moments, Math.abs(most.value)) }));
  svg.append(element("path", { class: "displacement", d: line(shape, 1) }));
  for (const node of nodes) svg.append(element("circle", { class: "node", cx: x(node).toFixed(1), cy: y(0), r: 3.5 }));
  return svg;
}

/** Shows the chosen mode from now on. */
export function startMotion(store, client) {
  const host = at("motion");
  const still = matchMedia("(prefers-reduced-motion: reduce)");
  let playing = !still.matches;
  let seen = true; // on screen
  let view = null; // null: the best for the mode
  let dofSeen = null; // a view that was chosen holds for modes of the same kind
  let frame = null;
  let last = null;
  let turns = { mode: 0, rotor: 0 };
  let report = null;
  let yielding = 0;
  let nominalSeen;
  let settling;
  let stage = null; // what the frames need: {dof, at, shape, project, pace}

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

  const chosenShape = (state) => report?.value.shapes.find((shape) => shape.label === state.chosen) ?? null;
  const chosenMode = ({ modes, chosen }) => modes?.modes.find((mode) => mode.label === chosen) ?? null;

  function showFrame() {
    if (stage === null) return;
    const share = Math.cos(2 * Math.PI * turns.mode);
    const { face, edge, ribs } = platePaths(stage.dof, stage.at, stage.shape, share, stage.project);
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
    const shape = chosenShape(state);
    const mode = chosenMode(state);
    if (shape === null || mode === null) return;
    const { dof } = shape;
    const shown = view ?? BEST[dof];
    radios[shown].checked = true;
    const { r_m: radii, radius_m: radius } = report.value;
    const coarse = (values) => values.filter((_, i) => i % COARSE === 0 || i === values.length - 1);
    const ratio = radii.map((r) => r / radius);
    const most = Math.abs(largest(ratio, shape.displacement)?.value ?? 1);
    const unit = shape.displacement.map((w) => w / most);
    const project = camera(shown, dof);
    const even = !relative.checked;
    stage = {
      dof,
      at: coarse(ratio),
      shape: coarse(unit),
      project,
      pace: pace({ frequency: mode.frequency_rad_s, speed: state.modes.speed_rad_s, nominal: state.fan?.nominal.speed_rad_s ?? 0 }, even),
    };
    const nodes = shape.nodes_m.map((r) => r / radius);
    host.dataset.dof = dof;
    host.dataset.view = shown;
    for (const [name, d] of Object.entries(hubPaths(ratio[0], project))) paths[name].setAttribute("d", d);
    paths.faint.setAttribute("d", platePaths(dof, stage.at, stage.shape, 0, project).face);
    paths.other.setAttribute("d", [1, -1].map((share) => platePaths(dof, stage.at, stage.shape, share, project).face).join(""));
    paths.nodes.setAttribute(
      "d",
      nodes
        .map(
          (node) =>
            `M${chordAt(dof, node, 0)
              .map((point) =>
                project(point)
                  .map((v) => v.toFixed(1))
                  .join(" "),
              )
              .join("L")}`,
        )
        .join(""),
    );
    root.replaceChildren(...rootMark(state.blade[dof]?.root, project([ratio[0], 0, 0])));
    const where = `Mode ${mode.label}, ${dof}`;
    const rootWords = `${state.blade[dof]?.root} at r/R ${fieldNumber(ratio[0], 2)}`;
    picture.setAttribute(
      "aria-label",
      `${where}: the blade seen ${FROM[shown]}, ${rootWords}, swinging about its undeformed place. ${nodeWords(nodes)}. Deflection and chord are not to scale.`,
    );
    paceNote.textContent = paceWords(mode, state, stage.pace, even);
    if (!playing) rest();
    else showFrame();
    run();
    return { shape, mode, ratio, unit, nodes, most, rootWords };
  }

  function paceWords(mode, state, { mode: hertz, slower, held }, even) {
    if (hertz === 0) return "This mode has no frequency here: the blade turns freely about its hinge.";
    const words = [`Deflection not to scale; ${slowerWords(slower)}${held && !even ? ", slowed further to be seen" : ""}.`];
    if (mode.per_rev !== null) words.push(`${fieldNumber(mode.per_rev, 3)} swings per revolution.`);
    return words.join(" ");
  }

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

  function show() {
    const state = store.get();
    const staged = setStage();
    if (staged === undefined) return;
    const { shape, mode, ratio, unit, nodes, most, rootWords } = staged;
    const words = `${fieldNumber(shownSpeed(state.solvedSpeed, state))} ${state.speedUnit}`;
    title.textContent = `Mode ${mode.label} at ${words}`;
    detail.textContent = `${modeWords(mode, state.modes.classical_functions)}.`;
    nodeNote.textContent = `${nodeWords(nodes)}; ${rootWords}.`;
    const moment = largest(ratio, shape.moment);
    const per = mode.dof === "torsion" ? "rad of twist" : "m of deflection";
    const kept = moment !== null && Math.abs(moment.value) > 0;
    shapeNote.textContent = mode.dof === "torsion" ? "twist, 1 at its largest" : "displacement, 1 at its largest";
    momentNote.textContent = kept
      ? `${MOMENTS[mode.dof]}, largest ${figures(Math.abs(moment.value) / most)} N·m per ${per} at r/R ${moment.at.toFixed(2)}`
      : `no ${MOMENTS[mode.dof]}`;
    const drawing = plot(unit, ratio, shape.moment, nodes);
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
    if (report?.modes !== modes || report.dof !== mode.dof) {
      const options = { ...optionsOf("shapes", { ...state, speed: state.solvedSpeed }), dof: [mode.dof], points: POINTS };
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
    if (kind !== undefined && kind !== dofSeen) [dofSeen, view] = [kind, null];
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
