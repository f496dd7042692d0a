// What the fan chart shows and how: degrees of freedom and units.

import { at, make } from "./dom.js";
import { windowIn } from "./zoom.js";

const DOFS = ["flap", "lag", "torsion"];
/** Names of units as they are read. */
const SHOWN = { "per-rev": "/rev" };

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

/** Makes the tools above the chart. */
export function startChartTools(store) {
  const { labels: toggles, show } = dofToggles("show", (dofs) => store.set({ dofs }));
  show(store.get().dofs);
  at("chart-tools").prepend(...toggles);
  const unit = at("frequency-unit");
  unit.addEventListener("change", () => {
    const { window, frequencyUnit } = store.get();
    store.set({ frequencyUnit: unit.value, window: windowIn(window, frequencyUnit, unit.value) });
  });
  store.subscribe((state, changed) => {
    if (changed.has("about") && state.about !== null) {
      unit.replaceChildren(...state.about.frequency_units.map((name) => new Option(SHOWN[name] ?? name, name)));
      unit.disabled = false;
    }
    // A view from a link or the last visit sets these, too.
    if (changed.has("about") || changed.has("frequencyUnit")) unit.value = state.frequencyUnit;
    if (changed.has("dofs")) show(state.dofs);
    if (changed.has("tab")) {
      const other = state.tab === "shapes" || state.tab === "converge";
      at("frequency-field").hidden = state.tab === "shapes"; // they have no frequency axis
      for (const item of [...toggles, at("harmonics-field"), at("zoom")]) item.hidden = other;
    }
  });
}
