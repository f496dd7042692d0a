// Pasting into the sheet: at the focused cell, or a whole table in place of the stations.

import { make } from "../../lib/dom.js";
import { RADIUS, column, isUnit, unitOfColumn } from "../columns.js";
import { NEUTRAL } from "../../lib/what-if.js";
import { COMMON, WHOLE, apart, columnsOf, forgetOrigin, putBlock, replaceAll, rowCount } from "../span.js";
import { MOST_ROWS, blockWords, readBlock, writeBlock } from "./block.js";

const NO_RADII = "No column of radii: name one r or radius.";
const listWords = (names) => (names.length < 2 ? names.join("") : `${names.slice(0, -1).join(", ")} and ${names.at(-1)}`);

/** What a block left as it was, on the radii that it had. */
function keptWords(ids) {
  if (ids.length === 0) return "";
  const one = ids.length === 1;
  return `; ${listWords(ids.map((id) => column(id).name))} ${one ? "keeps its radii" : "keep their radii"} in a sheet of ${one ? "its" : "their"} own`;
}

/** The columns that a block's names stand for: {to} with null for those left out, or {words}. */
export function mapped(header, ids) {
  const own = ids.length === 2 ? ids[1] : null;
  const to = header.map(({ text, id }) =>
    ids.includes(id) ? id : own !== null && /^values?$/i.test(text.replace(/[[(].*/, "").trim()) ? own : null,
  );
  const twice = to.find((id, i) => id !== null && to.indexOf(id) !== i);
  if (twice)
    return {
      words: `Two columns are named as ${column(twice).name}: ${listWords(header.filter((_, i) => to[i] === twice).map(({ text }) => `“${text}”`))}. Nothing was pasted.`,
    };
  if (to.every((id) => id === null)) return { words: "None of the named columns belongs to this sheet. Nothing was pasted." };
  return { to };
}

/** What to know of a block's names: columns left out, and units that are not the blade's. */
export function headerNotes(header, to, units) {
  const out = header.filter(({ text }, i) => to[i] === null && text !== "").map(({ text }) => `“${text}”`);
  const other = header.filter(({ unit }, i) => to[i] !== null && unit && !isUnit(unit, to[i], units));
  const notes = out.length === 0 ? [] : [`left out: ${listWords(out)}`];
  if (other.length > 0) {
    const words = other.map(
      (one) =>
        `${column(one.id ?? to[header.indexOf(one)]).name} is headed [${one.unit}], taken as ${unitOfColumn(one.id ?? to[header.indexOf(one)], units)}`,
    );
    notes.push(`units are not converted: ${words.join(", ")}`);
  }
  return notes;
}

export function startPasting({ store, change, say, sheet, grid, jump }) {
  const button = make("button", { type: "button", textContent: "Paste a table…", aria: { expanded: "false", controls: "paste-panel" } });
  const area = make("textarea", {
    id: "paste-text",
    rows: 6,
    spellcheck: false,
    wrap: "off",
    autocomplete: "off",
    placeholder: "r\tmass\tEI flap\tEI lag\tGJ\tpolar inertia",
  });
  const words = make("p", { className: "note", id: "paste-words", aria: { role: "status" } });
  area.setAttribute("aria-describedby", words.id);
  const [use, cancel] = ["Replace the stations", "Cancel"].map((textContent) => make("button", { type: "button", textContent }));
  use.id = "paste-use";
  use.disabled = true;
  const panel = make(
    "div",
    { className: "paste-panel", id: "paste-panel", hidden: true },
    make("label", { htmlFor: area.id, textContent: "Table with tabs, semicolons or commas; a first row of names is understood" }),
    area,
    words,
    make("div", { className: "stations-tools" }, use, cancel),
  );

  /** At the focused cell. */
  function put(text) {
    const block = readBlock(text);
    if (block.refused) return say(block.refused);
    const { header } = block;
    const { top, bottom: lowest, left, right } = grid.selection;
    const bottom = Math.max(top, Math.min(lowest, rowCount(store.get().doc, sheet()) - 1));
    // One value fills the selected block, as in a spreadsheet.
    const one = header === null && block.rows.length === 1 && block.rows[0].length === 1;
    const rows = one
      ? Array.from({ length: bottom - Math.max(top, top < bottom ? 0 : WHOLE) + 1 }, () => Array(right - left + 1).fill(block.rows[0][0]))
      : block.rows;
    const { units } = store.get().doc;
    const ids = columnsOf(store.get().doc, sheet());
    const width = rows[0].length;
    const names = header === null ? { to: ids.slice(left, left + width) } : mapped(header, ids);
    if (names.words) return say(names.words);
    const from = top === WHOLE && rows.length > 1 ? 0 : top;
    if (names.to.length < width)
      return say(
        `The block has ${width} columns; ${names.to.length === 1 ? "only 1 is" : `only ${names.to.length} are`} left from this cell on. Nothing was pasted.`,
      );
    if (header !== null && !names.to.includes(RADIUS))
      return say(`${NO_RADII} Without a row of names a block goes in at the focused cell. Nothing was pasted.`);
    // Every station from the block: that is another blade.
    const all =
      names.to.includes(RADIUS) &&
      names.to.some((id) => id !== null && id !== RADIUS && !column(id).optional) &&
      from === 0 &&
      rows.length >= rowCount(store.get().doc, sheet()) &&
      sheet() === COMMON &&
      rows.length > 1;
    let kept = [];
    const work = (copy) => {
      kept = header === null ? [] : apart(copy, sheet(), from, names.to, rows);
      if (all) forgetOrigin(copy);
      return putBlock(copy, sheet(), top, names.to, rows, MOST_ROWS);
    };
    if (!change(work, all ? { whatIf: NEUTRAL } : {})) return undefined;
    grid.go(from, header === null ? left : 0, false);
    if (rows.length > 1 || width > 1) {
      const last = header === null ? left + width - 1 : ids.length - 1;
      grid.select(from + rows.length - 1, last);
    }
    return say(`${sentence({ ...block, rows }, names.to, units, "pasted")}${keptWords(kept)}.`);
  }

  function sentence(block, to, units, done, named = "") {
    const empty = block.rows.flatMap((row) => row.filter((value, k) => value === "" && to[k] !== null)).length;
    const notes = block.header === null ? [] : headerNotes(block.header, to, units);
    if (empty > 0) notes.push(`${empty} empty ${empty === 1 ? "cell is a fault" : "cells are faults"}`);
    const [size, ...more] = blockWords(block).split("; ");
    return [`${size} ${done}${named}`, ...more, ...notes].join("; ");
  }

  /** A whole table: {block, to}, or {words} where there is none. */
  function plan(text) {
    if (text.trim() === "") return { words: "" };
    const block = readBlock(text);
    if (block.refused) return { words: block.refused };
    const ids = columnsOf(store.get().doc, COMMON);
    const width = block.rows[0].length;
    if (block.header === null && width > ids.length)
      return { words: `The table has ${width} columns, the sheet ${ids.length}: name them in a first row.` };
    const names = block.header === null ? { to: ids.slice(0, width) } : mapped(block.header, ids);
    if (names.words) return { words: names.words };
    if (!names.to.includes(RADIUS)) return { words: NO_RADII };
    if (width < 2) return { words: "A table has radii and at least one property." };
    return { block, to: names.to };
  }

  function preview(text) {
    const { block, to, words: refused } = plan(text);
    use.disabled = block === undefined;
    words.textContent =
      block === undefined
        ? refused
        : `${sentence(block, to, store.get().doc.units, "understood", `: ${listWords(to.filter((id) => id !== null).map((id) => column(id).name))}`)}.`;
  }

  function close() {
    panel.hidden = true;
    button.setAttribute("aria-expanded", "false");
    area.value = "";
    preview("");
  }

  button.addEventListener("click", () => {
    if (!panel.hidden) return close();
    panel.hidden = false;
    button.setAttribute("aria-expanded", "true");
    return area.focus();
  });
  area.addEventListener("input", () => preview(area.value));
  // A field of a hundred thousand lines would hold up the page before it could say so.
  area.addEventListener("paste", (event) => {
    const { refused } = readBlock(event.clipboardData.getData("text/plain"));
    if (!refused?.includes("too many")) return;
    event.preventDefault();
    words.textContent = refused;
  });
  panel.addEventListener("keydown", (event) => {
    if (event.key !== "Escape") return;
    close();
    button.focus();
  });
  cancel.addEventListener("click", () => {
    close();
    button.focus();
  });
  use.addEventListener("click", () => {
    const { block, to } = plan(area.value);
    let kept = [];
    change(
      (copy) => {
        kept = replaceAll(copy, to, block.rows);
      },
      { whatIf: NEUTRAL },
    );
    say(`${sentence(block, to, store.get().doc.units, "pasted")}${keptWords(kept)}.`);
    close();
    jump({ sheet: COMMON, row: 0, id: RADIUS });
  });
  return { put, write: writeBlock, button, panel };
}
