// The element of a drawing of `chart_svg`, patched: changed in place where only numbers and words differ: what
// stays need not be read, inserted and laid out again at every step of a slider.

import { SVG } from "../lib/dom.js";
import { parsedSvg } from "../lib/trusted.js";

const ATTRIBUTE = / ([\w-]+)="([^"]*)"/g;
/** A drawing has a tag or a text on every line; what precedes the attributes of an opening tag. */
const OPENING = /^<\w+/;

function parse(text) {
  const parsed = parsedSvg(text);
  const root = parsed.documentElement;
  if (root.localName !== "svg" || root.namespaceURI !== SVG || parsed.querySelector("parsererror") !== null) {
    throw new Error("the drawing is not an SVG");
  }
  return document.adoptNode(root);
}

/** The attributes that differ between two lines; null where more than their values does. */
function changes(before, after) {
  const [old, made] = [before, after].map((line) => [...line.matchAll(ATTRIBUTE)]);
  const alike = old.length === made.length && old.every(([, name], i) => name === made[i][1]);
  if (!alike || before.replace(ATTRIBUTE, "") !== after.replace(ATTRIBUTE, "")) return null;
  return made.filter(([, , value], i) => value !== old[i][2]).map(([, name, value]) => [name, value]);
}

/** Whether a line is a text of one line. */
const isText = (lines, at) => !lines[at].startsWith("<") && [lines[at - 1], lines[at + 1]].every((line) => line?.startsWith("<"));

export class Drawing {
  root;
  #lines;
  /** The element that each line opens or is the text of. */
  #elements;

  constructor(text) {
    this.root = parse(text);
    this.#lines = text.split("\n");
    const elements = [this.root, ...this.root.querySelectorAll("*")];
    let opened = -1;
    this.#elements = this.#lines.map((line) => elements[OPENING.test(line) ? ++opened : opened]);
    if (opened !== elements.length - 1) this.#lines = []; // not one tag a line: never changed in place
  }

  /** Becomes another drawing, if that has the same elements with the same attributes; says whether it did. */
  become(text) {
    const lines = text.split("\n");
    if (lines.length !== this.#lines.length) return false;
    const steps = [];
    for (const [i, line] of lines.entries()) {
      const before = this.#lines[i];
      if (line === before) continue;
      if (line.includes("&")) return false; // its characters would have to be decoded
      const element = this.#elements[i];
      if (OPENING.test(line) && OPENING.test(before)) {
        const values = changes(before, line);
        if (values === null) return false;
        steps.push(() => values.forEach(([name, value]) => element.setAttribute(name, value)));
      } else if (isText(lines, i) && isText(this.#lines, i) && element.localName === "text") {
        steps.push(() => (element.firstChild.data = `\n${line}\n`));
      } else return false;
    }
    for (const step of steps) step();
    this.#lines = lines;
    return true;
  }
}
