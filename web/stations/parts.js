// What the tab of stations is made of: choices, buttons, places to write in.

import { make } from "../lib/dom.js";
import { column } from "./columns.js";

const FORMS = { list: "at these radii", number: "one number", own: "radii of its own" };
const COMMANDS = [
  { name: "above", text: "Row above", keys: "Alt+Shift+ArrowUp" },
  { name: "below", text: "Row below", keys: "Alt+Shift+ArrowDown" },
  { name: "step", text: "Step here", words: "Step here: repeat this radius" },
  { name: "delete", text: "Delete rows", keys: "Alt+Delete" },
  { name: "up", text: "↑", words: "Move rows up", keys: "Alt+ArrowUp" },
  { name: "down", text: "↓", words: "Move rows down", keys: "Alt+ArrowDown" },
];
const KEYS = [
  ["Enter, Tab, arrows", "next cell; after typing, Tab goes on to the next row"],
  ["F2 or double click", "change what stands in the cell; Escape takes it back"],
  ["Shift with arrows, or drag", "select a block; Ctrl+A all"],
  ["Ctrl+C, Ctrl+X, Ctrl+V", "copy with all digits, cut, paste"],
  ["Delete", "clear"],
  ["Alt+↑, Alt+↓", "move rows"],
  ["Alt+Shift+↑, Alt+Shift+↓", "row above, row below"],
  ["Alt+Delete", "delete rows"],
];

/** Makes them all; nothing is bound yet. */
export function stationsParts() {
  const choice = make("select", { id: "stations-sheet" });
  const choiceField = make("label", { className: "field", textContent: "Sheet " }, choice);
  const pages = make("select", { id: "stations-page" });
  const pagesField = make("label", { className: "field", textContent: "Rows " }, pages);
  const buttons = Object.fromEntries(
    COMMANDS.map(({ name, text, words, keys }) => [
      name,
      make("button", {
        type: "button",
        textContent: text,
        dataset: { command: name },
        aria: { ...(words ? { label: words } : {}), ...(keys ? { keyshortcuts: keys } : {}) },
      }),
    ]),
  );
  const tools = make("div", { className: "stations-tools", aria: { role: "group", label: "Rows" } }, choiceField, ...Object.values(buttons));
  const scroll = make("div", { className: "sheet-scroll" });
  const long = make("p", { className: "note", id: "stations-long", hidden: true });
  const said = make("p", { className: "note", id: "stations-said", aria: { role: "status" } });
  const note = make("p", { className: "note cell-note", id: "cell-note" });
  const count = make("p", { className: "note", id: "stations-count", aria: { role: "status" } });
  const list = make("ul", { className: "fault-list", id: "stations-faults", aria: { label: "Faults of the stations" } });
  const profiles = make("div", { className: "profiles", aria: { role: "group", label: "Properties along the span" } });
  const keys = make(
    "details",
    { className: "keys" },
    make("summary", { textContent: "Keys" }),
    make("dl", {}, ...KEYS.flatMap(([key, words]) => [make("dt", { textContent: key }), make("dd", { textContent: words })])),
  );
  return { choice, choiceField, pages, pagesField, buttons, tools, scroll, long, said, note, count, list, profiles, keys };
}

/** The choice of how a property is given; `choose` gives the form that it has then. */
export function formSelect(id, choose) {
  const { name, optional } = column(id);
  const options = { ...FORMS, absent: optional ? "not given" : "missing" };
  const select = make(
    "select",
    { aria: { label: `${name} given` }, dataset: { form: id } },
    ...Object.entries(options).map(([form, words]) => new Option(words, form)),
  );
  const absent = /** @type {HTMLOptionElement} */ (select.querySelector('[value="absent"]'));
  absent.hidden = !optional;
  select.addEventListener("change", () => (select.value = choose(select.value)));
  return [select];
}

const NOW = {
  absent: "not given: 0",
  own: "on radii of its own: choose its sheet",
  number: "one number at all radii",
  list: "given at the common radii",
};
export const formWords = (id, form) => `The ${column(id).name} is now ${NOW[form]}.`;
