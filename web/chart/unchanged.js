// The blade as it is, faintly behind the branches of the changed one.

import { at, element } from "../lib/dom.js";
import { inUnit } from "./frame.js";

/** Higher than any axis: a path may not grow without end towards rest. */
const HIGHEST = 1e5;

/** A branch in the units of the axes: it stays while the frame is scaled and moved. */
function path({ speedUnit, unit }, before, branch) {
  let line = "";
  let pen = "M";
  branch.frequency_rad_s.forEach((frequency, i) => {
    const speed = before.speeds_rad_s[i];
    const value = inUnit(frequency, speed, unit);
    // Nothing per revolution at rest, and a gap where the blade is unstable.
    if (Number.isNaN(value)) {
      pen = "M";
      return;
    }
    line += `${pen}${inUnit(speed, 0, speedUnit).toPrecision(6)} ${Math.min(HIGHEST, value).toPrecision(6)}`;
    pen = "L";
  });
  return line;
}

/** Draws `before` of the state whenever it, or the drawing, is another. */
export function startUnchanged(chart, store) {
  const { before: layer } = chart.layers;
  const note = Object.assign(document.createElement("p"), {
    className: "note before-note",
    hidden: true,
    textContent: "Thin faint lines: the blade without the changes of “What if”.",
  });
  at("band-note").after(note);
  // The layer is clipped to the frame, the group in it scaled.
  const group = element("g", {});
  layer.append(group);
  let drawn = {};

  function show() {
    const { before, dofs } = store.get();
    const { frame } = chart;
    const shown = frame !== null && before !== null;
    note.hidden = !shown;
    if (!shown) {
      if (drawn.before) group.replaceChildren();
      drawn = {};
      return;
    }
    const { x, y, left, width, height } = frame.plot;
    const scale = [width / (x.to - x.from), -height / (y.to - y.from)];
    group.setAttribute("transform", `matrix(${scale[0]} 0 0 ${scale[1]} ${left - scale[0] * x.from} ${frame.bottom - scale[1] * y.from})`);
    if (drawn.before === before && drawn.dofs === dofs && drawn.units === x.unit + y.unit) return;
    drawn = { before, dofs, units: x.unit + y.unit };
    const branches = before.branches.filter(({ dof }) => dofs.includes(dof));
    group.replaceChildren(
      ...branches.map((branch) => element("path", { d: path(frame, before, branch), "data-dof": branch.dof, "data-label": branch.label })),
    );
  }

  chart.onShow(show);
  store.subscribe((_, changed) => changed.has("before") && show());
}
