// Where a blade comes from: the built-in list, a file, a drop, or the text that is typed.

import { at } from "../lib/dom.js";
import { NEUTRAL } from "../lib/scale.js";
import { OWN } from "./document.js";
import { startText } from "./text.js";

/** A blade file of a thousand stations has some hundred kilobytes. */
const LARGEST_FILE = 4_000_000;

/** Makes list, file button, dropping and text work; returns what opens a blade's text. */
export function startOpening(store, client, blade, say) {
  let begun = false;
  const editor = startText(store, client, (text) => take(text, OWN, { key: "text" }));

  /** Opens a text: a blade where it is one, with a view of it; else its faults beside it. Says whether nothing newer came between. */
  async function take(text, choice, { key = null, view = {} } = {}) {
    // A built-in blade is there as it would be read.
    const built = store.get().library.find(({ name, toml }) => name === choice && toml === text);
    begun = true;
    if (built) client.drop("parse"); // what is still being read is no longer wanted
    const result = built ? { status: "ok", value: structuredClone(built.blade) } : await client.call("parse", "parse_blade", text);
    if (result === null) return false;
    const typed = key !== null;
    editor.take(text, typed);
    if (result.status === "error") {
      store.set({ textFaults: result.faults, ...(typed ? {} : { tab: "text" }) });
      return true;
    }
    // Another blade starts unchanged and at its own nominal speed.
    const fresh = typed ? {} : { whatIf: NEUTRAL, speed: null, window: null, ...view, opened: store.get().opened + 1 };
    blade.open(result.value, { choice, text }, { key, textFaults: [], ...fresh });
    return true;
  }
  /** Whether anything was opened, or is being. */
  take.begun = () => begun;

  async function openFile(file) {
    if (!file) return;
    if (file.size > LARGEST_FILE) {
      say(`${file.name} has ${(file.size / 1e6).toFixed(0)} MB; a blade file has at most ${LARGEST_FILE / 1e6} MB. The blade on the page is unchanged.`);
      return;
    }
    // A text area holds line feeds only; places of faults are counted in what it holds.
    begun = true;
    take((await file.text()).replaceAll("\r\n", "\n"), OWN);
  }

  at("blade-choice").addEventListener("change", ({ target }) => {
    const built = store.get().library.find((blade) => blade.name === target.value);
    if (built) take(built.toml, built.name);
  });
  at("open-file").addEventListener("click", () => at("file-input").click());
  at("file-input").addEventListener("change", async ({ target }) => {
    await openFile(target.files[0]);
    target.value = ""; // the same file may be opened again
  });

  const holdsFile = (event) => event.dataTransfer?.types.includes("Files");
  addEventListener("dragover", (event) => {
    if (!holdsFile(event)) return;
    event.preventDefault();
    document.body.classList.add("dropping");
  });
  addEventListener("dragleave", (event) => {
    if (event.relatedTarget === null) document.body.classList.remove("dropping");
  });
  addEventListener("drop", (event) => {
    document.body.classList.remove("dropping");
    if (!holdsFile(event)) return;
    event.preventDefault();
    openFile(event.dataTransfer.files[0]);
  });
  return take;
}
