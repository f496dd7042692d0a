// What the page remembers from visit to visit: the user's own blades, each with its view.

import { OWN } from "../blade/document.js";
import { at } from "../lib/dom.js";
import { isNeutral } from "../lib/what-if.js";
import { checked, contentOf, unpack } from "./pack.js";
import { forgetAll, keepAll, kept, setAside, setOneAside } from "./storage.js";

const WAIT_MS = 400;
/** Values in the list of blades that are the user's own. */
const PREFIX = "mine:";

const when = (time) => new Intl.DateTimeFormat("en-GB", { dateStyle: "medium", timeStyle: "short" }).format(time);
const isOwn = ({ doc, choice, whatIf, draft }) => doc !== null && (choice !== OWN ? !isNeutral(whatIf) || draft !== null : true);

/**
 * Keeps own blades from now on; `onKept(content)` hears of each time. Returns what brings the last one
 * back, true where there was one.
 */
export function startSession(store, open, say, onKept) {
  let written = null; // as it was kept last
  let waiting = null;
  let before = store.get();
  let warned = false;
  let bringing = null; // the blade that is on its way back
  const choice = at("blade-choice");

  function list() {
    choice.querySelector("optgroup")?.remove();
    const entries = kept();
    if (entries.length === 0) return;
    const group = Object.assign(document.createElement("optgroup"), { label: "Yours, kept in this browser" });
    group.append(...entries.map((entry) => new Option(`${entry.name}, ${when(entry.time)}`, PREFIX + entry.id)));
    choice.append(group);
  }

  /** Everything is done before this returns: the page may be on its way out. */
  function keep(state) {
    clearTimeout(waiting);
    waiting = null;
    if (!isOwn(state)) return;
    // Half of it does not take the place of the whole.
    if (bringing !== null && state.keptAs === bringing) {
      waiting = setTimeout(() => keep(store.get()), WAIT_MS);
      return;
    }
    const content = contentOf(state);
    const plain = JSON.stringify(content);
    if (plain !== written) {
      const entries = kept();
      // The same blade and view, as when a link is opened again, is not kept twice.
      const id = state.keptAs ?? entries.find((entry) => JSON.stringify(entry.content) === plain)?.id ?? `${Date.now()}-${Math.random()}`;
      const name = typeof state.doc.name === "string" && state.doc.name !== "" ? state.doc.name.slice(0, 60) : "blade without a name";
      if (!keepAll([{ id, name, time: Date.now(), content }, ...entries.filter((entry) => entry.id !== id)])) return warn();
      written = plain;
      list();
      if (store.get().opened === state.opened) store.set({ keptAs: id });
    }
    onKept(plain);
  }

  function warn() {
    if (!warned) say("This browser keeps no blades: its storage is full or switched off. Save the blade as a file before you leave.");
    warned = true;
  }

  async function bring(entry) {
    bringing = entry.id;
    try {
      const content = entry.content ? checked(entry.content) : await unpack(entry.packed);
      return await open.back({ ...content, view: { ...content.view, keptAs: entry.id } });
    } catch {
      setOneAside(entry.id);
      list();
      say("The kept blade cannot be read any more. It is set aside.");
      return false;
    } finally {
      bringing = null;
    }
  }

  at("forget").addEventListener("click", () => {
    clearTimeout(waiting);
    [waiting, written] = [null, null];
    store.set({ keptAs: null });
    clearTimeout(waiting);
    waiting = null; // not kept again before it is changed
    const count = forgetAll();
    list();
    at("download").open = false;
    say(count === 0 ? "No blade was kept." : "The blades kept in this browser are forgotten; the one on the page is still here.");
  });
  choice.addEventListener("change", () => {
    const entry = kept().find((entry) => PREFIX + entry.id === choice.value);
    if (entry) bring(entry);
  });
  store.subscribe((state, changed) => {
    if (changed.has("opened")) {
      // Another blade: what was kept of the last one stays, with its last edits.
      if (waiting !== null) keep(before);
      written = null;
    }
    if (changed.has("library")) list();
    before = state;
    clearTimeout(waiting);
    // An address that holds a blade holds it as it was: what is edited is kept at once.
    waiting = setTimeout(() => keep(store.get()), location.hash.length > 1 ? 0 : WAIT_MS);
  });
  const flush = () => waiting !== null && keep(store.get());
  addEventListener("pagehide", flush);
  document.addEventListener("visibilitychange", () => document.hidden && flush());

  return async () => {
    const unread = setAside();
    const note =
      unread === 0 ? "" : `${unread === 1 ? "A kept blade cannot be read and is" : `${unread} kept blades cannot be read and are`} set aside. `;
    if (unread > 0) say(note);
    list();
    const [last] = kept();
    if (!last || !(await bring(last))) return false;
    say(`${note}Your blade is back as you left it, ${when(last.time)}. The built-in blades are in the list.`);
    return true;
  };
}
