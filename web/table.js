// The frequency table at one rotor speed.

import { figures, marginWords } from "./format.js";

function cell(tag, text, full) {
  const element = document.createElement(tag);
  element.textContent = text;
  if (full !== undefined) element.dataset.full = full;
  return element;
}

/** Fills the table's body with one row per mode; `margins` is empty at rest. */
export function showModes(body, report, margins) {
  const marginOf = new Map(margins.map((margin) => [margin.label, margin]));
  body.replaceChildren(
    ...report.modes.map((mode) => {
      const row = document.createElement("tr");
      row.dataset.dof = mode.dof;
      const head = cell("th", mode.label);
      head.scope = "row";
      const perRev = mode.per_rev === null ? "–" : mode.per_rev.toFixed(3);
      row.append(
        head,
        cell("td", figures(mode.frequency_rad_s), mode.frequency_rad_s),
        cell("td", figures(mode.frequency_hz), mode.frequency_hz),
        cell("td", perRev, mode.per_rev ?? ""),
        cell("td", marginWords(marginOf.get(mode.label))),
      );
      return row;
    }),
  );
}

/** One sentence on the mode nearest to a harmonic; empty at rest. */
export function closestWords(margins, speed) {
  if (margins.length === 0) return "";
  const closest = margins.reduce((a, b) => (Math.abs(b.margin_per_rev) < Math.abs(a.margin_per_rev) ? b : a));
  return `${closest.label} is ${marginWords(closest, "/rev")} at ${speed}, the closest of these.`;
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
