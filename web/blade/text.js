// The blade file's text in its tab: line numbers, marked faults, and the way from a fault to its line.

import { at } from "../lib/dom.js";
import { faultPlace, listFaults } from "../lib/faults.js";
import { textFormat } from "../lib/format.js";

const TYPING_MS = 250;

class Editor {
  #text;
  #gutter;
  #marks;
  #lineHeight;
  #padding;
  #lines = 0;
  #faultLines = new Set();

  constructor(root, onInput) {
    this.#text = root.querySelector("textarea");
    this.#gutter = root.querySelector(".gutter > div");
    this.#marks = root.querySelector(".marks > div");
    const style = getComputedStyle(this.#text);
    this.#lineHeight = parseFloat(style.lineHeight);
    this.#padding = parseFloat(style.paddingTop);
    this.#text.addEventListener("input", () => {
      this.#showLines();
      onInput(this.#text.value);
    });
    this.#text.addEventListener("scroll", () => this.#scroll());
  }

  get value() {
    return this.#text.value;
  }

  /** Puts a text in, without telling anyone. */
  set value(text) {
    this.#text.value = text;
    this.#text.scrollTo(0, 0);
    this.#text.setSelectionRange(0, 0);
    this.#showLines();
    this.#scroll();
  }

  /** Marks the lines of these faults. */
  mark(faults) {
    this.#faultLines = new Set(faults.map((fault) => fault.line).filter((line) => line !== null));
    this.#text.setAttribute("aria-invalid", String(faults.length > 0));
    this.#marks.replaceChildren(
      ...[...this.#faultLines].map((line) => {
        const mark = document.createElement("div");
        mark.className = "mark";
        mark.style.top = `${this.#padding + (line - 1) * this.#lineHeight}px`;
        mark.style.height = `${this.#lineHeight}px`;
        return mark;
      }),
    );
    this.#showLines(true);
  }

  /** Brings a place into view, selected from there to the end of its line. */
  jump(line, column) {
    const start = textOffset(this.#text.value, line, column ?? 1);
    const end = this.#text.value.indexOf("\n", start);
    this.#text.focus({ preventScroll: true });
    this.#text.setSelectionRange(start, end < 0 ? this.#text.value.length : end);
    this.#text.scrollTop = (line - 1) * this.#lineHeight - this.#text.clientHeight / 3;
    this.#text.scrollIntoView({ block: "nearest" });
  }

  #showLines(force = false) {
    const lines = this.#text.value.split("\n").length;
    if (lines === this.#lines && !force) return;
    this.#lines = lines;
    const numbers = document.createDocumentFragment();
    for (let n = 1; n <= lines; n++) {
      const number = document.createElement("span");
      number.textContent = String(n);
      if (this.#faultLines.has(n)) number.className = "fault";
      numbers.append(number);
    }
    this.#gutter.replaceChildren(numbers);
  }

  #scroll() {
    const shift = `translateY(${-this.#text.scrollTop}px)`;
    this.#gutter.style.transform = shift;
    this.#marks.style.transform = shift;
  }
}

/** Offset in UTF-16 units of a line and column that count characters from 1. */
export function textOffset(text, line, column) {
  let offset = 0;
  for (let n = 1; n < line; n++) {
    const end = text.indexOf("\n", offset);
    if (end < 0) break;
    offset = end + 1;
  }
  for (let n = 1; n < column && offset < text.length && text[offset] !== "\n"; n++) {
    offset += text.codePointAt(offset) > 0xffff ? 2 : 1;
  }
  return offset;
}

function noteOf({ doc, text, draft }) {
  if (draft !== null) return "This text is no blade yet; its faults stand below. Fields, charts and numbers are those of the blade before.";
  if (text === null && doc !== null)
    return "The blade as a file, written from the fields. Comments of an opened file are not kept once a field is changed.";
  return `The blade as a file, ${textFormat(text ?? "") === "json" ? "JSON" : "TOML"}. What is typed here is solved, too.`;
}

/** Makes the text tab; `onTyped` hears of what is typed, some time after. */
export function startText(store, client, onTyped) {
  let typing = null;
  let shown = null; // the text that stands in the editor
  const editor = new Editor(at("editor"), (text) => {
    clearTimeout(typing);
    typing = setTimeout(() => {
      typing = null;
      onTyped(text);
    }, TYPING_MS);
  });

  // What is typed and not read yet is kept where the page may be on its way out.
  function flush() {
    if (typing === null || store.get().doc === null) return;
    shown = editor.value;
    store.set({ draft: shown });
  }
  addEventListener("pagehide", flush);
  document.addEventListener("visibilitychange", () => document.hidden && flush());

  /** The text tab shows the text that is no blade yet, else the blade as it stands in the fields. */
  async function write({ doc, text: file, draft }) {
    let text = draft ?? file;
    if (text === null) {
      const written = await client.call("write", "write_blade", doc, "toml");
      if (written === null) return;
      // A blade with faults has no file in TOML yet; JSON holds whatever the fields hold.
      text = written.status === "ok" ? written.value : `${JSON.stringify(doc, null, 1)}\n`;
    }
    const now = store.get();
    if (now.doc !== doc || now.draft !== draft || text === shown) return;
    shown = text;
    editor.value = text;
    editor.mark(now.textFaults);
  }

  function showTextFaults({ textFaults }) {
    editor.mark(textFaults);
    listFaults(at("faults"), textFaults, (fault) => editor.jump(fault.line, fault.column));
    const count = textFaults.length;
    const words = count === 1 ? "1 fault" : `${count} faults`;
    at("fault-summary").textContent = count > 0 ? `${words}; first at ${faultPlace(textFaults[0]) || "the text"}` : "";
  }

  store.subscribe((state, changed) => {
    const any = (...keys) => keys.some((key) => changed.has(key));
    if (any("textFaults")) showTextFaults(state);
    if (state.tab === "text" && state.doc !== null && any("tab", "doc", "text", "draft")) write(state);
    if (any("text", "tab", "draft")) at("text-note").textContent = noteOf(state);
  });

  return {
    /** A text was opened; one that was typed stands here already. */
    take(text, typed) {
      clearTimeout(typing);
      typing = null;
      if (typed && editor.value === text) shown = text;
    },
  };
}
