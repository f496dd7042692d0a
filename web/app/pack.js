// Blade and view as plain data, for what the page remembers, and as one compressed text, for the share link.

import { DOFS } from "../lib/dof-toggles.js";
import { NEUTRAL } from "../lib/what-if.js";

const VERSION = "1";
/** Longest text that is unpacked, and longest that it may unpack to. */
const LONGEST_PACKED = 400_000;
const LONGEST_PLAIN = 4_000_000;
/** Most rotor speeds of a window, and most frequencies of one kind: speeds × modes. More is refused, whoever asks. */
const MOST_SPEEDS = 2_001;
const MOST_FREQUENCIES = MOST_SPEEDS * 20;

const finite = (value) => typeof value === "number" && Number.isFinite(value);
const oneOf =
  (...choices) =>
  (value) =>
    choices.includes(value);
const text = (longest) => (value) => typeof value === "string" && value.length <= longest;
const table = (value) => typeof value === "object" && value !== null && !Array.isArray(value);
const tableOf = (keys, good) => (value) => table(value) && Object.entries(value).every(([key, entry]) => keys.includes(key) && good(entry));
const listOf = (length, good) => (value) => Array.isArray(value) && length.includes(value.length) && value.every(good);
const someOf = (choices) => (value) =>
  Array.isArray(value) && value.length > 0 && new Set(value).size === value.length && value.every((entry) => choices.includes(entry));
const orNull = (good) => (value) => value === null || good(value);
const positive = (value) => finite(value) && value > 0;
const notNegative = (value) => finite(value) && value >= 0;

/** What of the state makes a view, with the rule that each value must meet. */
const VIEW = {
  tab: oneOf("fan", "shapes", "converge", "stations", "text"),
  speed: orNull((value) => table(value) && notNegative(value.value) && oneOf("rad/s", "rpm", "Hz")(value.unit)),
  speedUnit: oneOf("rad/s", "rpm", "Hz"),
  frequencyUnit: oneOf("rad/s", "Hz", "rpm", "per-rev"),
  dofs: someOf(DOFS),
  closeDofs: someOf(DOFS),
  band: listOf([2], notNegative),
  window: orNull(tableOf(["speeds", "frequencies"], listOf([2, 3], notNegative))),
  chosen: text(8),
  model: oneOf("auto", "uncoupled", "coupled"),
  options: tableOf(["modes", "functions", "harmonics", "basis"], text(12)),
  measured: text(200_000),
  whatIf: (value) =>
    table(value) &&
    tableOf(Object.keys(NEUTRAL.factors), positive)(value.factors) &&
    orNull(finite)(value.from) &&
    orNull(finite)(value.to) &&
    (value.from ?? -Infinity) < (value.to ?? Infinity) &&
    tableOf(DOFS, notNegative)(value.offsets) &&
    tableOf(DOFS, positive)(value.springs) &&
    orNull(text(8))(value.length ?? null),
};

/**
 * Why a view is more work than a page should be given by others, in words; null where it is not.
 * @param {{ window?: { speeds?: number[] }, options?: { modes?: string } }} view
 */
function tooMuch({ window, options }) {
  const count = window?.speeds?.[2];
  if (count === undefined) return null;
  const modes = Number(options?.modes) || 5;
  if (count <= MOST_SPEEDS && count * modes <= MOST_FREQUENCIES) return null;
  return `It asks for ${count} rotor speeds with ${modes} modes each; at most ${Math.min(MOST_SPEEDS, Math.floor(MOST_FREQUENCIES / modes))} are taken. The whole chart is shown instead.`;
}

async function through(bytes, transform, longest) {
  const reader = new Blob([bytes]).stream().pipeThrough(transform).getReader();
  const parts = [];
  let length = 0;
  for (;;) {
    const { done, value } = await reader.read();
    if (done) break;
    length += value.length;
    if (length > longest) {
      await reader.cancel();
      throw new Error("it unpacks to more than a blade can hold");
    }
    parts.push(value);
  }
  return new Uint8Array(await new Blob(parts).arrayBuffer());
}

const toBase64 = (bytes) => {
  let letters = "";
  for (let i = 0; i < bytes.length; i += 0x8000) letters += String.fromCharCode(...bytes.subarray(i, i + 0x8000));
  return btoa(letters).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
};
const fromBase64 = (letters) => Uint8Array.from(atob(letters.replaceAll("-", "+").replaceAll("_", "/")), (letter) => letter.charCodeAt(0));

/** The blade as its text or as it stands in the fields, with the view of it, and what is beside it while it is not finished. */
export function contentOf(state) {
  const { doc, text: file, choice, draft = null, faults = [], good = null } = state;
  const view = Object.fromEntries(Object.keys(VIEW).map((key) => [key, state[key]]));
  const unfinished = { ...(draft === null ? {} : { draft }), ...(faults.length === 0 || good === null || good === doc ? {} : { good }) };
  return { blade: file ?? doc, choice, view, ...unfinished };
}

/** The same, packed. */
export async function pack(state) {
  const bytes = await through(new TextEncoder().encode(JSON.stringify(contentOf(state))), new CompressionStream("deflate-raw"), Infinity);
  return `${VERSION}.${toBase64(bytes)}`;
}

/** Content that came from anywhere, with what is known and whole of it; throws words where it holds no blade. */
export function checked(given) {
  if (!table(given) || !(table(given.blade) || text(LONGEST_PLAIN)(given.blade))) throw new Error("it holds no blade");
  const offered = table(given.view) ? given.view : {};
  // The rest keeps its default.
  const view = Object.fromEntries(
    Object.entries(VIEW)
      .filter(([key, good]) => Object.hasOwn(offered, key) && good(offered[key]))
      .map(([key]) => [key, offered[key]]),
  );
  if (view.model === undefined) {
    view.model = "auto";
    // An older page kept the number of modes of each kind where it was left alone, too.
    if (view.options?.modes === "5") view.options = { ...view.options, modes: undefined };
  }
  if (view.whatIf) view.whatIf = { ...view.whatIf, length: view.whatIf.length ?? null };
  const refused = tooMuch(view);
  if (refused !== null) view.window = null;
  return {
    blade: given.blade,
    choice: text(60)(given.choice) ? given.choice : "",
    view,
    good: table(given.good) ? given.good : null,
    draft: text(LONGEST_PLAIN)(given.draft) ? given.draft : null,
    refused,
  };
}

/** What was packed, as `checked` gives it; throws words for the user where it is broken. */
export async function unpack(packed) {
  const [version, letters = ""] = packed.split(".");
  if (!/^\d+$/.test(version) || !/^[\w-]+$/.test(letters)) throw new Error("it is cut off or changed");
  if (version !== VERSION) throw new Error("it was made by another version of this page");
  if (letters.length > LONGEST_PACKED) throw new Error("it is longer than a blade can be");
  let given;
  try {
    const bytes = await through(fromBase64(letters), new DecompressionStream("deflate-raw"), LONGEST_PLAIN);
    given = JSON.parse(new TextDecoder("utf-8", { fatal: true }).decode(bytes));
  } catch (error) {
    throw error.message.startsWith("it unpacks") ? error : new Error("it is cut off or changed");
  }
  return checked(given);
}
