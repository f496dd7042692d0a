// The blade file's text: line numbers, marked faults, and the way from a fault to its line.

import { faultPlace, textOffset } from "./format.js";

export class Editor {
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
      number.textContent = n;
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

/** Fills a list with faults; those with a place in the text are buttons that lead there. */
export function listFaults(list, faults, onJump) {
  list.replaceChildren(
    ...faults.map((fault) => {
      const item = document.createElement("li");
      const place = faultPlace(fault);
      const words = place === "" ? fault.message : `${place}: ${fault.message}`;
      if (fault.line === null || !onJump) {
        item.textContent = words;
      } else {
        const button = document.createElement("button");
        button.type = "button";
        button.textContent = words;
        button.addEventListener("click", () => onJump(fault));
        item.append(button);
      }
      return item;
    }),
  );
  list.hidden = faults.length === 0;
}
