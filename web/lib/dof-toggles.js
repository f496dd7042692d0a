// The degrees of freedom, and boxes to choose among them.

import { make } from "./dom.js";

export const DOFS = ["flap", "lag", "torsion"];

/** Boxes to choose degrees of freedom, one at least; `id` starts their ids. */
export function dofToggles(id, choose) {
  const boxes = DOFS.map((dof) => Object.assign(document.createElement("input"), { type: "checkbox", id: `${id}-${dof}`, value: dof }));
  const labels = boxes.map((box) => {
    box.addEventListener("change", () => {
      const chosen = boxes.filter(({ checked }) => checked).map(({ value }) => value);
      if (chosen.length === 0) box.checked = true;
      else choose(chosen);
    });
    return make("label", { className: "toggle", dataset: { dof: box.value } }, box, box.value);
  });
  const show = (dofs) => boxes.forEach((box) => (box.checked = dofs.includes(box.value)));
  return { labels, show };
}
