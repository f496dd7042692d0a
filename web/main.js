// Wires the page's controls to its state. No physics here: every number comes from the package.

import { Chart } from "./chart.js";
import { Client } from "./client.js";
import { convergeCsv, download, fanCsv, fileName, png, shapesCsv } from "./download.js";
import { Editor, listFaults } from "./editor.js";
import { faultPlace, fieldNumber } from "./format.js";
import { optionsOf, startSolving } from "./solve.js";
import { createStore } from "./state.js";
import { closestWords, copyFull, showModes } from "./table.js";
import { startTheme } from "./theme.js";

const at = (id) => document.getElementById(id);
const TYPING_MS = 250;
const FIRST_BLADE = "tm4760";
const OWN = ""; // value of the choice for a text of the user's own
const TITLES = { fan: "Fan chart", shapes: "Mode shapes", converge: "Convergence" };

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
  speedUnit: "rpm",
  frequencyUnit: "rad/s",
  theme: "light",
  tab: "fan",
  width: 0,
  fan: null,
  modes: null,
  margins: [],
  drawing: null,
  solveFaults: [],
});
const client = new Client(() => new Worker(new URL("worker.js", import.meta.url), { type: "module" }), {
  onBusy: (busy) => (at("busy").hidden = !busy),
});

// ---- blade: choice, file, editor ----

let typing;
const editor = new Editor(at("editor"), (text) => {
  clearTimeout(typing);
  typing = setTimeout(() => store.set({ text, choice: OWN }), TYPING_MS);
});

function load(text, choice) {
  clearTimeout(typing);
  editor.value = text;
  store.set({ text, choice, speed: null });
}

async function openFile(file) {
  if (file) load((await file.text()).replaceAll("\r\n", "\n"), OWN);
}

at("blade-choice").addEventListener("change", ({ target }) => {
  const built = store.get().library.find((blade) => blade.name === target.value);
  if (built) load(built.toml, built.name);
});
at("open-file").addEventListener("click", () => at("file-input").click());
at("file-input").addEventListener("change", async ({ target }) => {
  await openFile(target.files[0]);
  target.value = "";
});
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

// ---- speed, units, options, tabs ----

const unitFactor = (name) => store.get().about.speed_units.find((unit) => unit.name === name).rad_s;

/** The solved rotor speed in the unit of the page. */
function shownSpeed({ speed, speedUnit, modes }) {
  if (speed !== null && speed.unit === speedUnit) return speed.value;
  return modes === null ? 0 : Number((modes.speed_rad_s / unitFactor(speedUnit)).toPrecision(12));
}
const chooseSpeed = (value) => store.set({ speed: { value, unit: store.get().speedUnit } });

/** A round step that divides the slider's length into 400 to 1000 parts. */
function sliderStep(length) {
  const power = 10 ** Math.floor(Math.log10(length / 400));
  return [5, 2, 1].map((n) => n * power).find((step) => length / step >= 400);
}

const chart = new Chart(at("chart"), (speed) => {
  const step = Number(at("speed-slider").step);
  chooseSpeed(Number((Math.round(speed / step) * step).toPrecision(12)));
});
at("speed-slider").addEventListener("input", ({ target }) => chooseSpeed(target.valueAsNumber));
at("speed-number").addEventListener("input", ({ target }) => {
  if (Number.isFinite(target.valueAsNumber)) chooseSpeed(target.valueAsNumber);
});
at("speed-number").addEventListener("change", () => showSpeed(store.get()));
at("nominal").addEventListener("click", () => store.set({ speed: null }));
at("speed-unit").addEventListener("change", ({ target }) => store.set({ speedUnit: target.value }));
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

/** The chart is drawn as wide as its place, and no taller than the window leaves room for. */
function measure() {
  const room = at("panel").clientWidth;
  const high = innerHeight - 190;
  store.set({ width: Math.round(Math.max(320, Math.min(room, high * 1.6, 1600))) });
}
let measuring;
new ResizeObserver(() => {
  clearTimeout(measuring);
  measuring = setTimeout(measure, store.get().width === 0 ? 0 : 120);
}).observe(at("panel"));

// ---- downloads ----

const reports = { fan: fanCsv, shapes: shapesCsv, converge: convergeCsv };
/** What the open tab shows, as numbers. */
async function report() {
  const { tab, blade } = store.get();
  const result = await client.call("report", tab, blade, optionsOf(tab, store.get()));
  if (result?.status === "error") store.set({ solveFaults: result.faults });
  return result?.status === "ok" ? result.value : null;
}
const named = (what, extension) => fileName(store.get().fan?.blade ?? "", what, extension);
const downloads = {
  svg: ({ drawing, tab }) => download(named(tab, "svg"), drawing.svg, "image/svg+xml"),
  png: async ({ drawing, tab }) => download(named(tab, "png"), await png(drawing)),
  csv: async ({ tab }) => {
    const value = await report();
    if (value) download(named(tab, "csv"), reports[tab](value), "text/csv");
  },
  json: async ({ tab }) => {
    const value = await report();
    if (value) download(named(tab, "json"), JSON.stringify(value, null, 1) + "\n", "application/json");
  },
  blade: () => {
    const text = editor.value;
    download(named("", text.trimStart().startsWith("{") ? "json" : "toml"), text, "text/plain");
  },
};
for (const [what, make] of Object.entries(downloads)) {
  at(`download-${what}`).addEventListener("click", async () => {
    at("download").open = false;
    at("download").querySelector("summary").focus();
    if (store.get().drawing !== null) await make(store.get());
  });
}
addEventListener("pointerdown", ({ target }) => {
  if (!at("download").contains(target)) at("download").open = false;
});
at("download").addEventListener("keydown", ({ key }) => {
  if (key === "Escape") at("download").open = false;
});
copyFull(at("modes"));

// ---- showing the state ----

function showSpeed(state) {
  if (state.fan === null || state.modes === null) return;
  const slider = at("speed-slider");
  const number = at("speed-number");
  const longest = state.fan.speeds_rad_s.at(-1) / unitFactor(state.speedUnit);
  slider.step = sliderStep(longest);
  slider.max = fieldNumber(longest);
  const speed = shownSpeed(state);
  slider.value = speed;
  slider.setAttribute("aria-valuetext", `${fieldNumber(speed)} ${state.speedUnit}`);
  if (document.activeElement !== number) number.value = fieldNumber(speed);
  for (const control of [slider, number, at("nominal")]) control.disabled = false;
  at("nominal").disabled = state.speed === null;
}

function showNumbers(state) {
  const { modes } = state;
  if (modes === null) return;
  const speed = `${fieldNumber(shownSpeed(state))} ${state.speedUnit}`;
  at("numbers-title").textContent = `Frequencies at ${speed}${state.speed === null ? ", nominal" : ""}`;
  showModes(at("modes").tBodies[0], modes, state.margins);
  at("closest").textContent = closestWords(state.margins, speed);
  const counts = Object.values(modes.basis.functions).filter((count) => count !== null);
  at("model").textContent = `${modes.basis.family} functions, N = ${[...new Set(counts)].join(", ")}; ${state.about.model}`;
  document.title = `${modes.blade} – bladefan`;
}

function markSpeed({ drawing, modes, speedUnit, frequencyUnit }) {
  if (drawing?.kind !== "fan" || modes === null) return;
  const key = frequencyUnit === "Hz" ? "frequency_hz" : "frequency_rad_s";
  chart.mark(
    modes.speed_rad_s / unitFactor(speedUnit),
    modes.modes.map((mode) => ({ dof: mode.dof, value: mode[key] })),
  );
}

function showFaults({ faults, warnings, blade }) {
  editor.mark(faults);
  listFaults(at("faults"), faults, (fault) => editor.jump(fault.line, fault.column));
  const count = faults.length;
  const words = count === 1 ? "1 fault" : `${count} faults`;
  at("fault-summary").textContent = count > 0 ? `${words}; first at ${faultPlace(faults[0]) || "the text"}` : "";
  at("last-good").hidden = count === 0 || blade === null;
  at("warnings").replaceChildren(
    ...warnings.map((warning) => {
      const item = document.createElement("li");
      item.textContent = `${warning.path}: ${warning.message}`;
      return item;
    }),
  );
}

function showSource({ library, choice }) {
  const built = library.find((blade) => blade.name === choice);
  at("blade-choice").value = choice;
  at("blade-choice").querySelector(`option[value="${OWN}"]`).hidden = choice !== OWN;
  at("blade-source").textContent = built ? `${built.quality}: ${built.citation}` : "Your own text. It stays in this page.";
}

function showSolveFaults({ solveFaults }) {
  listFaults(at("solve-faults"), solveFaults);
  for (const field of optionFields) {
    field.setAttribute("aria-invalid", String(solveFaults.some((fault) => fault.path === field.dataset.option)));
  }
}

function showTab(tab) {
  for (const button of tabs) {
    const chosen = button.id === `tab-${tab}`;
    button.setAttribute("aria-selected", String(chosen));
    button.tabIndex = chosen ? 0 : -1;
  }
  at("panel").setAttribute("aria-labelledby", `tab-${tab}`);
}

store.subscribe((state, changed) => {
  const any = (...keys) => keys.some((key) => changed.has(key));
  if (any("tab")) showTab(state.tab);
  if (any("faults", "warnings", "blade")) showFaults(state);
  if (any("library", "choice")) showSource(state);
  if (any("solveFaults")) showSolveFaults(state);
  if (state.about === null) return;
  if (any("drawing")) {
    const { kind, name } = state.drawing;
    chart.show(state.drawing, `${TITLES[kind]} of ${name}`, kind === "fan");
  }
  if (any("fan", "modes", "speed", "speedUnit")) showSpeed(state);
  if (any("modes", "fan", "speedUnit")) showNumbers(state);
  if (any("drawing", "modes")) markSpeed(state);
  if (any("speed", "choice")) at("hint").hidden ||= state.speed !== null || state.choice !== FIRST_BLADE;
});
startSolving(store, client);

// ---- start ----

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
