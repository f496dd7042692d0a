// Where the blade's text comes from: the built-in list, a file, or the editor.

import { at } from "./dom.js";
import { Editor } from "./editor.js";

/** The choice of a text of the user's own. */
export const OWN = "";
/** The choice of the first visit. */
export const FIRST_BLADE = "tm4760";

const TYPING_MS = 250;

/** Makes list, file button, dropping and editor work; returns the editor and what loads a text. */
export function startBlade(store) {
  let typing;
  const editor = new Editor(at("editor"), (text) => {
    clearTimeout(typing);
    typing = setTimeout(() => store.set({ text, choice: OWN }), TYPING_MS);
  });

  function load(text, choice) {
    clearTimeout(typing);
    editor.value = text;
    store.set({ text, choice, speed: null });
  }

  async function openFile(file) {
    // A text area holds line feeds only; places of faults are counted in what it holds.
    if (file) load((await file.text()).replaceAll("\r\n", "\n"), OWN);
  }

  at("blade-choice").addEventListener("change", ({ target }) => {
    const built = store.get().library.find((blade) => blade.name === target.value);
    if (built) load(built.toml, built.name);
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
  return { editor, load };
}
