// What the charts show and how: degrees of freedom, and units of the fan chart.

import { dofToggles } from "../lib/dof-toggles.js";
import { at } from "../lib/dom.js";
import { motionsOf } from "../lib/labels.js";
import { windowIn } from "./zoom.js";

/** Names of units as they are read. */
const SHOWN = { "per-rev": "/rev" };

/** Tabs whose drawing is of some of them. */
const TABS = ["shapes", "converge"];

/** Makes the tools above the chart. */
export function startChartTools(store) {
  const { labels: toggles, show } = dofToggles("show", (dofs) => store.set({ dofs }));
  show(store.get().dofs);
  at("chart-tools").prepend(...toggles);
  const model = at("model-choice");
  model.addEventListener("change", () => store.set({ model: model.value }));
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
    if (changed.has("model")) model.value = state.model;
    if (changed.has("dofs")) show(state.dofs);
    if (changed.has("tab")) {
      const other = state.tab === "shapes" || state.tab === "converge";
      at("frequency-field").hidden = state.tab === "shapes"; // they have no frequency axis
      for (const item of [...toggles, at("harmonics-field"), at("zoom")]) item.hidden = other;
    }
  });
}

/** Makes the choice above mode shapes and convergence: at first the chosen mode's degree of freedom. */
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
      const [dof] = motionsOf(state.chosen);
      if (dof !== undefined && !state.closeDofs.includes(dof)) store.set({ closeDofs: [dof] });
    }
    if (changed.has("tab") || changed.has("closeDofs")) show(store.get());
  });
  show(store.get());
}
