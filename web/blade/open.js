// Where a blade comes from: the built-in list, a file, a drop, the text that is typed, or what was kept of it.

import { at } from "../lib/dom.js";
import { NEUTRAL, isNeutral, lengthOf } from "../lib/what-if.js";
import { OWN } from "./document.js";
import { isBladeShaped } from "./shape.js";
import { startText } from "./text.js";

/** A blade file of a thousand stations has some hundred kilobytes. */
const LARGEST_FILE = 4_000_000;
/** A kept blade with faults is not waited for longer than this to be drawn as it was without. */
const DRAWN_MS = 10_000;

/** Changes of a view, in the unit of the blade that they are of where they name none. */
const inUnits = ({ whatIf = NEUTRAL, ...view }, doc) => ({ ...view, whatIf: { ...whatIf, length: whatIf.length ?? lengthOf(doc) } });

/** Makes list, file button, dropping and text work; returns what opens a blade's text. */
export function startOpening(store, client, blade, say) {
  let begun = false;
  const editor = startText(store, client, (text) => take(text, OWN, { key: "text" }));

  /** Another blade starts unchanged and at its own nominal speed; a view says otherwise. */
  const afresh = (view, doc) => inUnits({ speed: null, window: null, keptAs: null, ...view, opened: store.get().opened + 1 }, doc);

  /** The page begins with a blade, whatever comes first. */
  function haveBlade() {
    const { doc, library, choice } = store.get();
    const first = library.find(({ name }) => name === choice) ?? library[0];
    const { draft, textFaults } = store.get();
    if (doc === null && first)
      blade.open(structuredClone(first.blade), { choice: first.name, text: first.toml }, null, { ...afresh({}, first.blade), draft, textFaults });
  }

  /** A text that is no blade: it stands in its tab with its faults, and the blade before stays where it was. */
  function refuse(text, faults, typed) {
    haveBlade();
    store.set({ draft: text, textFaults: faults, ...(typed ? {} : { tab: "text" }) });
    if (!typed) at("text-note").scrollIntoView({ block: "nearest" });
  }

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
      refuse(text, result.faults, typed);
      if (!typed)
        say(
          `This is no blade yet: ${result.faults.length === 1 ? "its fault stands" : `its ${result.faults.length} faults stand`} below the text. Charts and numbers are of the blade before.`,
        );
      return true;
    }
    blade.open(result.value, { choice: built ? choice : OWN, text }, key, typed ? retyped(result.value) : afresh(view, result.value));
    return true;
  }

  /** What-if is of the blade beside which it was set: another text begins without. */
  function retyped(doc) {
    const before = store.get();
    if (JSON.stringify(before.doc) === JSON.stringify(doc)) return {};
    if (!isNeutral(before.whatIf)) say("“What if” is set back: its changes were of the blade before.");
    return { whatIf: NEUTRAL };
  }

  /** Until the blade is drawn, or known to have faults. */
  const drawn = () =>
    new Promise((resolve) => {
      const stop = store.subscribe(({ drawing, modes, faults, solveFaults }) => {
        if ((drawing === null || modes === null) && faults.length + solveFaults.length === 0) return;
        stop();
        resolve();
      });
      setTimeout(resolve, DRAWN_MS);
    });

  /**
   * Brings back what was kept or sent: the blade as its text, or as it stood in the fields, with faults
   * perhaps, and then with `good`, the last one without; and a `draft`, text that is no blade. Says
   * whether nothing newer came between.
   */
  take.back = async ({ blade: given, choice, view = {}, good = null, draft = null }) => {
    if (typeof given === "string" || !isBladeShaped(given)) {
      const text = typeof given === "string" ? given : `${JSON.stringify(given, null, 1)}\n`;
      if (!(await take(text, choice, { view }))) return false;
    } else {
      begun = true;
      client.drop("parse");
      const sound = good !== null && isBladeShaped(good) ? good : given;
      blade.open(structuredClone(sound), { choice: OWN, text: null }, null, afresh(view, sound));
      const { doc } = store.get();
      if (sound !== given) {
        await drawn();
        if (store.get().doc !== doc) return false;
        blade.replace(given);
      }
    }
    if (draft === null) return true;
    return take(draft, OWN, { key: "draft" });
  };

  /** Whether anything was opened, or is being. */
  take.begun = () => begun;
  take.haveBlade = haveBlade;

  async function openFile(file) {
    if (!file) return;
    if (file.size > LARGEST_FILE) {
      say(
        `${file.name} has ${(file.size / 1e6).toFixed(0)} MB; a blade file has at most ${LARGEST_FILE / 1e6} MB. The blade on the page is unchanged.`,
      );
      return;
    }
    // A text area holds line feeds only; places of faults are counted in what it holds.
    begun = true;
    take((await file.text()).replaceAll("\r\n", "\n"), OWN);
  }

  const list = at("blade-choice");
  list.addEventListener("change", () => {
    const built = store.get().library.find((blade) => blade.name === list.value);
    if (built) take(built.toml, built.name);
  });
  const input = at("file-input");
  at("open-file").addEventListener("click", () => input.click());
  input.addEventListener("change", async () => {
    await openFile(input.files[0]);
    input.value = ""; // the same file may be opened again
  });

  at("drop-draft").addEventListener("click", () => store.set({ draft: null, textFaults: [] }));
  store.subscribe(({ draft }, changed) => changed.has("draft") && (at("drop-draft").hidden = draft === null));

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
