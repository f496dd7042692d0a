// The blade under edit, as plain data in the keys and units of the blade file, with its history.
// Values may be faulty: what a field holds is kept as it is, and the package says what is wrong.

import { at } from "../lib/dom.js";
import { NEUTRAL } from "../lib/what-if.js";

/** The choice of a blade of the user's own, in the list of blades. */
export const OWN = "";
/** Edits of the same field within this time are one step of the history. */
const SAME_STEP_MS = 1_500;
/** Steps that can be undone. */
const MOST_STEPS = 200;

/** The value at a path such as `distribution.mass[3]`. */
export function valueAt(doc, path) {
  return steps(path).reduce((at, step) => at?.[step], doc);
}

/** Sets the value at a path, or removes it where `value` is undefined; makes tables on the way. */
export function setAt(doc, path, value) {
  const way = steps(path);
  const last = way.pop();
  const table = way.reduce((at, step) => (at[step] ??= {}), doc);
  if (value === undefined) delete table[last];
  else table[last] = value;
}

function steps(path) {
  return path
    .split(/\.|\[|\]/)
    .filter((step) => step !== "")
    .map((step) => (/^\d+$/.test(step) ? Number(step) : step));
}

/** Makes the document of the state, which alone changes `doc`, `text`, `draft` and `choice`. */
export function createDocument(store) {
  let past = [];
  let future = [];
  let step = { key: null, time: -Infinity };
  let which = 0; // the blade that is edited, of those opened

  const now = () => {
    const { doc, text, choice, draft, textFaults, keptAs } = store.get();
    return { entry: { doc, text, choice, draft, textFaults, keptAs }, which };
  };
  // A text that was no blade is gone with the next one.
  const show = (entry, more = {}) =>
    store.set({ draft: null, textFaults: [], ...entry, ...more, canUndo: past.length > 0, canRedo: future.length > 0 });

  function remember(key) {
    const time = performance.now();
    const same = key !== null && key === step.key && time - step.time < SAME_STEP_MS;
    step = { key, time };
    if (same || store.get().doc === null) return;
    const { entry, which } = now();
    // Half a word on the way to a text that is a blade again is no step.
    past.push({ entry: key === "text" ? { ...entry, draft: null, textFaults: [] } : entry, which });
    past = past.slice(-MOST_STEPS);
    future = [];
  }

  /** Shows the last of one list; what stood there goes to the other. */
  function travel(from, to) {
    const there = from.pop();
    if (there === undefined) return;
    to.push(now());
    step = { key: null, time: -Infinity };
    const other = there.which !== which;
    which = there.which;
    show(there.entry, other ? { whatIf: NEUTRAL } : {}); // changes are of the blade that they were made beside
  }

  return {
    /** Takes another blade in; `text` is its file, where there is one. Typing with one `key` is one step. */
    open(doc, { choice, text = null }, key = null, more = {}) {
      remember(key);
      if (more.whatIf !== undefined) which++;
      show({ doc, text, choice }, more);
    },
    /** Puts the same blade in another form in its place. */
    replace(doc, more = {}) {
      remember(null);
      show({ doc: structuredClone(doc), text: null, choice: OWN }, more);
    },
    /** Changes a copy of the blade; edits with the same `key` in a row are one step. */
    edit(change, key = null, more = {}) {
      const { doc } = store.get();
      if (doc === null) return;
      const next = structuredClone(doc);
      change(next);
      if (JSON.stringify(next) === JSON.stringify(doc)) return;
      remember(key);
      if (more.whatIf !== undefined) which++;
      show({ doc: next, text: null, choice: OWN }, more);
    },
    undo: () => travel(past, future),
    redo: () => travel(future, past),
  };
}

/** Buttons and keys of the history. */
export function startHistory(store, blade) {
  at("undo").addEventListener("click", () => blade.undo());
  at("redo").addEventListener("click", () => blade.redo());
  addEventListener("keydown", (event) => {
    if (!(event.ctrlKey || event.metaKey) || event.altKey) return;
    const key = event.key.toLowerCase();
    if (key !== "z" && key !== "y") return;
    // The text has a history of its own while it is typed in.
    if (event.target instanceof HTMLTextAreaElement) return;
    event.preventDefault();
    if (key === "y" || event.shiftKey) blade.redo();
    else blade.undo();
  });
  store.subscribe((state, changed) => {
    if (changed.has("canUndo")) at("undo").disabled = !state.canUndo;
    if (changed.has("canRedo")) at("redo").disabled = !state.canRedo;
  });
}
