// Shows the state on the page.

import { OWN } from "../blade/document.js";
import { summary } from "../chart/numbers.js";
import { showSpeed } from "../chart/speed.js";
import { at, make, write } from "../lib/dom.js";
import { listFaults } from "../lib/faults.js";
import { basisWords, fieldNumber } from "../lib/format.js";
import { shownSpeed, unitFactor } from "../lib/speed-words.js";
import { nearModes, nearNote } from "../modes/nearness.js";
import { closestWords, showChosen, showModes } from "../modes/table.js";
import { isShared } from "../solver/keep-up.js";
import { FIRST_BLADE } from "./state.js";

const TITLES = { fan: "Fan chart", shapes: "Mode shapes", converge: "Convergence" };

function showNumbers(state, onChoose) {
  const { modes, dofs } = state;
  if (modes === null) return;
  const seen = modes.modes.filter(({ dof }) => dofs.includes(dof));
  const speed = `${fieldNumber(shownSpeed(state.solvedSpeed, state))} ${state.speedUnit}`;
  write(at("numbers-title"), `Frequencies at ${speed}${state.solvedSpeed === null ? ", nominal" : ""}`);
  showModes(at("modes").tBodies[0], modes, { dofs, harmonics: state.fan?.harmonics, onChoose });
  at("shares-column").hidden = modes.model.kind !== "coupled";
  write(at("closest"), closestWords(seen, speed, state.fan?.harmonics));
  const harmonics = state.fan?.harmonics;
  const someNear = harmonics !== undefined && nearModes(seen, harmonics).length > 0;
  write(at("near-note"), someNear ? nearNote(harmonics) : "");
  write(at("paper-column"), `paper N=${modes.classical_functions}`);
  write(at("model"), `${basisWords(modes.basis)}; ${modes.model.words}`);
  const title = `${modes.blade} – bladefan`;
  if (document.title !== title) document.title = title;
}

/** The rotor speed that is chosen [rad/s]. */
function chosenSpeed(state) {
  if (state.speed === null) return state.fan?.nominal.speed_rad_s ?? null;
  return state.speed.value * unitFactor(state, state.speed.unit);
}

function showSource({ library, choice, doc }) {
  const built = library.find((blade) => blade.name === choice);
  at("blade-choice").value = choice;
  const own = /** @type {HTMLOptionElement} */ (at("blade-choice").querySelector(`option[value="${OWN}"]`));
  own.hidden = choice !== OWN;
  own.textContent = doc?.name && choice === OWN ? `${doc.name} (yours)` : "your own blade";
  at("blade-source").textContent = built ? `${built.quality} data: ${built.citation}` : "Your own blade. It stays in this page.";
  at("blade-source").classList.toggle("estimated", built?.quality === "estimated");
}

function showWarnings({ warnings }) {
  at("warnings").replaceChildren(
    ...warnings.map((warning) => Object.assign(document.createElement("li"), { textContent: `${warning.path}: ${warning.message}` })),
  );
}

/** Says so when chart and numbers are not of what the user sees in the fields. */
function showLastGood({ faults, solveFaults, textFaults, drawing }) {
  at("last-good").textContent =
    faults.length + textFaults.length > 0
      ? "The blade has faults; charts and numbers show the last one without any."
      : "Charts and numbers show the last solution.";
  at("last-good").hidden = drawing === null || faults.length + solveFaults.length + textFaults.length === 0;
}

function showSolveFaults({ solveFaults, trouble }, tryAgain) {
  listFaults(at("solve-faults"), solveFaults);
  if (trouble !== null) {
    const button = make("button", { type: "button", textContent: "Try again" });
    button.addEventListener("click", tryAgain);
    at("solve-faults").append(make("li", {}, `${trouble} `, button));
    at("solve-faults").hidden = false;
  }
  at("speed-number").setAttribute("aria-invalid", String(solveFaults.some((fault) => fault.path === "speed")));
  for (const field of /** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll("[data-option]"))) {
    field.setAttribute("aria-invalid", String(solveFaults.some((fault) => fault.path === field.dataset.option)));
  }
}

function showTab(tab) {
  for (const button of /** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll('[role="tab"]'))) {
    const chosen = button.id === `tab-${tab}`;
    button.setAttribute("aria-selected", String(chosen));
    button.tabIndex = chosen ? 0 : -1;
  }
  at("panel").setAttribute("aria-labelledby", `tab-${tab}`);
  at("stations").hidden = tab !== "stations";
  at("text").hidden = tab !== "text";
  // Room for the table or the text.
  at("chart-tools").hidden = isShared(tab);
}

/** Shows every change of the state from now on. */
export function startView(store, chart, tryAgain) {
  let harmonics;
  store.subscribe((state, changed) => {
    const any = (...keys) => keys.some((key) => changed.has(key));
    if (any("tab")) showTab(state.tab);
    if (any("faults")) listFaults(at("blade-faults"), state.faults);
    if (any("warnings")) showWarnings(state);
    if (any("library", "choice", "doc")) showSource(state);
    if (any("solveFaults", "trouble")) showSolveFaults(state, tryAgain);
    if (any("faults", "solveFaults", "textFaults", "drawing")) showLastGood(state);
    if (state.about === null) return;
    if (any("drawing")) {
      const { kind, name } = state.drawing;
      const title = `${TITLES[kind]} of ${name}`;
      chart.show(state.drawing, { title, words: `${title}: ${summary(state.drawing)}`, isFan: kind === "fan" });
    }
    if (any("fan", "modes", "speed", "speedUnit")) showSpeed(state);
    // Of the chart they need the harmonics alone; every step of a slider brings another chart.
    if (any("modes", "speedUnit", "dofs") || (any("fan") && state.fan.harmonics !== harmonics)) showNumbers(state, (chosen) => store.set({ chosen }));
    harmonics = state.fan?.harmonics;
    if (any("modes", "chosen") && state.modes !== null) showChosen(at("modes").tBodies[0], state.modes.modes, state.chosen);
    if (any("fan", "speed")) chart.mark(chosenSpeed(state));
    if (any("speed", "choice", "whatIf", "tab")) at("hint").hidden ||= state.speed !== null || state.choice !== FIRST_BLADE || state.tab !== "fan";
  });
}
