// Reads a block of cells from a spreadsheet or CSV text. It never guesses: what may be read in two
// ways is refused with words.

import { cellText } from "../../lib/format.js";
import { columnOf, headerUnit, isRatio } from "../columns.js";

/** Rows that a sheet takes. */
export const MOST_ROWS = 2000;
const MOST_COLUMNS = 64;
/** A cell's text is kept up to here; nobody writes a longer number. */
const LONGEST_CELL = 200;
const SEPARATORS = { "\t": "tabs", ";": "semicolons", ",": "commas" };

class Refusal extends Error {}
const refuse = (words) => {
  throw new Refusal(words);
};
const clip = (text) => (text.length > 24 ? `${text.slice(0, 23)}…` : text);

/** Number of lines, line breaks in quotes aside. */
export function countRows(text) {
  let rows = 0;
  let quoted = false;
  let filled = false;
  for (let i = 0; i < text.length; i++) {
    const code = text.charCodeAt(i);
    if (code === 34) quoted = !quoted;
    if (code === 10 && !quoted) {
      if (filled) rows++;
      filled = false;
    } else if (code > 32) filled = true;
  }
  return rows + (filled ? 1 : 0);
}

function separatorOf(text) {
  const bare = text.replace(/"(?:[^"]|"")*"/g, "");
  return Object.keys(SEPARATORS).find((mark) => bare.includes(mark)) ?? null;
}

/** Cells as text; a quote counts at the start of a cell only, as spreadsheets write it. */
function cells(text, separator) {
  const rows = [[]];
  let at = 0;
  while (at <= text.length) {
    let end = at;
    let value;
    const quoted = /^[ ]*"/.test(text.slice(at, at + 8)) ? text.indexOf('"', at) : -1;
    if (quoted >= 0) {
      end = quoted + 1;
      while (end < text.length && (text[end] !== '"' || text[end + 1] === '"')) end += text[end] === '"' ? 2 : 1;
      if (end >= text.length) refuse("A quote is opened and not closed. Nothing was pasted.");
      value = text.slice(quoted + 1, end).replaceAll('""', '"');
      end++;
    }
    const start = end;
    while (end < text.length && text[end] !== separator && text[end] !== "\n") end++;
    value = `${value ?? ""}${text.slice(start, end)}`.replace(/[\r\n]+/g, " ").trim();
    const row = rows.at(-1);
    row.push(value.length > LONGEST_CELL ? `${value.slice(0, LONGEST_CELL)}…` : value);
    if (row.length > MOST_COLUMNS) refuse(`The block has more than ${MOST_COLUMNS} columns. Nothing was pasted.`);
    at = end + 1;
    if (text[end] === "\n") rows.push([]);
  }
  return rows;
}

const isEmpty = (row) => row.every((cell) => cell === "");

/** Without empty rows at either end and empty columns at the right; all rows equally long. */
function trimmed(rows) {
  let [from, to] = [0, rows.length];
  while (from < to && isEmpty(rows[from])) from++;
  while (to > from && isEmpty(rows[to - 1])) to--;
  const own = rows.slice(from, to);
  const width = own.reduce((most, row) => Math.max(most, row.findLastIndex((cell) => cell !== "") + 1), 0);
  return own.map((row) => Array.from({ length: width }, (_, i) => row[i] ?? ""));
}

const minus = (text) => text.replace(/[−‒–]/g, "-").replace(/^'/, "");
const POINT = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i;
const COMMA = /^[+-]?(\d+,\d*|,\d+)(e[+-]?\d+)?$/i;
/** Digits in groups of three, with anything that is used between them. */
const GROUPED = /^[+-]?\d{1,3}([\s\u00a0\u202f\u2009'’,._]\d{3})+([.,]\d*)?(e[+-]?\d+)?$/i;
/** One group after a comma: 1,234 may be a decimal or thousands. */
const EITHER = /^[+-]?[1-9]\d{0,2},\d{3}$/;

/** How numbers are written in all of the block: with decimal points or commas. */
function decimalOf(all, separator) {
  const points = all.find((cell) => POINT.test(cell) && cell.includes("."));
  const commas = all.filter((cell) => COMMA.test(cell));
  const plainPoint = (cell) => POINT.test(cell);
  const grouped = all.find((cell) => GROUPED.test(cell) && !plainPoint(cell) && !COMMA.test(cell));
  if (grouped !== undefined)
    refuse(`“${clip(grouped)}” looks like a number with a thousands separator. Take the separators out; nothing was pasted.`);
  if (commas.length === 0) return ".";
  if (points !== undefined)
    refuse(`“${clip(commas[0])}” and “${clip(points)}”: commas and points in one block. One of them may part thousands; nothing was pasted.`);
  if (separator === ",")
    refuse(`“${clip(commas[0])}”: a comma inside a number where commas part the columns. Use tabs or semicolons; nothing was pasted.`);
  if (commas.every((cell) => EITHER.test(cell)))
    refuse(
      `“${clip(commas[0])}” may be ${commas[0].replace(",", ".")} or ${commas[0].replace(",", "")}. Write it with a point or without the comma; nothing was pasted.`,
    );
  return ",";
}

function number(cell) {
  const plain = minus(cell);
  // An apostrophe keeps a spreadsheet from taking words for a formula; it is none of them.
  if (plain === "" || !(POINT.test(plain) || COMMA.test(plain))) return cell.replace(/^'(?=[=+\-@])/, "");
  const value = Number(plain.replace(",", "."));
  return Number.isFinite(value) ? value : cell;
}

const isNumber = (cell) => POINT.test(minus(cell)) || COMMA.test(minus(cell));
const isWords = (row) => !row.some(isNumber) && row.some((cell) => cell !== "");

/** A row of units under the names, as reports print it: each is one or nothing. */
const isUnits = (row) =>
  isWords(row) &&
  row.every(
    (cell) => cell === "" || cell === "-" || /^[[(].*[\])]$/.test(cell) || /^(mm|cm|m|in|ft|deg|rad|°|(kg|g|lb|slug|k?n|lbf)\W.*)$/i.test(cell),
  );

/** Names and units of the first row, or null where it has none that is known. */
function headerOf(rows, alone) {
  if (!isWords(rows[0]) || !rows[0].some((cell) => columnOf(cell) !== null || isRatio(cell) || /^values?$/i.test(cell))) return null;
  if (rows.length === 1 && alone) return null;
  const units = rows.length > 2 && isUnits(rows[1]) ? rows[1].map((cell) => headerUnit(cell) ?? cell) : [];
  const ratio = rows[0].find(isRatio);
  if (ratio !== undefined) refuse(`“${clip(ratio)}” is a ratio; the sheet takes radii. Multiply by the tip radius first; nothing was pasted.`);
  return {
    names: rows[0].map((text, i) => ({ text: clip(text), id: columnOf(text), unit: headerUnit(text) ?? (units[i] || null) })),
    rows: units.length > 0 ? 2 : 1,
  };
}

function read(text) {
  const clean = text.replace(/^\ufeff/, "").replace(/\r\n?/g, "\n");
  const count = countRows(clean);
  if (count > MOST_ROWS + 2) refuse(`${count} rows are too many: a blade has at most ${MOST_ROWS} stations here. Nothing was pasted.`);
  const separator = separatorOf(clean);
  const rows = trimmed(cells(clean.replace(/\n+$/, ""), separator));
  if (rows.length === 0 || rows[0].length === 0) refuse("There is nothing to paste.");
  const header = headerOf(rows, rows[0].length === 1);
  const body = rows.slice(header?.rows ?? 0);
  if (body.length === 0) refuse("There are names of columns and no rows below them.");
  if (body.length > MOST_ROWS) refuse(`${body.length} rows are too many: a blade has at most ${MOST_ROWS} stations here. Nothing was pasted.`);
  // A column of numbers such as 0,5 has no separator of columns; or has it?
  const all = body.flat().map(minus);
  const pairs =
    separator === "," && header === null && rows[0].length === 2 && body.every(([a, b]) => /^[+-]?\d{1,3}$/.test(a) && /^\d+(e[+-]?\d+)?$/i.test(b));
  if (pairs)
    refuse(
      `“${clip(body[0].join(","))}” may be one number or two. Write decimals with points, or part columns with tabs or semicolons; nothing was pasted.`,
    );
  const spaced = separator === null && all.find((cell) => /^[+-]?\d\S*\s+[+-]?[\d.]/.test(cell) && !GROUPED.test(cell));
  if (spaced) refuse(`“${clip(spaced)}”: columns need tabs, semicolons or commas between them. Nothing was pasted.`);
  const decimal = decimalOf(all, separator);
  return { rows: body.map((row) => row.map(number)), header: header?.names ?? null, decimal, separator };
}

/** The block that a text holds: `rows` of numbers, texts that are none, and "" where empty; or `refused` with words. */
export function readBlock(text) {
  try {
    return read(text);
  } catch (error) {
    if (error instanceof Refusal) return { refused: error.message };
    throw error;
  }
}

const many = (count, word) => `${count} ${word}${count === 1 ? "" : "s"}`;

/** What was understood, in one line. */
export function blockWords({ rows, header, decimal }) {
  const size = `${many(rows.length, "row")} × ${many(rows[0]?.length ?? 0, "column")}`;
  return `${size}${decimal === "," ? "; decimal commas read as points" : ""}${header === null ? "" : "; columns by their names"}`;
}

/** Cells as text for a spreadsheet, every digit kept. */
export function writeBlock(rows) {
  const quote = (text) => (/["\t\n\r]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);
  return rows.map((row) => row.map((value) => quote(cellText(value))).join("\t")).join("\n");
}
