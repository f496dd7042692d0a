// The frequency table at one rotor speed. Its rows are the choice of a mode.

import { targetOf, write } from "../lib/dom.js";
import { boundsWords, closestOf, figures, marginWords, paperWords, perRevWords } from "../lib/format.js";
import { nearness } from "./nearness.js";

function newRow(mode, onChoose) {
  const row = document.createElement("tr");
  row.dataset.dof = mode.dof;
  const head = document.createElement("th");
  head.scope = "row";
  // Radio buttons: one stop of the tab key, arrows from mode to mode.
  const radio = document.createElement("input");
  radio.type = "radio";
  radio.name = "mode";
  radio.value = mode.label;
  radio.addEventListener("change", () => onChoose(mode.label));
  const label = document.createElement("label");
  label.append(radio, mode.label);
  head.append(label);
  row.append(head, ...Array.from({ length: 6 }, () => document.createElement("td")));
  row.addEventListener("click", (event) => {
    if (targetOf(event).closest("label") !== null || !getSelection().isCollapsed) return;
    radio.focus({ preventScroll: true });
    radio.click();
  });
  return row;
}

function fill(row, mode, harmonics) {
  const bounds = [mode.lower_rad_s, mode.upper_rad_s];
  const shown = [
    [figures(mode.frequency_rad_s), mode.frequency_rad_s],
    [figures(mode.frequency_hz), mode.frequency_hz],
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
  const near = nearness(mode, harmonics);
  const words = marginWords(mode);
  const cell = row.cells[6];
  if (cell.textContent === (near === "" ? words : `${near} ${words}`)) return;
  row.dataset.near = near;
  const tag = Object.assign(document.createElement("span"), { className: "near-tag", textContent: near });
  cell.replaceChildren(...(near === "" ? [words] : [tag, ` ${words}`]));
}

/** Fills the table's body with one row per mode; `harmonics` is the last one looked at. */
export function showModes(body, report, onChoose, harmonics) {
  const labels = [...body.rows].map((row) => row.cells[0].textContent);
  // Rows stay while their modes do, and with them the focus.
  if (labels.join() !== report.modes.map((mode) => mode.label).join()) {
    body.replaceChildren(...report.modes.map((mode) => newRow(mode, onChoose)));
  }
  report.modes.forEach((mode, i) => fill(body.rows[i], mode, harmonics));
}

/** Shows which mode is chosen. */
export function showChosen(body, chosen) {
  for (const row of body.rows) {
    const radio = row.querySelector("input");
    radio.checked = radio.value === chosen;
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
