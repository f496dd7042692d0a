// Wires the page together. No physics here: every number comes from the package.

import { startBand } from "./band.js";
import { startBefore } from "./before.js";
import { FIRST_BLADE, startBlade, startHistory } from "./blade.js";
import { Chart } from "./chart.js";
import { startChartData } from "./chart-data.js";
import { startChartTools } from "./chart-tools.js";
import { stopped } from "./client.js";
import { startCloseTools } from "./close-tools.js";
import { OWN, createDocument } from "./document.js";
import { at } from "./dom.js";
import { startForm } from "./form.js";
import { startHover } from "./hover.js";
import { startLesson } from "./lesson.js";
import { startMeasured } from "./measured.js";
import { startMotion } from "./motion.js";
import { startReport } from "./report.js";
import { startSaving } from "./save.js";
import { NEUTRAL } from "./scale.js";
import { startSensitivity } from "./sensitivity.js";
import { isShared, startSolving } from "./solve.js";
import { Solver } from "./solver.js";
import { startSpeed } from "./speed.js";
import { startSession } from "./session.js";
import { startShare } from "./share.js";
import { createStore } from "./state.js";
import { copyFull } from "./table.js";
import { startStations } from "./stations.js";
import { startTheme } from "./theme.js";
import { startUnits } from "./units.js";
import { startView } from "./view.js";
import { startWhatIf } from "./what-if.js";
import { startZoom } from "./zoom.js";

const store = createStore({
  about: null, // version, model line, units
  library: [],
  choice: FIRST_BLADE,
  doc: null, // the blade as it stands in the fields, in its own units; may have faults
  text: null, // its file, until a field is changed
  textFaults: [], // of what is typed in the text tab
  opened: 0, // how many blades were opened
  canUndo: false,
  canRedo: false,
  whatIf: NEUTRAL,
  before: null, // fan chart without what-if, while there is some
  blade: null, // what was last solved: without faults, with what-if
  faults: [], // of the blade, with paths
  warnings: [],
  options: {},
  dofs: ["flap", "lag", "torsion"], // shown in the fan chart
  closeDofs: ["flap"], // shown in mode shapes and convergence
  band: [0.9, 1.1], // operating band, as ratios of nominal speed
  window: null, // {speeds: [from, to, count] rad/s, frequencies: [from, to] in the axis's unit} when zoomed
  measured: "", // CSV
  speed: null, // {value, unit}; null is nominal
  solvedSpeed: null, // the one that modes stand for
  speedUnit: "rpm",
  frequencyUnit: "rad/s",
  theme: "light",
  tab: "fan",
  chosen: "1F", // the mode whose shape is shown beside the table
  width: 0,
  height: null, // of the fan chart where it shares its place, else null
  fan: null,
  modes: null,
  drawing: null,
  solveFaults: [], // of options
});
/** The package's folder, once it is known: the whole module comes from there, so never of another version. */
let folder = "whole";
const startWorker = (whole) => new Worker(new URL("worker.js", import.meta.url), { type: "module", name: whole ? folder : "" });
const client = new Solver(startWorker, {
  onBusy: (busy) => (at("busy").hidden = !busy),
  late: ["draw", "modes"],
});

let quiet;
/** Says something in one line above the page, for a while. */
function say(words) {
  at("message").textContent = words;
  clearTimeout(quiet);
  quiet = setTimeout(() => (at("message").textContent = ""), 12_000);
}

const blade = createDocument(store);
const open = startBlade(store, client, blade, say);
startHistory(store, blade);
startForm(store, blade);
startStations(store, blade);
startUnits(store, client, blade, say);
startWhatIf(store, blade);
startChartTools(store);
const chooseSpeed = startSpeed(store);
const chart = new Chart(at("chart"), chooseSpeed);
startBefore(chart, store);
startZoom(chart, store);
startBand(chart, store);
startHover(chart, chooseSpeed);
startChartData(store);
startMeasured(store, client);
startView(store, chart);
startSolving(store, client);
startSaving(store, client, say);
startMotion(store, client);
startReport(store, client);
startCloseTools(store);
startLesson(store);
startSensitivity(store, client);
copyFull(at("modes"));

const fromAddress = startShare(store, open, say);
const fromLastVisit = startSession(store, open, say);

const optionFields = [...document.querySelectorAll("[data-option]")];
store.subscribe(({ options }, changed) => {
  if (!changed.has("options")) return;
  for (const field of optionFields) {
    if (field !== document.activeElement && options[field.dataset.option] !== undefined) field.value = options[field.dataset.option];
  }
});
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

/** The chart is drawn as wide as its place, and no taller than the window leaves room for. */
function measure() {
  const room = at("panel").clientWidth;
  const shared = isShared(store.get().tab);
  const high = innerHeight - 230;
  store.set({
    width: Math.round(Math.max(320, Math.min(room, shared ? room : high * 1.35, 1600))),
    height: shared ? Math.round(Math.max(220, Math.min(0.42 * innerHeight, 0.75 * room))) : null,
  });
}
let measuring;
new ResizeObserver(() => {
  clearTimeout(measuring);
  measuring = setTimeout(measure, store.get().width === 0 ? 0 : 120);
}).observe(at("panel"));
store.subscribe((_, changed) => changed.has("tab") && measure());

async function start() {
  const library = await import("./pkg/library.js").catch((error) => {
    store.set({ solveFaults: stopped(`the blades could not be loaded: ${error.message}`).faults });
    return null;
  });
  if (library === null) return;
  const { about, blades } = library;
  folder = library.folder;
  const { speed_units: speedUnits, version } = about;
  at("speed-unit").replaceChildren(...speedUnits.map(({ name }) => new Option(name, name, false, name === store.get().speedUnit)));
  at("speed-unit").disabled = false;
  at("version").textContent = `bladefan ${version}`;
  at("blade-choice").replaceChildren(...blades.map((blade) => new Option(blade.title, blade.name)), new Option("your own blade", OWN));
  at("blade-choice").disabled = false;
  store.set({ about, library: blades });
  if (open.begun()) return; // a file came in meanwhile
  if ((await fromAddress()) || (await fromLastVisit()) || open.begun()) return;
  const first = blades.find((blade) => blade.name === FIRST_BLADE) ?? blades[0];
  open(first.toml, first.name);
  at("hint").textContent = `This is the ${first.title}. Drag the line on the chart, or a slider under “What if”, and watch the branches move.`;
  at("hint").hidden = false;
}
start();
// Without a network the page goes on from what it keeps; where that is not allowed it just needs one.
// What is kept is fetched after the first chart, not beside it.
let keeping = false;
store.subscribe(({ drawing }) => {
  if (drawing === null || keeping) return;
  keeping = true;
  if (isSecureContext) navigator.serviceWorker?.register("sw.js").catch(() => {});
});
