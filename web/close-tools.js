// Which degrees of freedom mode shapes and convergence are drawn of: at first the chosen mode's.

import { dofToggles } from "./chart-tools.js";
import { at } from "./dom.js";

const DOFS = { F: "flap", L: "lag", T: "torsion" };
const TABS = ["shapes", "converge"];

/** The degree of freedom of a label such as "2F". */
const dofOf = (label) => DOFS[label.at(-1)];

export function startCloseTools(store) {
  const host = at("close-tools");
  const toggles = dofToggles("close", (closeDofs) => store.set({ closeDofs }));
  host.append(...toggles.labels);
  const show = ({ tab, closeDofs }) => {
    host.hidden = !TABS.includes(tab);
    toggles.show(closeDofs);
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
