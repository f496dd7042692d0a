// The chart as text: a table of its numbers for those who cannot see it, or want to read them off.

import { at } from "../lib/dom.js";
import { closestOf, crossingWords, fieldNumber, figures, marginWords, perRevWords } from "../lib/format.js";
import { labelAt } from "../lib/labels.js";
import { shapeColumns } from "../lib/shape-columns.js";
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

/** Where branches of a coupled blade cross, or turn away from one another. */
function veeringsTable({ branches, veerings }, speedUnit, unit, { speed, frequency }) {
  return table(
    "Where branches cross, or veer away from one another",
    ["branches", "", `rotor speed [${speedUnit}]`, `frequency [${unit}]`, `gap [${unit}]`],
    veerings.map(({ branches: pair, kind, speed_rad_s: at, frequency_rad_s: mean, gap_rad_s: gap }) => [
      pair.map((branch) => labelAt(branches[branch], at)).join(", "),
      kind,
      speed(at),
      frequency(mean, at),
      frequency(gap, at),
    ]),
  );
}

function fanTables({ plots, report }) {
  const [{ x, y }] = plots;
  const speed = (value) => fieldNumber(inUnit(value, 0, x.unit));
  const frequency = (value, at) => figures(inUnit(value, at, y.unit));
  const { speeds_rad_s: speeds, branches, crossings, coincident, nominal, veerings = [] } = report;
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
    ...(veerings.length === 0 ? [] : [veeringsTable(report, x.unit, y.unit, { speed, frequency })]),
    table(
      `Frequencies [${y.unit}] over rotor speed`,
      [x.unit, ...branches.map(({ label }) => label)],
      speeds.map((at, i) => [speed(at), ...branches.map((branch) => frequency(branch.frequency_rad_s[i], at))]),
    ),
  ];
}

function shapesTables({ report }) {
  const { r_m: radii, shapes } = report;
  return shapeColumns(report).map(({ name, of }) =>
    table(
      `${name[0].toUpperCase()}${name.slice(1)} along the span`,
      ["r [m]", ...shapes.map(({ label }) => label)],
      radii.map((r, i) => [fieldNumber(r), ...shapes.map((shape) => figures(of(shape)[i]))]),
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
      series.map((one) => [one.label, figures(one.converged_rad_s), figures(one.lower_rad_s), figures(one.upper_rad_s)]),
    ),
    table(
      "The paper’s functions: frequency [rad/s] by their number",
      ["functions", ...labels],
      functions.map((count, i) => [String(count), ...series.map((one) => figures(one.classical_rad_s[i]))]),
    ),
    table(
      "Piecewise functions: number, and frequency [rad/s]",
      ["refinement", ...labels],
      Array.from({ length: most }, (_, i) => [
        String(i + 1),
        ...series.map((one) => (i < one.piecewise_functions.length ? `${one.piecewise_functions[i]}: ${figures(one.piecewise_rad_s[i])}` : "–")),
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
