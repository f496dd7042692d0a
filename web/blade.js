// Where a blade comes from: the built-in list, a file, a drop, or the text that is typed.

import { OWN } from "./document.js";
import { at } from "./dom.js";
import { Editor, listFaults } from "./editor.js";
import { faultPlace, textFormat } from "./format.js";
import { NEUTRAL } from "./scale.js";

/** The choice of the first visit. */
export const FIRST_BLADE = "tm4760";

const TYPING_MS = 250;
/** A blade file of a thousand stations has some hundred kilobytes. */
const LARGEST_FILE = 4_000_000;

/** Makes list, file button, dropping and text work; returns what opens a blade's text. */
export function startBlade(store, client, blade, say) {
  let typing;
  let begun = false;
  let shown = null; // the text that stands in the editor and the blade it is of
  const editor = new Editor(at("editor"), (text) => {
    clearTimeout(typing);
    typing = setTimeout(() => take(text, OWN, { key: "text" }), TYPING_MS);
  });

  /** Opens a text: a blade where it is one, with a view of it; else its faults beside it. Says whether nothing newer came between. */
  async function take(text, choice, { key = null, view = {} } = {}) {
    // A built-in blade is there as it would be read.
    const built = store.get().library.find(({ name, toml }) => name === choice && toml === text);
    begun = true;
    if (built) client.drop("parse"); // what is still being read is no longer wanted
    const result = built ? { status: "ok", value: structuredClone(built.blade) } : await client.call("parse", "parse_blade", text);
    if (result === null) return false;
    const typed = key !== null;
    clearTimeout(typing);
    if (!typed) editor.value = text;
    shown = text;
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

  /** The text tab shows the blade as it stands in the fields. */
  async function write(doc, text) {
    if (text === null) {
      const written = await client.call("write", "write_blade", doc, "toml");
      if (written === null) return;
      // A blade with faults has no file in TOML yet; JSON holds whatever the fields hold.
      text = written.status === "ok" ? written.value : `${JSON.stringify(doc, null, 1)}\n`;
    }
    if (store.get().doc !== doc || text === shown) return;
    shown = text;
    editor.value = text;
    store.set({ textFaults: [] });
  }

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

  function showTextFaults({ textFaults }) {
    editor.mark(textFaults);
    listFaults(at("faults"), textFaults, (fault) => editor.jump(fault.line, fault.column));
    const count = textFaults.length;
    const words = count === 1 ? "1 fault" : `${count} faults`;
    at("fault-summary").textContent = count > 0 ? `${words}; first at ${faultPlace(textFaults[0]) || "the text"}` : "";
  }

  store.subscribe((state, changed) => {
    if (changed.has("textFaults")) showTextFaults(state);
    if (state.tab === "text" && state.doc !== null && (changed.has("tab") || changed.has("doc") || changed.has("text"))) write(state.doc, state.text);
    if (changed.has("text") || changed.has("tab")) {
      at("text-note").textContent =
        state.text === null && state.doc !== null
          ? "The blade as a file, written from the fields. Comments of an opened file are not kept once a field is changed."
          : `The blade as a file, ${textFormat(state.text ?? "") === "json" ? "JSON" : "TOML"}. What is typed here is solved, too.`;
    }
  });

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
