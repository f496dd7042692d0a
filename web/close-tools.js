// Which degrees of freedom mode shapes and convergence are drawn of: at first the chosen mode's.

import { at } from "./dom.js";

const DOFS = { F: "flap", L: "lag", T: "torsion" };
const TABS = ["shapes", "converge"];

/** The degree of freedom of a label such as "2F". */
const dofOf = (label) => DOFS[label.at(-1)];

export function startCloseTools(store) {
  const host = at("close-tools");
  const boxes = Object.values(DOFS).map((dof) => {
    const box = Object.assign(document.createElement("input"), { type: "checkbox", id: `close-${dof}`, value: dof });
    const label = Object.assign(document.createElement("label"), { className: "toggle" });
    label.dataset.dof = dof;
    label.append(box, dof);
    host.append(label);
    box.addEventListener("change", () => {
      const closeDofs = boxes.filter(({ checked }) => checked).map(({ value }) => value);
      if (closeDofs.length === 0) box.checked = true; // one at least
      else store.set({ closeDofs });
    });
    return box;
  });
  const show = ({ tab, closeDofs }) => {
    host.hidden = !TABS.includes(tab);
    for (const box of boxes) box.checked = closeDofs.includes(box.value);
  };
  store.subscribe((state, changed) => {
    if (changed.has("chosen")) {
      const dof = dofOf(state.chosen);
      if (!state.closeDofs.includes(dof)) store.set({ closeDofs: [dof] });
    }
    if (changed.has("tab") || changed.has("closeDofs")) show(store.get());
  });
  show(store.get());
}
