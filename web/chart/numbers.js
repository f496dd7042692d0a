// The chart as text: a table of its numbers for those who cannot see it, or want to read them off.

import { at } from "../lib/dom.js";
import { closestOf, crossingWords, fieldNumber, figures, marginWords, perRevWords } from "../lib/format.js";
import { inUnit } from "./frame.js";

const WAIT_MS = 250;

const cell = (name, text) => Object.assign(document.createElement(name), { textContent: text });

function table(caption, header, rows) {
  const made = document.createElement("table");
  const head = document.createElement("tr");
  head.append(...header.map((text) => Object.assign(cell("th", text), { scope: "col" })));
  const thead = document.createElement("thead");
  thead.append(head);
  const body = document.createElement("tbody");
  for (const [first, ...rest] of rows) {
    const row = document.createElement("tr");
    row.append(Object.assign(cell("th", first), { scope: "row" }), ...rest.map((text) => cell("td", text)));
    body.append(row);
  }
  made.append(cell("caption", caption), thead, body);
  return made;
}

const shown = (value) => (value === null || !Number.isFinite(value) ? "–" : figures(value));

function fanTables({ plots, report }) {
  const [{ x, y }] = plots;
  const speed = (value) => fieldNumber(inUnit(value, 0, x.unit));
  const frequency = (value, at) => shown(inUnit(value, at, y.unit));
  const { speeds_rad_s: speeds, branches, crossings, coincident, nominal } = report;
  return [
    table(
      `Distances to the nearest harmonic at nominal speed, ${speed(nominal.speed_rad_s)} ${x.unit}`,
      ["branch", "/rev", "nearest harmonic"],
      nominal.margins.map((margin) => [margin.label, perRevWords(margin.per_rev), marginWords(margin, "/rev")]),
    ),
    table(
      `Crossings with harmonics up to ${report.harmonics}P`,
      ["crossing", `rotor speed [${x.unit}]`, `frequency [${y.unit}]`],
      [
        ...coincident.map((coincidence) => [crossingWords(coincidence), "every speed", "–"]),
        ...crossings.map((crossing) => [
          crossingWords(crossing),
          speed(crossing.speed_rad_s),
          frequency(crossing.frequency_rad_s, crossing.speed_rad_s),
        ]),
      ],
    ),
    table(
      `Frequencies [${y.unit}] over rotor speed`,
      [x.unit, ...branches.map(({ label }) => label)],
      speeds.map((at, i) => [speed(at), ...branches.map((branch) => frequency(branch.frequency_rad_s[i], at))]),
    ),
  ];
}

function shapesTables({ report }) {
  const { r_m: radii, shapes } = report;
  const quantities = { displacement: "Displacement", slope: "Slope [1/m]", moment: "Moment [N·m]" };
  return Object.entries(quantities).map(([key, name]) =>
    table(
      `${name} along the span`,
      ["r [m]", ...shapes.map(({ label }) => label)],
      radii.map((r, i) => [fieldNumber(r), ...shapes.map((shape) => shown(shape[key][i]))]),
    ),
  );
}

function convergeTables({ report }) {
  const { functions, series } = report;
  const labels = series.map(({ label }) => label);
  const most = Math.max(0, ...series.map((one) => one.piecewise_functions.length));
  return [
    table(
      "Converged frequency and its bounds [rad/s]",
      ["mode", "converged", "lower bound", "upper bound"],
      series.map((one) => [one.label, shown(one.converged_rad_s), shown(one.lower_rad_s), shown(one.upper_rad_s)]),
    ),
    table(
      "The paper’s functions: frequency [rad/s] by their number",
      ["functions", ...labels],
      functions.map((count, i) => [String(count), ...series.map((one) => shown(one.classical_rad_s[i]))]),
    ),
    table(
      "Piecewise functions: number, and frequency [rad/s]",
      ["refinement", ...labels],
      Array.from({ length: most }, (_, i) => [
        String(i + 1),
        ...series.map((one) => (i < one.piecewise_functions.length ? `${one.piecewise_functions[i]}: ${shown(one.piecewise_rad_s[i])}` : "–")),
      ]),
    ),
  ];
}

const TABLES = { fan: fanTables, shapes: shapesTables, converge: convergeTables };

/** One sentence on what a chart shows. */
export function summary({ kind, report }) {
  if (kind === "shapes") return `Shapes of ${report.shapes.length} modes at ${fieldNumber(inUnit(report.speed_rad_s, 0, "rpm"))} rpm.`;
  if (kind === "converge") {
    const { series } = report;
    return `Frequencies of ${series.length} modes by the number of functions, at ${fieldNumber(inUnit(report.speed_rad_s, 0, "rpm"))} rpm.`;
  }
  const { branches, nominal, harmonics } = report;
  const closest = closestOf(nominal.margins, harmonics);
  const count = `${branches.length} ${branches.length === 1 ? "branch" : "branches"}`;
  if (closest === null) return `${count}, none near a harmonic up to ${harmonics}P at nominal speed.`;
  return `${count}; at nominal speed ${closest.label} is closest to a harmonic, ${marginWords(closest, "/rev")}.`;
}

/** Fills the disclosure while it is open, a moment after the last change. */
export function startNumbers(store) {
  const host = at("chart-data");
  const place = host.querySelector(".scroll");
  let waiting;
  let filled = null;

  function fill() {
    const { drawing } = store.get();
    if (!host.open || drawing === null || drawing === filled) return;
    filled = drawing;
    place.replaceChildren(...TABLES[drawing.kind](drawing));
  }

  host.addEventListener("toggle", () => {
    if (host.open) fill();
    else {
      filled = null;
      place.replaceChildren();
    }
  });
  store.subscribe((_, changed) => {
    if (!changed.has("drawing") || !host.open) return;
    clearTimeout(waiting);
    waiting = setTimeout(fill, WAIT_MS);
  });
}
