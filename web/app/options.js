// The fields of the solution: how many modes, harmonics and functions, and which.

import { at, write } from "../lib/dom.js";

/** What a field holds where nobody has chosen. */
const untouched = (field) => (field instanceof HTMLInputElement ? field.defaultValue : field.options[0].value);

/** How many modes the package has found where their number was left to it: of each kind, or of a coupled blade in all. */
function foundModes({ model, modes }) {
  return model.kind === "coupled" ? modes.length : modes.filter(({ dof }) => dof === modes[0].dof).length;
}

/** Makes the fields; they set `options` of the state, each its own once it is changed. */
export function startOptions(store) {
  const fields = [.../** @type {NodeListOf<HTMLInputElement | HTMLSelectElement>} */ (document.querySelectorAll("[data-option]"))];

  function show({ options, modes }) {
    for (const field of fields) {
      const { option } = field.dataset;
      const left = option === "modes" && modes !== null ? String(foundModes(modes)) : untouched(field);
      if (field !== document.activeElement) field.value = options[option] ?? left;
    }
    if (modes !== null) write(at("modes-words"), modes.model.kind === "coupled" ? "Modes in all" : "Modes of each kind");
  }

  for (const field of fields) {
    field.addEventListener("input", () => store.set({ options: { ...store.get().options, [field.dataset.option]: field.value } }));
  }
  store.subscribe((state, changed) => (changed.has("options") || changed.has("modes")) && show(state));
}
