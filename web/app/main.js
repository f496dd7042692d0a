// Wires the page together. No physics here: every number comes from the package.

import { OWN, createDocument, startHistory } from "../blade/document.js";
import { startForm } from "../blade/form.js";
import { startOpening } from "../blade/open.js";
import { startUnits } from "../blade/units.js";
import { startWhatIf } from "../blade/what-if.js";
import { startBand } from "../chart/band.js";
import { Chart } from "../chart/chart.js";
import { knowUnits } from "../chart/frame.js";
import { startHover } from "../chart/hover.js";
import { startMeasured } from "../chart/measured.js";
import { startNumbers } from "../chart/numbers.js";
import { startSpeed } from "../chart/speed.js";
import { startChartTools, startCloseTools } from "../chart/tools.js";
import { startUnchanged } from "../chart/unchanged.js";
import { startZoom } from "../chart/zoom.js";
import { at } from "../lib/dom.js";
import { scriptAddress } from "../lib/trusted.js";
import { isNeutral } from "../lib/what-if.js";
import { startLesson } from "../modes/lesson.js";
import { startMotion } from "../modes/motion.js";
import { startMovers } from "../modes/movers.js";
import { copyFull } from "../modes/table.js";
import { startReport } from "../out/report.js";
import { startSaving } from "../out/save.js";
import { withModule } from "../solver/client.js";
import { isShared, startKeepingUp } from "../solver/keep-up.js";
import { Solver } from "../solver/lanes.js";
import { compiledModule, inTime } from "../solver/module.js";
import { startStations } from "../stations/tab.js";
import { startOptions } from "./options.js";
import { startSession } from "./session.js";
import { startShare } from "./share.js";
import { FIRST_BLADE, createStore } from "./state.js";
import { startTheme } from "./theme.js";
import { startView } from "./view.js";

const store = createStore();
const makeWorker = () => new Worker(scriptAddress(new URL("../solver/worker.js", import.meta.url)), { type: "module" });
const client = new Solver(() => withModule(makeWorker, compiledModule), {
  onBusy: (busy) => (at("busy").hidden = !busy),
  onTrouble: (trouble) => store.set({ trouble }),
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
const open = startOpening(store, client, blade, say);
startHistory(store, blade);
startForm(store, blade);
startStations(store, blade);
startUnits(store, client, blade, say);
startWhatIf(store, client, blade, say);
startChartTools(store);
const chooseSpeed = startSpeed(store);
const chart = new Chart(at("chart"), chooseSpeed);
startUnchanged(chart, store);
startZoom(chart, store);
startBand(chart, store);
startHover(chart, async (report, speed) => (await client.call("hover", "at_speed", report, speed))?.value ?? null, chooseSpeed);
startNumbers(store);
startMeasured(store, client);
startView(store, chart, tryAgain);
startKeepingUp(store, client);
startSaving(store, client, say);
startMotion(store, client);
startReport(store, client);
startCloseTools(store);
startLesson(store);
startMovers(store, client);
copyFull(at("modes"));

startOptions(store);

const address = startShare(store, open, say);
const fromLastVisit = startSession(store, open, say, address.outgrow);
store.subscribe(
  ({ blade, doc, whatIf, faults }, changed) => changed.has("blade") && faults.length === 0 && store.set({ good: isNeutral(whatIf) ? blade : doc }),
);

const tabs = [.../** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll('[role="tab"]'))];
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

let tries = 0;
async function start() {
  // A module that once did not come is only asked for again by another name.
  const coming = tries++ === 0 ? import("../pkg/library.js") : import(`../pkg/library.js?again=${tries}`);
  const library = await inTime(coming).catch((error) => {
    store.set({ trouble: `the blades could not be loaded: ${error.message}` });
    return null;
  });
  if (library === null) return;
  const { about, blades } = library;
  const { speed_units: speedUnits, version } = about;
  at("speed-unit").replaceChildren(...speedUnits.map(({ name }) => new Option(name, name, false, name === store.get().speedUnit)));
  at("speed-unit").disabled = false;
  at("version").textContent = `bladefan ${version}`;
  at("blade-choice").replaceChildren(...blades.map((blade) => new Option(blade.title, blade.name)), new Option("your own blade", OWN));
  at("blade-choice").disabled = false;
  knowUnits(speedUnits);
  store.set({ about, library: blades });
  if (open.begun()) return open.haveBlade(); // a file came in meanwhile
  // Whatever stands in the address or in storage, the page starts.
  const found = async (look) => look().catch(() => false);
  if ((await found(address.open)) || (await found(fromLastVisit)) || open.begun()) return open.haveBlade();
  const first = blades.find((blade) => blade.name === FIRST_BLADE) ?? blades[0];
  open(first.toml, first.name);
  at("hint").textContent = `The ${first.title}. Drag the line on the chart, or a slider under “What if”.`;
  at("hint").hidden = false;
}
start();

/** After something did not arrive: what was asked of it is still waiting. */
function tryAgain() {
  store.set({ trouble: null });
  if (store.get().about === null) start();
  client.again();
}

// Without a network the page goes on from what it keeps; where that is not allowed it just needs one.
// What is kept is fetched after the first chart, not beside it.
async function keepForLater() {
  const registration = await navigator.serviceWorker?.register(scriptAddress("sw.js"), { updateViaCache: "none" });
  await registration?.update(); // a newer version is kept at this visit, not at some later one
}
let keeping = false;
store.subscribe(({ drawing }) => {
  if (drawing === null || keeping) return;
  keeping = true;
  if (isSecureContext) keepForLater().catch(() => {});
});
