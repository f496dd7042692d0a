// What the page remembers from visit to visit: the user's own blades, each with its view.

import { OWN } from "../blade/document.js";
import { at } from "../lib/dom.js";
import { isNeutral } from "../lib/scale.js";
import { pack, unpack } from "./pack.js";

const KEY = "bladefan-blades";
/** So many blades are kept, the newest first. */
const MOST = 8;
const WAIT_MS = 400;
/** Values in the list of blades that are the user's own. */
const PREFIX = "mine:";

function read() {
  try {
    const kept = JSON.parse(localStorage.getItem(KEY) ?? "[]");
    const good = (entry) => typeof entry?.id === "string" && typeof entry.packed === "string" && typeof entry.name === "string" && Number.isFinite(entry.time);
    return Array.isArray(kept) ? kept.filter(good).slice(0, MOST) : [];
  } catch {
    return []; // storage is switched off, or holds something else
  }
}

function write(entries) {
  // Where there is no room, the oldest go first.
  for (let kept = entries.slice(0, MOST); kept.length > 0; kept = kept.slice(0, -1)) {
    try {
      localStorage.setItem(KEY, JSON.stringify(kept));
      return;
    } catch {
      // try with fewer
    }
  }
}

const when = (time) => new Intl.DateTimeFormat("en-GB", { dateStyle: "medium", timeStyle: "short" }).format(time);

/** Keeps own blades from now on; returns what brings the last one back, true where there was one. */
export function startSession(store, open, say) {
  let id = null;
  let waiting;
  const choice = at("blade-choice");

  function list() {
    choice.querySelector("optgroup")?.remove();
    const entries = read();
    if (entries.length === 0) return;
    const group = Object.assign(document.createElement("optgroup"), { label: "Yours, kept in this browser" });
    group.append(...entries.map((entry) => new Option(`${entry.name}, ${when(entry.time)}`, PREFIX + entry.id)));
    choice.append(group);
  }

  async function keep() {
    const state = store.get();
    if (state.doc === null || (state.choice !== OWN && isNeutral(state.whatIf))) return;
    const packed = await pack(state);
    // The same blade and view, as when a link is opened again, is not kept twice.
    id ??= read().find((entry) => entry.packed === packed)?.id ?? `${Date.now()}-${Math.random()}`;
    const name = typeof state.doc.name === "string" && state.doc.name !== "" ? state.doc.name.slice(0, 60) : "blade without a name";
    write([{ id, name, time: Date.now(), packed }, ...read().filter((entry) => entry.id !== id)]);
    list();
  }

  async function bring(entry) {
    try {
      const { blade, view } = await unpack(entry.packed);
      const opened = await open(blade, OWN, { view });
      if (opened) id = entry.id;
      return opened;
    } catch {
      say("The kept blade cannot be read any more.");
      return false;
    }
  }

  at("forget").addEventListener("click", () => {
    const count = read().length;
    clearTimeout(waiting);
    id = null;
    try {
      localStorage.removeItem(KEY);
    } catch {
      // nothing was kept
    }
    list();
    at("download").open = false;
    say(count === 0 ? "No blade was kept." : "The blades kept in this browser are forgotten; the one on the page is still here.");
  });
  choice.addEventListener("change", () => {
    const entry = read().find((entry) => PREFIX + entry.id === choice.value);
    if (entry) bring(entry);
  });
  store.subscribe((state, changed) => {
    if (changed.has("opened")) id = null; // another blade: what was kept of the last one stays
    if (changed.has("library")) list();
    clearTimeout(waiting);
    waiting = setTimeout(keep, WAIT_MS);
  });
  addEventListener("pagehide", () => {
    clearTimeout(waiting);
    keep();
  });

  return async () => {
    const [last] = read();
    if (!last || !(await bring(last))) return false;
    say(`Your blade is back as you left it, ${when(last.time)}. The built-in blades are in the list.`);
    return true;
  };
}
