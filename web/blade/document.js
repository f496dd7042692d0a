// The blade under edit, as plain data in the keys and units of the blade file, with its history.
// Values may be faulty: what a field holds is kept as it is, and the package says what is wrong.

import { at } from "../lib/dom.js";

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
  return path.split(/\.|\[|\]/).filter((step) => step !== "").map((step) => (/^\d+$/.test(step) ? Number(step) : step));
}

/** Makes the document of the state, which alone changes `doc`, `text` and `choice`. */
export function createDocument(store) {
  let past = [];
  let future = [];
  let step = { key: null, time: -Infinity };

  const now = () => {
    const { doc, text, choice } = store.get();
    return { doc, text, choice };
  };
  const show = (entry, more = {}) => store.set({ ...entry, ...more, canUndo: past.length > 0, canRedo: future.length > 0 });

  function remember(key) {
    const time = performance.now();
    const same = key !== null && key === step.key && time - step.time < SAME_STEP_MS;
    step = { key, time };
    if (same || store.get().doc === null) return;
    past.push(now());
    past = past.slice(-MOST_STEPS);
    future = [];
  }

  /** Shows the last of one list; what stood there goes to the other. */
  function travel(from, to) {
    const entry = from.pop();
    if (entry === undefined) return;
    to.push(now());
    step = { key: null, time: -Infinity };
    show(entry);
  }

  return {
    /** Takes another blade in; `text` is its file, where there is one. Typing with one `key` is one step. */
    open(doc, { choice, text = null }, { key = null, ...more } = {}) {
      remember(key);
      show({ doc, text, choice }, more);
    },
    /** Changes a copy of the blade; edits with the same `key` in a row are one step. */
    edit(change, key = null) {
      const { doc } = store.get();
      if (doc === null) return;
      const next = structuredClone(doc);
      change(next);
      if (JSON.stringify(next) === JSON.stringify(doc)) return;
      remember(key);
      show({ doc: next, text: null, choice: OWN });
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
    if (event.target.closest?.("textarea") !== null && event.target instanceof HTMLTextAreaElement) return;
    event.preventDefault();
    if (key === "y" || event.shiftKey) blade.redo();
    else blade.undo();
  });
  store.subscribe((state, changed) => {
    if (changed.has("canUndo")) at("undo").disabled = !state.canUndo;
    if (changed.has("canRedo")) at("redo").disabled = !state.canRedo;
  });
}
