// Typing in a cell of the sheet: what is typed goes out at once, Escape takes it back.

import { make } from "../../lib/dom.js";
import { fieldValue } from "../../lib/format.js";

let sessions = 0;

export class CellEditor {
  #sheet;
  #input = null;
  #session = null; // {row, id, key, fresh: arrows move on, typed: something went out}

  constructor(sheet) {
    this.#sheet = sheet;
  }

  isIn(td) {
    return this.#input !== null && this.#input.parentNode === td;
  }

  /** Opens the focused cell: with what stands in it, or empty where a key begins a new value. */
  begin(fresh = false) {
    const sheet = this.#sheet;
    const { row, col } = sheet.active;
    const { id, name, signed } = sheet.view.columns[col];
    const { value, readOnly } = sheet.view.cell(row, id);
    if (this.#input !== null) return;
    if (readOnly) {
      sheet.on.refuse(readOnly);
      return;
    }
    this.#session = { row, id, key: `cell ${++sessions}`, fresh, typed: false };
    // Keypads of decimals have no minus on some telephones.
    this.#input = make("input", {
      type: "text",
      inputMode: signed ? "text" : "decimal",
      autocomplete: "off",
      spellcheck: false,
      value: fresh ? "" : (value ?? ""),
      aria: { label: `${name}, ${sheet.view.row(row).words}`, describedby: sheet.noteId },
    });
    this.#input.addEventListener("input", () => this.#type());
    this.#input.addEventListener("keydown", (event) => this.#key(event));
    this.#input.addEventListener("blur", () => this.end());
    sheet.td(sheet.active).replaceChildren(this.#input);
    this.#input.focus({ preventScroll: true });
    if (!fresh) this.#input.select();
  }

  #type() {
    const { row, id, key } = this.#session;
    this.#session.typed = true;
    this.#sheet.on.edit(row, id, fieldValue(this.#input.value) ?? "", key);
  }

  /** Closes the field; what was typed stands already. */
  end() {
    if (this.#input === null) return;
    const input = this.#input;
    const td = input.parentNode;
    const focused = input === document.activeElement;
    this.#input = null;
    this.#session = null;
    input.remove();
    this.#sheet.show(this.#sheet.view);
    if (focused) td?.focus({ preventScroll: true });
  }

  #takeBack() {
    const { typed } = this.#session;
    this.end();
    if (typed) this.#sheet.on.takeBack();
    this.#sheet.focus();
  }

  #key(event) {
    event.stopPropagation();
    const { key, shiftKey } = event;
    const sheet = this.#sheet;
    const leave = (down, right) => {
      event.preventDefault();
      this.end();
      sheet.step(down, right);
    };
    if (event.isComposing) return;
    if ((event.ctrlKey || event.metaKey) && !event.altKey && ["z", "y"].includes(key.toLowerCase())) {
      event.preventDefault();
      if (this.#session.typed) this.#takeBack();
      else {
        this.end();
        sheet.on.history(key.toLowerCase() === "y" || shiftKey ? "redo" : "undo");
        sheet.focus();
      }
    } else if (key === "Escape") this.#takeBack();
    else if (key === "F2") this.#session.fresh = false;
    else if (key === "Enter") {
      event.preventDefault();
      this.end();
      sheet.enter(shiftKey);
    } else if (key === "Tab") {
      event.preventDefault();
      this.end();
      sheet.tab(shiftKey, true);
    } else if (key === "ArrowUp") leave(-1, 0);
    else if (key === "ArrowDown") leave(1, 0);
    else if (this.#session.fresh && key === "ArrowLeft") leave(0, -1);
    else if (this.#session.fresh && key === "ArrowRight") leave(0, 1);
  }
}
