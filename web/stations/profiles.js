// Small plots of the properties along the span, one each.

import { element, make } from "../lib/dom.js";
import { fieldNumber } from "../lib/format.js";
import { PROPERTIES, unitOfColumn } from "./columns.js";
import { curveOf } from "./forms.js";
import { formOf } from "./span.js";

const [WIDTH, HEIGHT, PAD] = [200, 72, 6];
/** Above this many points neighbours lie on the same pixels; the line is as good with fewer. */
const MOST_POINTS = 2_500;

const figure = (value) => fieldNumber(value, 4);

/** Points of a property as pairs; null where a value is no number. */
export function profilePoints(doc, id) {
  const form = formOf(doc, id);
  const radius = doc.rotor?.radius;
  if (form === "absent") return null;
  if (form === "number") {
    const value = doc.distribution[id];
    return typeof value === "number" && radius > 0
      ? [
          [0, value],
          [radius, value],
        ]
      : null;
  }
  const { r, values } = curveOf(doc, id);
  const points = r.slice(0, MOST_POINTS).map((x, i) => [x, values[i]]);
  return points.length > 0 && points.every((pair) => pair.every((value) => typeof value === "number")) ? points : null;
}

/** What a plot shows, for those who do not see it. */
export function profileWords(points, form, unit, lengthUnit) {
  const ys = points.map(([, y]) => y);
  const [least, most] = [Math.min(...ys), Math.max(...ys)];
  if (form === "number") return `${figure(ys[0])} ${unit} at all radii`;
  const steps = points.filter(([x, y], i) => i > 0 && x === points[i - 1][0] && y !== points[i - 1][1]).map(([x]) => figure(x));
  const ends = `from ${figure(ys[0])} ${unit} at r = ${figure(points[0][0])} ${lengthUnit} to ${figure(ys.at(-1))} at ${figure(points.at(-1)[0])}`;
  const range = least === most ? "" : `, between ${figure(least)} and ${figure(most)}`;
  const places = steps.length > 6 ? `${steps.length} steps` : steps.length === 1 ? `a step at r = ${steps[0]}` : `steps at r = ${steps.join(", ")}`;
  return `${ends}${range}${steps.length === 0 ? "" : `; ${places}`}`;
}

function valueAt(points, x) {
  const k = points.findIndex(([own], i) => own >= x && i > 0);
  if (k < 0 || x < points[0][0]) return null;
  const [[x0, y0], [x1, y1]] = [points[k - 1], points[k]];
  return x1 === x0 ? y1 : y0 + ((y1 - y0) * (x - x0)) / (x1 - x0);
}

/** One plot: its line, a line of zero, and where the selected station lies. */
function plot(points, radius, mark, words) {
  const ys = points.map(([, y]) => y);
  const [low, high] = [Math.min(0, ...ys), Math.max(0, ...ys)];
  const end = Math.max(radius > 0 ? radius : 0, ...points.map(([x]) => x)) || 1;
  const x = (value) => (PAD + (value / end) * (WIDTH - 2 * PAD)).toFixed(1);
  const y = (value) => (HEIGHT - PAD - ((value - low) / (high - low || 1)) * (HEIGHT - 2 * PAD)).toFixed(1);
  const svg = element("svg", { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, role: "img", "aria-label": words, preserveAspectRatio: "none" });
  const thin = { stroke: "currentColor", "stroke-width": 1, "vector-effect": "non-scaling-stroke" };
  svg.append(element("line", { x1: PAD, x2: WIDTH - PAD, y1: y(0), y2: y(0), ...thin, "stroke-opacity": 0.4 }));
  if (mark !== null)
    svg.append(element("line", { class: "station", x1: x(mark), x2: x(mark), y1: 0, y2: HEIGHT, ...thin, "stroke-dasharray": "3 2" }));
  svg.append(
    element("polyline", {
      points: points.map(([a, b]) => `${x(a)},${y(b)}`).join(" "),
      fill: "none",
      ...thin,
      "stroke-width": 1.75,
      "stroke-linejoin": "round",
    }),
  );
  const value = mark === null ? null : valueAt(points, mark);
  if (value !== null)
    svg.append(element("path", { class: "station", d: `M${x(mark)},${y(value)}h0`, ...thin, "stroke-width": 7, "stroke-linecap": "round" }));
  return svg;
}

/** Draws all properties; `mark` is the radius of the selected station, or null. */
export function showProfiles(host, doc, mark) {
  const radius = doc.rotor?.radius;
  host.replaceChildren(
    ...PROPERTIES.filter(({ id }) => formOf(doc, id) !== "absent").map(({ id, name }) => {
      const points = profilePoints(doc, id);
      const unit = unitOfColumn(id, doc.units);
      const length = unitOfColumn("r", doc.units);
      const words = points === null ? "not drawn: a value or radius is no number" : profileWords(points, formOf(doc, id), unit, length);
      const title = make("figcaption", { textContent: `${name} ` }, make("span", { className: "unit", textContent: unit }));
      if (points === null) return make("figure", { dataset: { property: id } }, title, make("p", { className: "note", textContent: words }));
      const ys = points.map(([, y]) => y);
      const range = make("p", {
        className: "note",
        aria: { hidden: "true" },
        textContent: Math.min(...ys) === Math.max(...ys) ? figure(ys[0]) : `${figure(Math.min(...ys))} … ${figure(Math.max(...ys))}`,
      });
      const inside = typeof mark === "number" && mark >= 0 ? mark : null;
      const station = inside === null ? null : valueAt(points, inside);
      const chosen = station === null ? "" : `; at the selected r = ${figure(inside)}: ${figure(station)}`;
      return make("figure", { dataset: { property: id } }, title, plot(points, radius, inside, `${name} along the span: ${words}${chosen}`), range);
    }),
  );
}
