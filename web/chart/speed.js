// The rotor speed: slider, number, unit, and the line on the chart, all one value of the state.

import { at } from "../lib/dom.js";
import { fieldNumber } from "../lib/format.js";
import { shownSpeed, unitFactor } from "../lib/speed-words.js";

const slider = at("speed-slider");
const number = at("speed-number");
/** The whole chart goes to this ratio of nominal speed. */
const WHOLE = 1.2;

/** A round step that divides the slider's length into 400 to 1000 parts. */
function sliderStep(length) {
  const power = 10 ** Math.floor(Math.log10(length / 400));
  return [5, 2, 1].map((n) => n * power).find((step) => length / step >= 400);
}

/** Shows the state's speed on the controls. */
export function showSpeed(state) {
  if (state.fan === null || state.modes === null) return;
  const { speeds_rad_s: speeds, nominal } = state.fan;
  // A window on the chart leaves the slider as long as it is.
  const last = state.window === null ? speeds.at(-1) : Math.max(WHOLE * nominal.speed_rad_s, speeds.at(-1));
  const longest = last / unitFactor(state, state.speedUnit);
  slider.step = String(sliderStep(longest));
  slider.max = fieldNumber(longest);
  const speed = shownSpeed(state.speed, state);
  slider.value = speed;
  slider.setAttribute("aria-valuetext", `${fieldNumber(speed)} ${state.speedUnit}`);
  if (document.activeElement !== number) number.value = fieldNumber(speed);
  for (const control of [slider, number]) control.disabled = false;
  at("nominal").disabled = state.speed === null;
}

/** Makes the controls work; returns what takes a speed chosen on the chart. */
export function startSpeed(store) {
  const choose = (value) => store.set({ speed: { value, unit: store.get().speedUnit } });
  slider.addEventListener("input", () => choose(slider.valueAsNumber));
  number.addEventListener("input", () => {
    if (Number.isFinite(number.valueAsNumber)) choose(number.valueAsNumber);
  });
  number.addEventListener("blur", () => showSpeed(store.get()));
  at("nominal").addEventListener("click", () => store.set({ speed: null }));
  const unit = at("speed-unit");
  unit.addEventListener("change", () => store.set({ speedUnit: unit.value }));
  store.subscribe((state, changed) => {
    if (changed.has("speedUnit") || changed.has("about")) unit.value = state.speedUnit;
  });
  return (speed) => {
    const step = Number(slider.step);
    choose(Number((Math.round(speed / step) * step).toPrecision(12)));
  };
}
