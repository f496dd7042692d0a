// The frequency table at one rotor speed. Its rows are the choice of a mode.

import { targetOf, write } from "../lib/dom.js";
import { boundsWords, closestOf, figures, frequencyWords, marginWords, paperWords, perRevWords } from "../lib/format.js";
import { modeOf, nameOf } from "../lib/labels.js";
import { nearness } from "./nearness.js";
import { showShares } from "./shares.js";

function newRow(mode, onChoose) {
  const row = document.createElement("tr");
  const name = nameOf(mode);
  Object.assign(row.dataset, { name, dof: mode.dof });
  const head = document.createElement("th");
  head.scope = "row";
  // Radio buttons: one stop of the tab key, arrows from mode to mode.
  const radio = document.createElement("input");
  radio.type = "radio";
  radio.name = "mode";
  radio.value = name;
  radio.addEventListener("change", () => onChoose(name));
  const label = document.createElement("label");
  label.append(radio, document.createElement("span"));
  head.append(label);
  row.append(head, ...Array.from({ length: mode.shares ? 7 : 6 }, () => document.createElement("td")));
  row.addEventListener("click", (event) => {
    if (targetOf(event).closest("label") !== null || !getSelection().isCollapsed) return;
    radio.focus({ preventScroll: true });
    radio.click();
  });
  return row;
}

function fill(row, mode, harmonics) {
  write(row.querySelector("span"), mode.label);
  const bounds = [mode.lower_rad_s, mode.upper_rad_s];
  const shown = [
    [frequencyWords(mode), mode.frequency_rad_s ?? ""],
    [figures(mode.frequency_hz), mode.frequency_hz ?? ""],
    [perRevWords(mode.per_rev), mode.per_rev ?? ""],
    [boundsWords(mode), bounds.includes(null) ? "" : bounds.join(" … ")],
    [paperWords(mode), mode.classical_rad_s ?? ""],
  ];
  shown.forEach(([text, full], i) => {
    const cell = row.cells[i + 1];
    write(cell, text);
    cell.dataset.full = full;
  });
  // The paper's value stands before its difference where there is room.
  if (mode.classical_rad_s === null) delete row.cells[5].dataset.value;
  else row.cells[5].dataset.value = figures(mode.classical_rad_s);
  if (mode.shares) showShares(row.cells[7], mode.shares);
  const near = nearness(mode, harmonics);
  const words = marginWords(mode);
  const cell = row.cells[6];
  if (cell.textContent === (near === "" ? words : `${near} ${words}`)) return;
  row.dataset.near = near;
  const tag = Object.assign(document.createElement("span"), { className: "near-tag", textContent: near });
  cell.replaceChildren(...(near === "" ? [words] : [tag, ` ${words}`]));
}

/** Puts rows into a table's body in this order; one that has the focus keeps it. */
function order(body, rows) {
  if (rows.length === body.rows.length && rows.every((row, i) => row === body.rows[i])) return;
  const focused = /** @type {HTMLElement} */ (document.activeElement);
  body.replaceChildren(...rows);
  if (body.contains(focused)) focused.focus({ preventScroll: true });
}

/**
 * Fills the table's body with one row per mode. Shown are those of the degrees of freedom `dofs`; `harmonics` is
 * the last one looked at, `onChoose` hears the name of a mode that is chosen.
 */
export function showModes(body, { modes, model }, { dofs, harmonics, onChoose }) {
  // Rows stay while their modes do, whatever their order and the second motion of a mixed one.
  const rows = new Map(body.dataset.model === model.kind ? [...body.rows].map((row) => [row.dataset.name, row]) : []);
  body.dataset.model = model.kind;
  order(
    body,
    modes.map((mode) => rows.get(nameOf(mode)) ?? newRow(mode, onChoose)),
  );
  modes.forEach((mode, i) => {
    body.rows[i].hidden = !dofs.includes(mode.dof);
    fill(body.rows[i], mode, harmonics);
  });
}

/** Shows which of the modes is chosen. */
export function showChosen(body, modes, chosen) {
  const mode = modeOf(modes, chosen);
  for (const row of body.rows) {
    const radio = row.querySelector("input");
    radio.checked = mode !== null && radio.value === nameOf(mode);
    row.classList.toggle("chosen", radio.checked);
  }
}

/** One sentence on the mode nearest to one of the harmonics looked at; empty where none is near one, as at rest. */
export function closestWords(modes, speed, harmonics = Infinity) {
  const closest = closestOf(modes, harmonics);
  if (closest === null) return "";
  return `${closest.label} is ${marginWords(closest, "/rev")} at ${speed}, the closest${harmonics === Infinity ? "" : ` up to ${harmonics}P`}.`;
}

/** Copied cells carry every digit, in columns that a spreadsheet takes. */
export function copyFull(table) {
  table.addEventListener("copy", (event) => {
    const selection = getSelection();
    if (selection.isCollapsed) return;
    const rows = [...table.rows]
      .map((row) => [...row.cells].filter((c) => selection.containsNode(c, true)).map((c) => c.dataset.full ?? c.textContent))
      .filter((cells) => cells.length > 0);
    if (rows.length === 0) return;
    event.clipboardData.setData("text/plain", rows.map((cells) => cells.join("\t")).join("\n"));
    event.preventDefault();
  });
}
