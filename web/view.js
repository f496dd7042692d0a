// Shows the state on the page.

import { FIRST_BLADE, OWN } from "./blade.js";
import { place } from "./chart.js";
import { at } from "./dom.js";
import { listFaults } from "./editor.js";
import { basisWords, faultPlace, fieldNumber } from "./format.js";
import { showSpeed, shownSpeed, unitFactor } from "./speed.js";
import { closestWords, showChosen, showModes } from "./table.js";

const TITLES = { fan: "Fan chart", shapes: "Mode shapes", converge: "Convergence" };

function showNumbers(state, onChoose) {
  const { modes } = state;
  if (modes === null) return;
  const speed = `${fieldNumber(shownSpeed(state.solvedSpeed, state))} ${state.speedUnit}`;
  at("numbers-title").textContent = `Frequencies at ${speed}${state.solvedSpeed === null ? ", nominal" : ""}`;
  showModes(at("modes").tBodies[0], modes, state.margins, onChoose);
  at("closest").textContent = closestWords(state.margins, speed, state.fan?.harmonics);
  at("paper-column").textContent = `paper N=${modes.classical_functions}`;
  at("model").textContent = `${basisWords(modes.basis)}; ${state.about.model}`;
  document.title = `${modes.blade} – bladefan`;
}

function markSpeed(chart, state) {
  const { drawing, modes, speedUnit, frequencyUnit } = state;
  if (drawing?.kind !== "fan" || modes === null) return;
  const key = frequencyUnit === "Hz" ? "frequency_hz" : "frequency_rad_s";
  chart.mark(
    modes.speed_rad_s / unitFactor(state, speedUnit),
    modes.modes.map((mode) => ({ dof: mode.dof, value: mode[key] })),
  );
}

function showFaults(editor, { faults, warnings }) {
  editor.mark(faults);
  listFaults(at("faults"), faults, (fault) => editor.jump(fault.line, fault.column));
  const count = faults.length;
  const words = count === 1 ? "1 fault" : `${count} faults`;
  at("fault-summary").textContent = count > 0 ? `${words}; first at ${faultPlace(faults[0]) || "the text"}` : "";
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
  at("blade-source").textContent = built ? `${built.quality} data: ${built.citation}` : "Your own text. It stays in this page.";
  at("blade-source").classList.toggle("estimated", built?.quality === "estimated");
}

/** Says so when chart and numbers are not of what the user sees in the fields. */
function showLastGood({ faults, solveFaults, drawing }) {
  at("last-good").textContent =
    faults.length > 0
      ? "The text has faults; charts and numbers show the last blade without any."
      : "Charts and numbers show the last solution.";
  at("last-good").hidden = drawing === null || faults.length + solveFaults.length === 0;
}

function showSolveFaults({ solveFaults }) {
  listFaults(at("solve-faults"), solveFaults);
  at("speed-number").setAttribute("aria-invalid", String(solveFaults.some((fault) => fault.path === "speed")));
  for (const field of document.querySelectorAll("[data-option]")) {
    field.setAttribute("aria-invalid", String(solveFaults.some((fault) => fault.path === field.dataset.option)));
  }
}

function showTab(tab) {
  for (const button of document.querySelectorAll('[role="tab"]')) {
    const chosen = button.id === `tab-${tab}`;
    button.setAttribute("aria-selected", String(chosen));
    button.tabIndex = chosen ? 0 : -1;
  }
  at("panel").setAttribute("aria-labelledby", `tab-${tab}`);
  at("frequency-field").hidden = tab === "shapes"; // they have no frequency axis
}

/** The shapes beside the table: the chosen mode stands out. */
function showSide({ side, sideWidth, tab, chosen }, drawn) {
  const host = at("side");
  host.hidden = side === null || sideWidth === 0 || tab === "shapes";
  if (drawn) place(host, side, side.name, { above: 19, below: 34 }); // its name and its axis
  for (const group of host.querySelectorAll("[data-label]")) group.classList.toggle("chosen", group.dataset.label === chosen);
}

/** Shows every change of the state from now on. */
export function startView(store, chart, editor) {
  store.subscribe((state, changed) => {
    const any = (...keys) => keys.some((key) => changed.has(key));
    if (any("tab")) showTab(state.tab);
    if (any("faults", "warnings")) showFaults(editor, state);
    if (any("library", "choice")) showSource(state);
    if (any("solveFaults")) showSolveFaults(state);
    if (any("faults", "solveFaults", "drawing")) showLastGood(state);
    if (state.about === null) return;
    if (any("drawing")) {
      const { kind, name } = state.drawing;
      chart.show(state.drawing, `${TITLES[kind]} of ${name}`, kind === "fan");
    }
    if (any("fan", "modes", "speed", "speedUnit")) showSpeed(state);
    if (any("modes", "fan", "speedUnit")) showNumbers(state, (chosen) => store.set({ chosen }));
    if (any("modes", "chosen")) showChosen(at("modes").tBodies[0], state.chosen);
    if (any("side", "chosen", "tab", "sideWidth")) showSide(state, any("side"));
    if (any("drawing", "modes")) markSpeed(chart, state);
    if (any("speed", "choice")) at("hint").hidden ||= state.speed !== null || state.choice !== FIRST_BLADE;
  });
}
