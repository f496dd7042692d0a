// What the fan chart shows and how: degrees of freedom and units.

import { at } from "./dom.js";
import { windowIn } from "./zoom.js";

const DOFS = { flap: "flap", lag: "lag", torsion: "torsion" };
/** Names of units as they are read. */
const SHOWN = { "per-rev": "/rev" };

/** Makes the tools above the chart. */
export function startChartTools(store) {
  const toggles = Object.entries(DOFS).map(([dof, name]) => {
    const box = Object.assign(document.createElement("input"), { type: "checkbox", checked: true, id: `show-${dof}` });
    const label = Object.assign(document.createElement("label"), { className: "toggle" });
    label.dataset.dof = dof;
    label.append(box, name);
    box.addEventListener("change", () => {
      const dofs = Object.keys(DOFS).filter((name) => at(`show-${name}`).checked);
      if (dofs.length === 0) box.checked = true; // one at least
      else store.set({ dofs });
    });
    return label;
  });
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
    if (changed.has("dofs")) for (const dof of Object.keys(DOFS)) at(`show-${dof}`).checked = state.dofs.includes(dof);
    if (changed.has("tab")) {
      const other = state.tab === "shapes" || state.tab === "converge";
      at("frequency-field").hidden = state.tab === "shapes"; // they have no frequency axis
      for (const item of [...toggles, at("harmonics-field"), at("zoom")]) item.hidden = other;
    }
  });
}
