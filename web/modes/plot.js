// The shape of a mode along the span, drawn.

import { element } from "../lib/dom.js";
import { largest } from "./shape.js";

/** Smaller motions lie on the axis. */
const LEAST = 0.02;
export const isSeen = (values) => values.some((value) => Math.abs(value) > LEAST);

/** The motions of a mode along the span, one of which leads, with its moments and nodes. */
export function plot(dof, motions, ratio, moments, nodes) {
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
  for (const [motion, values] of Object.entries(motions)) {
    if (motion !== dof && isSeen(values)) svg.append(element("path", { class: "beside", d: line(values, 1), "data-dof": motion }));
  }
  svg.append(element("path", { class: "displacement", d: line(motions[dof], 1) }));
  for (const node of nodes) svg.append(element("circle", { class: "node", cx: x(node).toFixed(1), cy: y(0), r: 3.5 }));
  return svg;
}
