// Wires the page together. No physics here: every number comes from the package.

import { FIRST_BLADE, OWN, startBlade } from "./blade.js";
import { Chart } from "./chart.js";
import { Client } from "./client.js";
import { at } from "./dom.js";
import { startSaving } from "./save.js";
import { startSolving } from "./solve.js";
import { startSpeed } from "./speed.js";
import { createStore } from "./state.js";
import { copyFull } from "./table.js";
import { startTheme } from "./theme.js";
import { startView } from "./view.js";

const store = createStore({
  about: null, // version, model line, units
  library: [],
  choice: FIRST_BLADE,
  text: "",
  blade: null, // the last one without faults
  faults: [],
  warnings: [],
  options: {},
  speed: null, // {value, unit}; null is nominal
  solvedSpeed: null, // the one that modes and margins stand for
  speedUnit: "rpm",
  frequencyUnit: "rad/s",
  theme: "light",
  tab: "fan",
  chosen: "1F", // the mode whose shape is shown beside the table
  width: 0,
  sideWidth: 0, // of the shapes beside the table; 0 where there is no room
  fan: null,
  modes: null,
  margins: [],
  drawing: null,
  side: null,
  solveFaults: [],
});
const client = new Client(() => new Worker(new URL("worker.js", import.meta.url), { type: "module" }), {
  onBusy: (busy) => (at("busy").hidden = !busy),
});

const { editor, load } = startBlade(store);
const chart = new Chart(at("chart"), startSpeed(store));
startView(store, chart, editor);
startSolving(store, client);
startSaving(store, client, editor);
copyFull(at("modes"));
at("frequency-unit").addEventListener("change", ({ target }) => store.set({ frequencyUnit: target.value }));

const optionFields = [...document.querySelectorAll("[data-option]")];
for (const field of optionFields) {
  field.addEventListener("input", () => {
    store.set({ options: Object.fromEntries(optionFields.map((input) => [input.dataset.option, input.value])) });
  });
}

const tabs = [...document.querySelectorAll('[role="tab"]')];
function chooseTab(tab) {
  tab.focus();
  store.set({ tab: tab.id.replace("tab-", "") });
}
for (const tab of tabs) {
  tab.addEventListener("click", () => chooseTab(tab));
  tab.addEventListener("keydown", ({ key }) => {
    const step = { ArrowRight: 1, ArrowLeft: -1 }[key];
    if (step) chooseTab(tabs[(tabs.indexOf(tab) + step + tabs.length) % tabs.length]);
  });
}

startTheme(at("theme"), (theme) => store.set({ theme }));

// As in style.css: from here on the table has a column of its own.
const roomBeside = matchMedia("(min-width: 1180px)");

/** The chart is drawn as wide as its place, and no taller than the window leaves room for. */
function measure() {
  const room = at("panel").clientWidth;
  const high = innerHeight - 190;
  store.set({
    width: Math.round(Math.max(320, Math.min(room, high * 1.35, 1600))),
    sideWidth: roomBeside.matches ? Math.max(320, at("modes").clientWidth) : 0,
  });
}
let measuring;
new ResizeObserver(() => {
  clearTimeout(measuring);
  measuring = setTimeout(measure, store.get().width === 0 ? 0 : 120);
}).observe(at("panel"));

function fillUnits(select, names, chosen) {
  select.replaceChildren(...names.map((name) => new Option(name, name, false, name === chosen)));
  select.disabled = false;
}

async function start() {
  const about = await client.call("about", "about");
  const built = await client.call("library", "built_in_blades");
  const faults = [about, built].flatMap((result) => (result.status === "ok" ? [] : result.faults));
  if (faults.length > 0) {
    store.set({ solveFaults: faults.slice(0, 1) });
    return;
  }
  const { speed_units: speedUnits, frequency_units: frequencyUnits, version } = about.value;
  fillUnits(at("speed-unit"), speedUnits.map((unit) => unit.name), store.get().speedUnit);
  fillUnits(at("frequency-unit"), frequencyUnits, store.get().frequencyUnit);
  at("version").textContent = `bladefan ${version}`;
  at("blade-choice").replaceChildren(
    ...built.value.map((blade) => new Option(blade.title, blade.name)),
    new Option("your own text", OWN),
  );
  at("blade-choice").disabled = false;
  store.set({ about: about.value, library: built.value });
  if (store.get().text !== "") return; // a file came in while the solver was loading
  const first = built.value.find((blade) => blade.name === FIRST_BLADE) ?? built.value[0];
  load(first.toml, first.name);
  at("hint").textContent = `This is the ${first.title}. Drag the line on the chart, or change a number in the blade file, and watch the branches move.`;
  at("hint").hidden = false;
}
start();
