// The grid: cells, focus, selection and typing as in a spreadsheet. It knows nothing of blades; what
// stands in its cells comes with each `show`, what is done goes out through `on`.

import { make, targetOf } from "../../lib/dom.js";
import { CellEditor } from "./editor.js";
import { bindKeys } from "./keys.js";

/** Digits that a cell shows; typing and copying have them all. */
const DIGITS = 7;

const shownText = (value) => (typeof value === "number" ? String(Number(value.toPrecision(DIGITS))) : (value ?? ""));

export class Grid {
  /** What is shown: {name, label, columns: [{id, name, unit, form, signed, head()}], rows: [numbers], end, count, row(row), cell(row, id)}. */
  view = null;
  /** The focused cell and the other corner of the selection, as row number and column index. */
  active = { row: 0, col: 0 };
  anchor = { row: 0, col: 0 };
  /** Whether all stations are selected, also those that are not shown. */
  all = false;
  #lines = [];
  #head = make("tr", { aria: { role: "row", rowindex: 1 } });
  #body = make("tbody", { aria: { role: "rowgroup" } });

  /** `on`: edit(row, id, value, key), takeBack(), history(way), refuse(words), move(), clear(), copy(cut), paste(text), command(name). */
  constructor(host, on, noteId) {
    this.on = on;
    this.noteId = noteId;
    this.table = make("table", { className: "sheet", aria: { role: "grid", multiselectable: "true" } });
    this.table.append(make("thead", { aria: { role: "rowgroup" } }, this.#head), this.#body);
    host.append(this.table);
    this.editor = new CellEditor(this);
    bindKeys(this);
    this.#bindPointer();
  }

  show(view) {
    const other = this.view?.name !== view.name;
    const focused = this.table.contains(document.activeElement);
    if (other) this.editor.end();
    this.view = view;
    if (other) this.all = false;
    if (other) this.active = this.anchor = { row: view.rows.find((row) => row >= 0) ?? view.rows[0], col: 0 };
    const { rows, columns, end } = view;
    const within = ({ row, col }, lowest, highest) => ({ row: Math.max(lowest, Math.min(row, highest)), col: Math.min(col, columns.length - 1) });
    this.active = within(this.active, rows[0], rows.at(-1));
    this.anchor = within(this.anchor, Math.min(0, rows[0]), Math.max(end - 1, rows.at(-1)));
    this.table.ariaLabel = view.label;
    this.table.ariaRowCount = view.count + 1;
    this.table.ariaColCount = view.columns.length + 1;
    this.#showHead();
    this.#showRows();
    this.#showSelection();
    if (focused && !this.table.contains(document.activeElement)) this.focus();
  }

  td({ row, col }) {
    return this.#lines[this.view.rows.indexOf(row)]?.cells[col];
  }

  focus() {
    const td = this.td(this.active);
    td?.focus({ preventScroll: true });
    td?.scrollIntoView({ block: "nearest", inline: "nearest" });
    getSelection().removeAllRanges();
  }

  /** Goes to a cell; `extend` keeps the other corner of the selection. */
  go(row, col, extend = false, focus = true) {
    const { rows, columns } = this.view;
    const clamped = Math.max(rows[0], Math.min(row, rows.at(-1)));
    this.active = {
      row: rows.includes(clamped) ? clamped : (rows.find((one) => one >= 0) ?? rows[0]),
      col: Math.max(0, Math.min(col, columns.length - 1)),
    };
    this.all = false;
    if (!extend) this.anchor = this.active;
    this.#showSelection();
    if (focus) this.focus();
    this.on.move();
  }

  /** Selects from the focused cell to this one. */
  select(row, col) {
    this.anchor = { row, col };
    this.#showSelection();
  }

  /** By rows of the sheet as shown, the whole span's row above the first. */
  step(down, right, extend = false) {
    const { rows } = this.view;
    const at = Math.max(0, Math.min(rows.indexOf(this.active.row) + down, rows.length - 1));
    this.go(rows[at], this.active.col + right, extend);
  }

  /** The selected block: rows and columns from and to, inclusive. */
  get selection() {
    const [a, b] = [this.active, this.anchor];
    return {
      top: this.all ? Math.min(0, a.row) : Math.min(a.row, b.row),
      bottom: Math.max(a.row, b.row),
      left: Math.min(a.col, b.col),
      right: Math.max(a.col, b.col),
    };
  }

  /** Selects all stations, shown or not. */
  selectAll() {
    const { rows, columns, end } = this.view;
    this.active = { row: rows.find((row) => row >= 0) ?? rows[0], col: 0 };
    this.anchor = { row: Math.max(end - 1, this.active.row), col: columns.length - 1 };
    // Stations before the first shown one are of the selection, too.
    this.all = true;
    this.#showSelection();
    this.focus();
    this.on.move();
  }

  #showHead() {
    const { columns } = this.view;
    const signature = JSON.stringify(columns.map(({ id, name, unit }) => [id, name, unit]));
    if (signature !== this.signature) {
      this.signature = signature;
      this.#head.replaceChildren(
        make("th", { scope: "col", textContent: "station", aria: { role: "columnheader", colindex: 1 } }),
        ...columns.map(({ id, name, unit, head }, i) => {
          const words = make("span", { className: "column-name", textContent: name });
          return make(
            "th",
            { scope: "col", dataset: { column: id }, aria: { role: "columnheader", colindex: i + 2 } },
            words,
            make("span", { className: "unit", textContent: unit }),
            ...head(),
          );
        }),
      );
      this.#lines = [];
      this.#body.replaceChildren();
    }
    for (const { id, form } of columns) {
      const select = /** @type {HTMLSelectElement} */ (this.#head.querySelector(`[data-column="${id}"] select`));
      if (select) select.value = form;
    }
  }

  #newLine() {
    const head = make("th", { scope: "row", aria: { role: "rowheader", colindex: 1 } });
    const cells = this.view.columns.map((_, i) => make("td", { tabIndex: -1, dataset: { col: i }, aria: { role: "gridcell", colindex: i + 2 } }));
    const tr = make("tr", { aria: { role: "row" } }, head, ...cells);
    this.#body.append(tr);
    return { tr, head, cells };
  }

  #showRows() {
    const { rows, columns } = this.view;
    while (this.#lines.length > rows.length) this.#lines.pop().tr.remove();
    while (this.#lines.length < rows.length) this.#lines.push(this.#newLine());
    rows.forEach((row, i) => {
      const { tr, head, cells } = this.#lines[i];
      const { label, words, kind } = this.view.row(row);
      put(tr, "data-row", row);
      put(tr, "aria-rowindex", this.view.rowIndex(row));
      put(tr, "class", kind);
      if (head.textContent !== label) head.textContent = label;
      put(head, "aria-label", words);
      columns.forEach(({ id }, k) => this.#showCell(cells[k], row, id));
    });
  }

  #showCell(td, row, id) {
    const { value, kind, readOnly, invalid } = this.view.cell(row, id);
    const text = shownText(value);
    if (!this.editor.isIn(td) && td.textContent !== text) td.textContent = text;
    put(td, "class", kind);
    put(td, "aria-readonly", readOnly ? "true" : null);
    put(td, "aria-invalid", invalid ? "true" : null);
  }

  #showSelection() {
    const { top, bottom, left, right } = this.selection;
    const several = top !== bottom || left !== right;
    this.view.rows.forEach((row, i) => {
      this.#lines[i].cells.forEach((td, col) => {
        const here = row === this.active.row && col === this.active.col;
        const inside = row >= top && row <= bottom && col >= left && col <= right;
        put(td, "tabindex", here ? "0" : "-1");
        put(td, "aria-selected", inside ? "true" : "false");
        put(td, "data-block", inside && several ? "" : null);
        put(td, "aria-describedby", here ? this.noteId : null);
      });
    });
  }

  #bindPointer() {
    const placeOf = (target) => {
      const [td, tr] = [target.closest?.("td"), target.closest?.("tbody tr")];
      return tr === null || tr === undefined ? null : { row: Number(tr.dataset.row), col: td ? Number(td.dataset.col) : null };
    };
    let dragging = false;
    let again = false; // pressed on the cell that was focused already
    this.table.addEventListener("pointerdown", (event) => {
      const place = placeOf(event.target);
      if (place === null || targetOf(event).tagName === "INPUT" || event.button !== 0) return;
      again = place.row === this.active.row && place.col === this.active.col && this.table.contains(document.activeElement);
      if (event.pointerType === "touch") return; // the finger may be about to scroll
      dragging = event.pointerType === "mouse";
      press(place, event.shiftKey);
    });
    const press = (place, extend) => {
      if (place.col === null) {
        this.anchor = { row: extend ? this.anchor.row : place.row, col: this.view.columns.length - 1 };
        this.go(place.row, 0, true);
      } else this.go(place.row, place.col, extend);
    };
    this.table.addEventListener("mousedown", (event) => {
      if (placeOf(event.target) !== null && targetOf(event).tagName !== "INPUT") event.preventDefault();
    });
    this.table.addEventListener("pointerover", (event) => {
      const place = placeOf(event.target);
      if (dragging && event.buttons === 1 && place !== null && place.col !== null) this.go(place.row, place.col, true);
    });
    addEventListener("pointerup", () => (dragging = false));
    this.table.addEventListener("click", (event) => {
      const place = placeOf(event.target);
      if (event.pointerType !== "touch" || place === null || targetOf(event).tagName === "INPUT") return;
      if (again) this.editor.begin();
      else press(place, false);
    });
    this.table.addEventListener("dblclick", (event) => {
      if (targetOf(event).tagName === "TD") this.editor.begin();
    });
  }
}

/** Sets an attribute where it differs; null removes it. */
function put(element, name, value) {
  const text = value === null || value === undefined ? null : String(value);
  if (element.getAttribute(name) === text) return;
  if (text === null) element.removeAttribute(name);
  else element.setAttribute(name, text);
}
