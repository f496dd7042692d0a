// The stations of the blade as a spreadsheet: what is typed or pasted goes into the blade at once.

import { at } from "../lib/dom.js";
import { RADIUS, column, unitOfColumn } from "./columns.js";
import { listPlaced, placedFaults } from "./faults.js";
import { convert } from "./forms.js";
import { formSelect, formWords, stationsParts } from "./parts.js";
import { MOST_ROWS } from "./paste/block.js";
import { startPasting } from "./paste/panel.js";
import { showProfiles } from "./profiles.js";
import { Grid } from "./sheet/grid.js";
import * as span from "./span.js";
import { COMMON, WHOLE } from "./span.js";

/** Rows of a long blade that are shown at once. */
const PAGE_ROWS = 500;
const many = (count, word) => `${count} ${word}${count === 1 ? "" : "s"}`;

/** Makes the tab; what happens there is said there. */
export function startStations(store, blade) {
  const host = at("stations");
  const { choice, choiceField, pages, pagesField, buttons, tools, scroll, long, said, note, count, list, profiles, keys } = stationsParts();
  const say = (words) => (said.textContent = words);

  let sheet = COMMON; // the one that is shown
  let page = 0;
  let typed = new Set(); // blades that the cell under typing made
  const doc = () => store.get().doc;
  const idsAt = () => span.columnsOf(doc(), sheet);

  /** Changes the blade, and says why where it was not changed. */
  function change(work, more = {}) {
    let words = null;
    blade.edit(
      (copy) => {
        const before = structuredClone(copy);
        words = work(copy) ?? null;
        if (words !== null) restore(copy, before);
      },
      null,
      more,
    );
    if (words !== null) say(words);
    return words === null;
  }

  const grid = new Grid(
    scroll,
    {
      edit(row, id, value, key) {
        const before = doc();
        if (!typed.has(before)) typed = new Set();
        say("");
        blade.edit((copy) => void span.setCell(copy, sheet, row, id, value), key);
        if (doc() !== before) typed.add(doc());
      },
      takeBack() {
        while (typed.has(doc()) && store.get().canUndo) blade.undo();
      },
      history: (way) => blade[way](),
      refuse: say,
      move() {
        typed = new Set();
        showNote();
        showMark();
      },
      clear: () => clear(),
      copy(cut) {
        const { rows, ids } = block();
        const values = rows.map((row) => ids.map((id) => value(row, id)));
        if (cut) clear();
        return pasting.write(values);
      },
      paste: (text) => pasting.put(text),
      command,
    },
    note.id,
  );

  const pasting = startPasting({ store, change, say, sheet: () => sheet, grid, jump });
  tools.append(pasting.button);
  host.append(tools, pasting.panel, pagesField, long, scroll, said, note, count, list, profiles, keys);

  /** What a cell shows: a single number stands at every radius. */
  const value = (row, id) => {
    const own = span.cellOf(doc(), sheet, row, id);
    const single = sheet === COMMON && id !== RADIUS && row !== WHOLE && span.formOf(doc(), id) === "number" && row < span.rowCount(doc(), sheet);
    return single ? doc().distribution[id] : own;
  };

  /** Rows and columns of the selection, without the row of a new station. */
  function block() {
    const { top, bottom, left, right } = grid.selection;
    const end = Math.min(bottom, span.rowCount(doc(), sheet) - 1);
    return { rows: Array.from({ length: Math.max(0, end - top + 1) }, (_, i) => top + i), ids: idsAt().slice(left, right + 1) };
  }

  function clear() {
    const { rows, ids } = block();
    change((copy) => {
      for (const row of rows) {
        for (const id of ids) {
          const single = sheet === COMMON && id !== RADIUS && row !== WHOLE && span.formOf(copy, id) !== "list";
          if (!single && span.readOnly(copy, sheet, row, id) === null) span.setCell(copy, sheet, row, id, "");
        }
      }
    });
  }

  function command(name, focus = true) {
    const { top, bottom } = grid.selection;
    const rows = span.rowCount(doc(), sheet);
    const [from, to] = [Math.max(0, top), Math.min(bottom, rows - 1)];
    const { col } = grid.active;
    const go = (first, last = first) => {
      grid.go(first, col, false, focus);
      if (last !== first) grid.go(last, col, true, focus);
    };
    if (name === "above" || name === "below") {
      if (rows >= MOST_ROWS) return say(`A sheet takes at most ${MOST_ROWS} rows.`);
      const row = name === "above" ? from : top === WHOLE ? 0 : to + 1;
      if (change((copy) => void span.addRow(copy, sheet, Math.min(row, rows)))) reveal(Math.min(row, rows), () => go(Math.min(row, rows)));
      return;
    }
    if (top === WHOLE || to < from) return say("Choose a station first.");
    if (name === "step" && change((copy) => span.addStep(copy, sheet, to))) reveal(to + 1, () => go(to + 1));
    if (name === "delete" && change((copy) => void span.deleteRows(copy, sheet, from, to))) {
      go(Math.max(0, Math.min(from, rows - (to - from + 1) - 1)));
      say(`${many(to - from + 1, "row")} deleted.`);
    }
    if (name === "up" || name === "down") {
      const by = name === "up" ? -1 : 1;
      if (change((copy) => void span.moveRows(copy, sheet, from, to, by)) && from + by >= 0 && to + by < rows)
        reveal(from + by, () => go(from + by, to + by));
    }
  }

  /** Turns to the page of a row. */
  function reveal(row, then) {
    const wanted = row === WHOLE ? page : Math.min(Math.floor(row / PAGE_ROWS), Math.max(0, Math.ceil(span.rowCount(doc(), sheet) / PAGE_ROWS) - 1));
    if (wanted !== page) {
      page = wanted;
      show();
    }
    then();
  }

  /** Goes to the cell of a place in the blade. */
  function jump(place) {
    sheet = place.sheet;
    show();
    reveal(place.row, () => grid.go(place.row, idsAt().indexOf(place.id)));
  }

  const formChoice = (id) =>
    formSelect(id, (form) => {
      if (change((copy) => convert(copy, id, form))) say(formWords(id, form));
      return span.formOf(doc(), id);
    });

  let faulty = new Map();
  const keyOf = ({ sheet, row, id }) => `${sheet} ${row} ${id}`;

  /** The rows shown: the whole span's, those of the page, and an empty one to type a new station in. */
  function rowsShown(rows) {
    const pageCount = Math.max(1, Math.ceil(rows / PAGE_ROWS));
    page = Math.min(page, pageCount - 1);
    const from = page * PAGE_ROWS;
    const to = Math.min(rows, from + PAGE_ROWS);
    const stations = Array.from({ length: to - from }, (_, i) => from + i);
    const last = page === pageCount - 1 && rows < MOST_ROWS && rows <= PAGE_ROWS;
    return [...(sheet === COMMON ? [WHOLE] : []), ...stations, ...(last ? [rows] : [])];
  }

  function rowLook(row, rows) {
    if (row === WHOLE) return { label: "whole span", words: "whole span", kind: "whole" };
    if (row === rows) return { label: "new", words: "new station", kind: "new" };
    const step = span.stepAt(doc(), sheet, row);
    const words = step === null ? `station ${row + 1}` : `station ${row + 1}, step, ${step}`;
    return { label: `${row + 1}${step === "outboard" ? " step" : ""}`, words, kind: step === null ? "" : `step ${step}` };
  }

  function cellLook(row, id, rows) {
    const readOnly = span.readOnly(doc(), sheet, row, id);
    const single = sheet === COMMON && id !== RADIUS && row !== WHOLE && row < rows && span.formOf(doc(), id) !== "list";
    const kind = readOnly !== null ? "shut" : single ? "single" : null;
    return { value: value(row, id), kind, readOnly, invalid: faulty.has(keyOf({ sheet, row, id })) };
  }

  function show() {
    const { units } = doc();
    const sheets = span.sheetsOf(doc());
    if (!sheets.includes(sheet)) sheet = COMMON;
    const names = sheets.map((id) => (id === COMMON ? "common radii" : `${column(id).name}, radii of its own`));
    if (choice.dataset.names !== names.join()) {
      choice.dataset.names = names.join();
      choice.replaceChildren(...sheets.map((id, i) => new Option(names[i], id)));
    }
    choice.value = sheet;
    choiceField.hidden = sheets.length === 1;
    const rows = span.rowCount(doc(), sheet);
    const shown = rowsShown(rows);
    const first = sheet === COMMON ? 3 : 2;
    const at = grid.active;
    grid.show({
      name: sheet,
      label: sheet === COMMON ? "Stations of the blade" : `Stations of the ${column(sheet).name}`,
      columns: idsAt().map((id) => ({
        id,
        name: column(id).name,
        unit: unitOfColumn(id, units),
        signed: column(id).optional === true,
        form: id === RADIUS ? null : span.formOf(doc(), id),
        head: () => (id === RADIUS ? [] : formChoice(id)),
      })),
      rows: shown,
      end: rows,
      count: rows + first - 1,
      row: (row) => rowLook(row, rows),
      rowIndex: (row) => (row === WHOLE ? 2 : row + first),
      cell: (row, id) => cellLook(row, id, rows),
    });
    pagesField.hidden = long.hidden = rows <= PAGE_ROWS;
    if (rows > PAGE_ROWS)
      showPages(
        rows,
        shown.filter((row) => row >= 0),
      );
    if (at !== grid.active) showNote();
    showMark();
  }

  function showPages(rows, shown) {
    const [from, to] = [shown[0] + 1, shown.at(-1) + 1];
    long.textContent =
      page === 0
        ? `The first ${to} of ${rows} rows are shown; all are solved and copied.`
        : `Rows ${from} to ${to} of ${rows} are shown; all are solved and copied.`;
    pages.replaceChildren(
      ...Array.from(
        { length: Math.ceil(rows / PAGE_ROWS) },
        (_, i) => new Option(`${i * PAGE_ROWS + 1}–${Math.min(rows, (i + 1) * PAGE_ROWS)}`, String(i), false, i === page),
      ),
    );
  }

  function showFaults() {
    const faults = placedFaults(store.get());
    faulty = new Map();
    for (const { place, message } of faults.filter((fault) => fault.place !== null)) {
      faulty.set(keyOf(place), [...(faulty.get(keyOf(place)) ?? []), message]);
    }
    listPlaced(list, count, faults, jump);
  }

  /** Below the sheet: which cell this is and what is wrong with it. */
  function showNote() {
    if (doc() === null || grid.view === null) return;
    const { row } = grid.active;
    const id = idsAt()[grid.active.col];
    const faults = faulty.get(keyOf({ sheet, row, id })) ?? [];
    const look = grid.view.row(row);
    const exact = value(row, id);
    const where = `${column(id).name}, ${look.words}${exact === undefined || exact === "" ? "" : `: ${exact} ${unitOfColumn(id, doc().units)}`}`;
    const single =
      sheet === COMMON && id !== RADIUS && row !== WHOLE && span.formOf(doc(), id) === "number"
        ? "One number at all radii; another one typed here makes it a list."
        : "";
    const readOnly = grid.view.cell(row, id).readOnly || single;
    note.textContent = faults.length > 0 ? `${where}. Fault: ${faults.join("; ")}` : `${where}${readOnly ? `. ${readOnly}` : ""}`;
    note.classList.toggle("fault", faults.length > 0);
  }

  function showMark() {
    const { row } = grid.active;
    const r = row === WHOLE ? undefined : span.cellOf(doc(), sheet, row, RADIUS);
    showProfiles(profiles, doc(), typeof r === "number" ? r : null);
  }

  choice.addEventListener("change", () => {
    sheet = choice.value;
    page = 0;
    show();
    showNote();
  });
  pages.addEventListener("change", () => {
    page = Number(pages.value);
    show();
    grid.go(page * PAGE_ROWS, grid.active.col, false, false);
  });
  for (const [name, button] of Object.entries(buttons)) {
    // Pressed by key, a button keeps the focus.
    button.addEventListener("click", ({ detail }) => command(name, detail > 0));
  }
  store.subscribe((state, changed) => {
    if (changed.has("opened") && state.doc !== null) {
      [sheet, page] = [span.firstSheet(state.doc), 0];
      say("");
    }
    if (state.doc === null || state.tab !== "stations") return;
    if (!changed.has("doc") && !changed.has("faults") && !changed.has("tab")) return;
    showFaults();
    show();
    showNote();
  });
}

/** Makes an object as it was, in place. */
function restore(object, before) {
  for (const key of Object.keys(object)) delete object[key];
  Object.assign(object, before);
}
