// The list of kept blades in the browser's storage, which may be full, switched off, or hold anything.

const KEY = "bladefan-blades";
/** What cannot be read goes here, lest it be lost or met again. */
const ASIDE = "bladefan-blades-unread";
/** So many blades are kept, the newest first. */
const MOST = 8;
const LONGEST_ASIDE = 200_000;
/** Farther from 1970 no clock goes [ms]. */
const LAST_TIME = 8.64e15;

const isGood = (entry) =>
  typeof entry?.id === "string" &&
  typeof entry.name === "string" &&
  Math.abs(entry.time) <= LAST_TIME &&
  (typeof entry.packed === "string" || (typeof entry.content === "object" && entry.content !== null));

function raw(key) {
  try {
    return localStorage.getItem(key);
  } catch {
    return null; // switched off
  }
}

function put(key, text) {
  try {
    localStorage.setItem(key, text);
    return true;
  } catch {
    return false; // full, or switched off
  }
}

function drop(key) {
  try {
    localStorage.removeItem(key);
  } catch {
    // nothing was kept
  }
}

/** All that stands in the list: {entries} that can be read and the {rest} as text, empty where there is none. */
function sorted() {
  const text = raw(KEY);
  if (text === null) return { entries: [], rest: [] };
  try {
    const list = JSON.parse(text);
    if (!Array.isArray(list)) return { entries: [], rest: [text] };
    return { entries: list.filter(isGood), rest: list.filter((entry) => !isGood(entry)).map((entry) => JSON.stringify(entry)) };
  } catch {
    return { entries: [], rest: [text] };
  }
}

/** The kept blades, the newest first: {id, name, time, content}, or `packed` as older pages kept them. */
export const kept = () => sorted().entries.slice(0, MOST);

/** Writes these; where there is no room the oldest go first. False where not even the newest is written. */
function write(entries) {
  for (let count = Math.min(MOST, entries.length); count > 0; count--) {
    if (put(KEY, JSON.stringify(entries.slice(0, count)))) return true;
  }
  return false;
}

function aside(texts) {
  put(ASIDE, `${texts.join("\n")}\n${raw(ASIDE) ?? ""}`.slice(0, LONGEST_ASIDE));
}

/** Keeps these in place of those that can be read; the others, be they of another page, are set aside. */
export function keepAll(entries) {
  const { rest } = sorted();
  if (rest.length > 0) aside(rest);
  return write(entries);
}

/** Takes what cannot be read out of the list; says how many that were. */
export function setAside() {
  const { entries, rest } = sorted();
  if (rest.length === 0) return 0;
  aside(rest);
  if (entries.length === 0) drop(KEY);
  else write(entries);
  return rest.length;
}

/** Takes one blade out of the list that turned out to be none. */
export function setOneAside(id) {
  const { entries } = sorted();
  aside(entries.filter((entry) => entry.id === id).map((entry) => JSON.stringify(entry)));
  const others = entries.filter((entry) => entry.id !== id);
  if (others.length === 0) drop(KEY);
  else write(others);
}

/** Forgets everything; says how many blades that were. */
export function forgetAll() {
  const { length } = kept();
  drop(KEY);
  drop(ASIDE);
  return length;
}
