// The report: one printed page on the blade, its chart and its numbers. Made when it is asked for.

import { at } from "../lib/dom.js";
import { DOFS } from "../lib/dof-toggles.js";
import {
  basisWords,
  boundsWords,
  crossingWords,
  crossingsWithin,
  fieldNumber,
  figures,
  frequencyWords,
  marginWords,
  paperWords,
  perRevWords,
  shareFigure,
} from "../lib/format.js";
import { isNeutral } from "../lib/what-if.js";
import { unitFactor } from "../lib/speed-words.js";
import { parsedSvg } from "../lib/trusted.js";
import { unitOf } from "../lib/unit-words.js";
import { nearModes, nearNote, nearness } from "../modes/nearness.js";
import { looksOf } from "../solver/keep-up.js";

/** So much fits the page: rows of tables, letters of texts. Modes and crossings share `beside`, the chart's height; with stations, they share `all`. */
const MOST = { stations: 40, modes: 20, beside: 27, all: 55, notes: 240, name: 50, warnings: 3 };
/** More modes than this are a long table: crossings go below the chart, and there are fewer stations. */
const LONG = { modes: 15, stations: 26 };
/** The chart is drawn for its place on the page, so that its letters are as large as the others. */
const CHART_WIDTH = 520;
/** Before a print that the page is not told of early enough, the chart is drawn when nothing else is asked for. */
const IDLE_MS = 1_500;
const NAMES = {
  mass: ["mass", "mass"],
  flap_stiffness: ["flap EI", "stiffness"],
  lag_stiffness: ["lag EI", "stiffness"],
  torsion_stiffness: ["GJ", "stiffness"],
  polar_inertia: ["polar inertia", "inertia"],
  flap_inertia: ["flap inertia", "inertia"],
  lag_inertia: ["lag inertia", "inertia"],
  mass_offset: ["mass offset", "length"],
  twist: ["twist", "angle"],
  tension_offset: ["tension offset", "length"],
  axial_stiffness: ["EA", "force"],
  trapeze_radius: ["trapeze radius", "length"],
};

/** What a slider scales, where that is more than its name says. */
const SCALED = { mass: "mass and polar inertia" };

const make = (tag, text = "", className = "") => Object.assign(document.createElement(tag), { textContent: text, className });
const number = (value) => (typeof value === "number" ? fieldNumber(value, 6).replace("-", "−") : String(value ?? ""));

function table(caption, head, rows) {
  const made = make("table");
  made.append(make("caption", caption));
  const thead = made.createTHead().insertRow();
  for (const text of head) thead.append(Object.assign(make("th", text), { scope: "col" }));
  const body = made.createTBody();
  for (const row of rows) {
    const line = body.insertRow();
    for (const text of row) line.append(make("td", text));
  }
  return made;
}

/** Cut at a word, with an ellipsis, where a text is longer than `most`. */
export function shortened(text, most) {
  const plain = text.replace(/\s+/g, " ").trim();
  if (plain.length <= most) return plain;
  const cut = plain.slice(0, most);
  return `${cut.slice(0, Math.max(cut.lastIndexOf(" "), most / 2))} …`;
}

/**
 * The properties along the span as columns of a table: a radius before each run of properties that
 * share their radii. What is constant along the span is named once, not repeated.
 */
export function stationColumns({ distribution, units }) {
  const length = unitOf("length", units);
  const columns = [];
  const constants = [];
  let radii = null;
  for (const property of Object.keys(NAMES)) {
    const given = distribution[property];
    if (given === undefined) continue;
    const [name, kind] = NAMES[property];
    const unit = unitOf(kind, units);
    if (typeof given === "number") {
      constants.push(`${name} ${number(given)} ${unit}`);
      continue;
    }
    const [r, values] = Array.isArray(given) ? [distribution.r ?? [], given] : [given.r, given.values];
    if (radii === null || r.join() !== radii.join()) {
      columns.push({ head: `r [${length}]`, values: r });
      radii = r;
    }
    columns.push({ head: `${name} [${unit}]`, values });
  }
  return { columns, constants, count: Math.max(0, ...columns.map(({ values }) => values.length)) };
}

function stations(blade, most) {
  const { columns, constants, count } = stationColumns(blade);
  const parts = [];
  if (count > 0) {
    const shown = Math.min(count, most);
    const rows = Array.from({ length: shown }, (_, i) => columns.map(({ values }) => number(values[i])));
    parts.push(
      table(
        "Properties along the span",
        columns.map(({ head }) => head),
        rows,
      ),
    );
    if (count > shown) parts.push(make("p", `The first ${shown} of ${count} stations.`));
  }
  if (constants.length > 0) parts.push(make("p", `Along the whole span: ${constants.join("; ")}.`));
  return parts;
}

/** What the what-if sliders change, in words. */
export function whatIfWords({ factors, from, to, offsets, springs, length: unit }, units) {
  const times = (table, name) =>
    Object.entries(table)
      .filter(([, factor]) => factor !== 1)
      .map(([key, factor]) => `${name(key)} × ${fieldNumber(factor, 4)}`);
  const length = unit ?? unitOf("length", units);
  const scaledWords = times(factors, (key) => SCALED[key] ?? key.replace("_", " "));
  if (scaledWords.length > 0 && (from !== null || to !== null))
    scaledWords.push(`from ${from === null ? "root" : number(from)} to ${to === null ? "tip" : `${number(to)} ${length}`}`);
  return [
    ...scaledWords,
    ...Object.entries(offsets).map(([dof, offset]) => `${dof} offset ${number(offset)} ${length}`),
    ...times(springs, (dof) => `${dof} spring`),
  ].join(", ");
}

function rotor({ rotor, units, ...blade }) {
  const { length, speed } = Object.fromEntries(["length", "speed"].map((kind) => [kind, unitOf(kind, units)]));
  const words = [`radius ${number(rotor.radius)} ${length}`, `nominal speed ${number(rotor.nominal_speed)} ${speed}`];
  if (rotor.blades) words.push(`${rotor.blades} blades`);
  const roots = DOFS.map((dof) => {
    const { root, offset, offset_ratio: ratio, spring } = blade[dof];
    const place = ratio !== undefined ? `${number(ratio)} R` : `${number(offset ?? 0)} ${length}`;
    return `${dof} ${root} at ${place}${spring ? `, ${number(spring)} ${unitOf("spring", units)}` : ""}`;
  });
  return `Rotor: ${words.join(", ")}. Roots: ${roots.join("; ")}.`;
}

/** "26, 21, 52", the shares of a mode's energy in percent. */
const shareFigures = (shares) => DOFS.map((dof) => shareFigure(shares[dof])).join(", ");

function frequencies({ modes, fan }) {
  const harmonics = fan?.harmonics;
  const { modes: all, model } = modes;
  const isCoupled = model.kind === "coupled";
  // Of many, the lowest: of each kind, where each stands on its own.
  const kinds = new Set(all.map(({ dof }) => dof)).size;
  const isShown = ({ number }, i) => (isCoupled ? i < MOST.modes : number <= MOST.modes / kinds);
  const shown = all.length <= MOST.modes ? all : all.filter(isShown);
  const rows = shown.map((mode) => {
    const near = nearness(mode, harmonics);
    return [
      mode.label,
      ...(isCoupled ? [shareFigures(mode.shares)] : []),
      frequencyWords(mode),
      figures(mode.frequency_hz),
      perRevWords(mode.per_rev),
      boundsWords(mode),
      mode.classical_rad_s === null ? "–" : figures(mode.classical_rad_s),
      paperWords(mode),
      `${marginWords(mode)}${near ? `, ${near}` : ""}`,
    ];
  });
  const parts = [
    table(
      "Frequencies",
      [
        "mode",
        ...(isCoupled ? ["F, L, T %"] : []),
        "rad/s",
        "Hz",
        "/rev",
        "bounds [rad/s]",
        `paper N=${modes.classical_functions}`,
        "",
        "nearest harmonic",
      ],
      rows,
    ),
  ];
  if (shown.length < all.length) parts.push(make("p", `The lowest ${shown.length} of ${all.length} modes.`));
  if (harmonics !== undefined && nearModes(modes.modes, harmonics).length > 0) parts.push(make("p", nearNote(harmonics)));
  return parts;
}

function crossings(state) {
  const { fan, band, speedUnit } = state;
  if (fan === null) return [];
  const nominal = fan.nominal.speed_rad_s;
  const inBand = crossingsWithin(fan, band);
  const words = `${band[0]} to ${band[1]} of nominal speed`;
  if (inBand.length === 0) return [make("p", `No crossing with harmonics up to ${fan.harmonics}P between ${words}.`)];
  const factor = unitFactor(state, speedUnit);
  const shown = inBand.slice(0, MOST.beside - Math.min(MOST.modes, state.modes.modes.length));
  const rows = shown.map((crossing) => [
    crossingWords(crossing),
    fieldNumber(crossing.speed_rad_s / factor, 4),
    (crossing.speed_rad_s / nominal).toFixed(3),
    figures(crossing.frequency_rad_s),
  ]);
  const parts = [table(`Crossings, ${words}`, ["", speedUnit, "of nominal", "rad/s"], rows)];
  if (shown.length < inBand.length) parts.push(make("p", `The first ${shown.length} of ${inBand.length} crossings.`));
  return parts;
}

/** Makes the report and prints it; `print` of the Save menu and Ctrl+P give the same. */
export function startReport(store, client) {
  const place = at("report");
  let kept = null; // {key, drawing}: the chart as the report has it
  let newest = null; // the last fan chart of the page, for want of that
  let waiting;

  const looks = (state) => ({ ...looksOf("fan", state), theme: "light", width: CHART_WIDTH, height: undefined });
  const keyOf = ({ blade, model, options, speedUnit, frequencyUnit, dofs, band, window, measured }) => [
    blade,
    model,
    options,
    speedUnit,
    frequencyUnit,
    dofs,
    band,
    window,
    measured,
  ];
  const isKept = (state) => kept !== null && keyOf(state).every((value, i) => value === kept.key[i]);

  async function drawChart() {
    const state = store.get();
    if (state.blade === null || isKept(state)) return;
    const result = await client.call("report", "chart_svg", "fan", state.blade, looks(state));
    if (result?.status === "ok") kept = { key: keyOf(state), drawing: result.value };
  }

  function chart(state) {
    const drawing = isKept(state) ? kept.drawing : newest;
    if (drawing === null) return [];
    const svg = document.importNode(parsedSvg(drawing.svg).documentElement, true);
    svg.removeAttribute("width");
    svg.removeAttribute("height");
    svg.setAttribute("role", "img");
    svg.setAttribute("aria-label", "Fan chart");
    const figure = make("div", "", "report-chart");
    figure.append(svg);
    return [figure];
  }

  function build() {
    const state = store.get();
    const { blade, modes, about, warnings, whatIf, solvedSpeed, speedUnit } = state;
    place.replaceChildren();
    if (blade === null || modes === null) return;
    const speed = `${fieldNumber(modes.speed_rad_s / unitFactor(state, speedUnit))} ${speedUnit}${solvedSpeed === null ? ", nominal" : ""}`;
    const head = make("header");
    head.append(make("h1", shortened(modes.blade, MOST.name)), make("p", `Natural frequencies of the rotating blade at ${speed}`, "lead"));
    const source = [blade.source?.quality && `${blade.source.quality} data`, blade.source?.citation].filter(Boolean).join(": ");
    const about_blade = make("div", "", "report-about");
    if (source !== "") about_blade.append(make("p", `Source: ${shortened(source, MOST.notes)}`));
    if (blade.notes) about_blade.append(make("p", `Notes: ${shortened(blade.notes, MOST.notes)}`));
    about_blade.append(make("p", rotor(blade)));
    if (!isNeutral(whatIf)) about_blade.append(make("p", `What if, already in these numbers: ${whatIfWords(whatIf, blade.units)}.`));
    for (const warning of warnings.slice(0, MOST.warnings)) about_blade.append(make("p", `Warning: ${warning.path}: ${warning.message}`));
    const columns = make("div", "", "report-columns");
    const [left, right] = [make("div"), make("div")];
    const long = modes.modes.length > LONG.modes;
    left.append(...chart(state));
    right.append(...frequencies(state));
    (long ? left : right).append(...crossings(state));
    columns.append(left, right);
    const method = make("div", "", "report-method");
    const basis = modes.basis.family === "classical" ? "the paper’s assumed functions" : "piecewise assumed functions, as many as it takes";
    method.append(
      make(
        "p",
        `Method: the assumed-mode method with ${basis} (${basisWords(modes.basis)}); ${modes.model.words}. Each frequency lies between its bounds where they are given; “paper” is the same method with ${modes.classical_functions} of the paper’s functions and its difference from the converged frequency.`,
      ),
      make(
        "p",
        `bladefan ${about.version}, ${new Intl.DateTimeFormat("en-GB", { dateStyle: "long" }).format(new Date())}, ${location.origin}${location.pathname}`,
      ),
    );
    const spanwise = make("div", "", "report-stations");
    const taken = columns.querySelectorAll("tbody tr").length;
    spanwise.append(...stations(blade, long ? LONG.stations : Math.min(MOST.stations, MOST.all - taken)));
    place.append(head, about_blade, columns, spanwise, method);
  }

  async function printReport() {
    await drawChart();
    print();
  }

  at("print").addEventListener("click", () => {
    at("download").open = false;
    printReport();
  });
  addEventListener("keydown", (event) => {
    if (!(event.ctrlKey || event.metaKey) || event.altKey || event.shiftKey || event.key.toLowerCase() !== "p") return;
    event.preventDefault();
    printReport();
  });
  // The browser's own menu comes here first, and cannot wait.
  addEventListener("beforeprint", () => {
    build();
    place.hidden = false;
  });
  addEventListener("afterprint", () => {
    place.hidden = true;
    place.replaceChildren();
  });
  store.subscribe((state, changed) => {
    if (changed.has("drawing") && state.drawing?.kind === "fan") newest = state.drawing;
    clearTimeout(waiting);
    // In light colours the page's own chart will do.
    if (state.theme === "dark" && state.blade !== null && !isKept(state)) waiting = setTimeout(drawChart, IDLE_MS);
  });
}
