// The sheets of a blade and their changes. All functions work on the blade as plain data; those that
// change it do so in place, and give words where they will not.
//
// A sheet is "" for the stations on the common radii `distribution.r`, or the name of a property that
// has radii of its own. Row -1 of the common sheet is the whole span: properties of a single number.

import { PROPERTIES, RADIUS, column } from "./columns.js";

export const COMMON = "";
export const WHOLE = -1;

/** How a property is given: "list", "number", "own" or "absent". */
export function formOf(doc, id) {
  const given = doc.distribution?.[id];
  if (given === undefined || given === null) return "absent";
  if (Array.isArray(given)) return "list";
  return typeof given === "object" ? "own" : "number";
}

const ids = PROPERTIES.map(({ id }) => id);
export const ofForm = (doc, form) => ids.filter((id) => formOf(doc, id) === form);
export const sheetsOf = (doc) => [COMMON, ...ofForm(doc, "own")];
/** The sheet to begin with: a blade may have no common radii and no single numbers at all. */
export function firstSheet(doc) {
  const [, first = COMMON] = sheetsOf(doc);
  return rowCount(doc, COMMON) > 0 || ofForm(doc, "number").length > 0 ? COMMON : first;
}
const shown = (doc) => ids.filter((id) => !column(id).rare || formOf(doc, id) !== "absent");
export const columnsOf = (doc, sheet) => (sheet === COMMON ? [RADIUS, ...shown(doc)] : [RADIUS, sheet]);
/** What a property is where nothing is given. */
export const nothing = (id) => (column(id).optional ? 0 : "");

/** The list behind a column, or undefined. */
function listOf(doc, sheet, id) {
  const table = doc.distribution ?? {};
  const list = sheet === COMMON ? table[id] : id === RADIUS ? table[sheet]?.r : table[sheet]?.values;
  return Array.isArray(list) ? list : undefined;
}

const lists = (doc, sheet) =>
  columnsOf(doc, sheet)
    .map((id) => listOf(doc, sheet, id))
    .filter((list) => list !== undefined);
export const rowCount = (doc, sheet) => Math.max(0, ...lists(doc, sheet).map((list) => list.length));

/** What stands in a cell: a number, a text that is none, "" or undefined where it is empty. */
export function cellOf(doc, sheet, row, id) {
  if (row === WHOLE) return formOf(doc, id) === "number" ? doc.distribution[id] : undefined;
  return listOf(doc, sheet, id)?.[row];
}

/** The cell that a fault's path names: {sheet, row, id}; null where it is none of the distribution. */
export function placeOf(doc, path) {
  const [, id, part, index] = /^distribution\.(\w+)(?:\.(r|values))?(?:\[(\d+)\])?$/.exec(path) ?? [];
  if (id === undefined || column(id) === undefined) return null;
  const row = index === undefined ? null : Number(index);
  if (id !== RADIUS && formOf(doc, id) === "own") return { sheet: id, row: row ?? 0, id: part === "r" ? RADIUS : id };
  const listed = part === undefined && row !== null && row < rowCount(doc, COMMON);
  return { sheet: COMMON, row: listed ? row : WHOLE, id };
}

/** Whether a radius stands twice, and which of the two this is: "inboard", "outboard" or null. */
export function stepAt(doc, sheet, row) {
  const r = listOf(doc, sheet, RADIUS) ?? [];
  const same = (a, b) => typeof r[a] === "number" && r[a] === r[b];
  if (same(row, row - 1)) return "outboard";
  return same(row, row + 1) ? "inboard" : null;
}

/** Makes the property a list on the common radii where it is a single number or absent. */
export function listed(doc, id, rows) {
  const form = formOf(doc, id);
  if (form === "list") return;
  const value = form === "number" ? doc.distribution[id] : nothing(id);
  doc.distribution[id] = Array(rows).fill(value);
}

/** Sets one cell; a row behind the last is a new one. Gives words where the cell cannot be written. */
export function setCell(doc, sheet, row, id, value) {
  doc.distribution ??= {};
  const table = doc.distribution;
  if (row === WHOLE) {
    const words = wholeReason(doc, id);
    if (words !== null) return words;
    if (value === "") delete table[id];
    else table[id] = value;
    return null;
  }
  if (sheet === COMMON && id !== RADIUS && formOf(doc, id) === "own") return ownReason(id);
  const rows = Math.max(rowCount(doc, sheet), row + 1);
  if (sheet === COMMON && id === RADIUS) table.r ??= [];
  if (sheet === COMMON && id !== RADIUS) {
    table.r ??= [];
    listed(doc, id, rows);
  }
  for (const list of lists(doc, sheet)) while (list.length < rows) list.push("");
  listOf(doc, sheet, id)[row] = value;
  return null;
}

const ownReason = (id) => `The ${column(id).name} has radii of its own: choose its sheet, or put it on these radii first.`;
/** Why a cell of the whole span takes no value, or null. */
function wholeReason(doc, id) {
  if (id === RADIUS) return "This row is for properties that are one number at all radii.";
  const form = formOf(doc, id);
  if (form === "own") return ownReason(id);
  return form === "list" ? `The ${column(id).name} stands in the rows below, at each radius.` : null;
}

/** Why a cell cannot be written, or null. */
export function readOnly(doc, sheet, row, id) {
  if (row === WHOLE) return wholeReason(doc, id);
  return sheet === COMMON && id !== RADIUS && formOf(doc, id) === "own" ? ownReason(id) : null;
}

/** Puts a block at a cell; the table grows. `to` names the columns. Gives words where it will not. */
export function putBlock(doc, sheet, row, to, rows, most) {
  const from = row === WHOLE && rows.length > 1 ? 0 : row;
  if (from + rows.length > most) return `The sheet would have ${from + rows.length} rows; at most ${most} are taken. Nothing was pasted.`;
  const barred = to.map((id) => (id === null ? null : readOnly(doc, sheet, from, id))).find((words) => words !== null);
  if (barred) return `${barred} Nothing was pasted.`;
  rows.forEach((values, i) => to.forEach((id, k) => id !== null && putValue(doc, sheet, from + i, id, values[k])));
  return null;
}

/** A single number stays one as long as what is pasted over it is the same. */
function putValue(doc, sheet, row, id, value) {
  const same = sheet === COMMON && row !== WHOLE && formOf(doc, id) === "number" && row < rowCount(doc, sheet) && doc.distribution[id] === value;
  if (!same) setCell(doc, sheet, row, id, value);
}

/** Lists that a block of columns leaves out keep the radii that they have, as radii of their own; gives their names. */
function keepRadii(doc, to) {
  const table = doc.distribution;
  const kept = ofForm(doc, "list").filter((id) => !to.includes(id));
  for (const id of kept) table[id] = { r: [...(table.r ?? [])], values: table[id] };
  return kept;
}

/** Before a named block goes in at a row: where it moves common radii, what it leaves out is not moved along. Gives its names. */
export function apart(doc, sheet, row, to, rows) {
  if (sheet !== COMMON || row === WHOLE) return [];
  const r = listOf(doc, COMMON, RADIUS) ?? [];
  const k = to.indexOf(RADIUS);
  return rows.every((values, i) => values[k] === r[row + i]) ? [] : keepRadii(doc, to);
}

/** All stations new: named columns from the block. Notes and source were of the blade before. Gives the names of what keeps its radii. */
export function replaceAll(doc, to, rows) {
  doc.distribution ??= {};
  const table = doc.distribution;
  const kept = keepRadii(doc, to);
  to.forEach((id, k) => {
    if (id !== null) table[id] = rows.map((values) => values[k]);
  });
  forgetOrigin(doc);
  return kept;
}

/** Where the numbers came from is not where others come from. */
export function forgetOrigin(doc) {
  delete doc.notes;
  delete doc.source;
}

/** Adds a row before `row`: between two radii in the middle, its values interpolated; else empty. */
export function addRow(doc, sheet, row) {
  doc.distribution ??= {};
  if (sheet === COMMON) doc.distribution.r ??= [];
  const r = listOf(doc, sheet, RADIUS) ?? [];
  const between = typeof r[row - 1] === "number" && typeof r[row] === "number" && r[row - 1] < r[row];
  for (const list of lists(doc, sheet)) {
    const [a, b] = [list[row - 1], list[row]];
    while (list.length < row) list.push("");
    list.splice(row, 0, between && typeof a === "number" && typeof b === "number" ? short((a + b) / 2) : "");
  }
}

/** Without the noise of the last digits. */
export const short = (value) => Number(value.toPrecision(15));

/** Repeats a radius, so that the values may differ inboard and outboard of it. */
export function addStep(doc, sheet, row) {
  if (stepAt(doc, sheet, row) !== null) return "This radius stands twice already: it is a step.";
  for (const list of lists(doc, sheet)) if (row < list.length) list.splice(row + 1, 0, list[row]);
  return null;
}

export function deleteRows(doc, sheet, from, to) {
  for (const list of lists(doc, sheet)) list.splice(from, to - from + 1);
}

/** Moves rows by one place. */
export function moveRows(doc, sheet, from, to, by) {
  const rows = rowCount(doc, sheet);
  if (from + by < 0 || to + by >= rows) return false;
  for (const list of lists(doc, sheet)) {
    while (list.length < rows) list.push("");
    if (by < 0) list.splice(to, 0, ...list.splice(from - 1, 1));
    else list.splice(from, 0, ...list.splice(to + 1, 1));
  }
  return true;
}
