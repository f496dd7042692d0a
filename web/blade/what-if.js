// What-if sliders: stiffness, mass, offsets and springs changed for a look, beside the blade as it is.

import { at } from "../lib/dom.js";
import { fieldNumber, fieldValue } from "../lib/format.js";
import { NEUTRAL, changesOf, isNeutral, lengthOf, lengthsOf, withLengths } from "../lib/what-if.js";
import { unitOf } from "../lib/unit-words.js";

const FACTORS = {
  flap_stiffness: "Flap stiffness",
  lag_stiffness: "Lag stiffness",
  torsion_stiffness: "Torsion stiffness",
  mass: "Mass and polar inertia",
};
const DOFS = { flap: "Flap", lag: "Lag", torsion: "Torsion" };
/** Sliders of factors go from a quarter to four times, evenly in the logarithm. */
const OCTAVES = 2;
/** Farthest that an offset's slider goes, as a share of the radius. */
const FARTHEST = 0.3;

/** A slider with its label, its exact field and its unit; `scale` is {min, max, step}, where they are known. */
function row(name, key, scale) {
  const div = document.createElement("div");
  div.className = "slider";
  div.dataset.key = key;
  const id = `what-if-${key.replace(".", "-")}`;
  const label = Object.assign(document.createElement("label"), { htmlFor: id, textContent: name });
  const slider = Object.assign(document.createElement("input"), { type: "range", id, ...scale });
  const exact = Object.assign(document.createElement("input"), { type: "text", inputMode: "decimal", ariaLabel: `${name}, exact` });
  const unit = Object.assign(document.createElement("span"), { className: "unit" });
  div.append(label, slider, exact, unit);
  return div;
}

/** Radii nearer than this share of themselves are one. */
const SAME = 1e-9;

const radiiOf = (doc) => [...new Set((doc.distribution?.r ?? []).filter(Number.isFinite))];

/** Which sliders this blade has: stiffnesses and mass, an offset per root, a spring where there is one. */
function plan(doc) {
  const has = (key) => key !== "torsion_stiffness" || doc.distribution?.[key] !== undefined;
  const rows = Object.entries(FACTORS).flatMap(([key, name]) => (has(key) ? [{ key: `factors.${key}`, name }] : []));
  for (const [dof, name] of Object.entries(DOFS)) {
    if (doc[dof]?.root !== "hingeless" && dof !== "torsion") rows.push({ key: `offsets.${dof}`, name: `${name} hinge offset` });
    if (typeof doc[dof]?.spring === "number" && doc[dof].spring > 0) rows.push({ key: `springs.${dof}`, name: `${name} spring` });
  }
  return rows;
}

/** Where a root's offset may go: properties must reach inward to it. */
function offsetRange(doc, dof) {
  const radius = doc.rotor?.radius ?? 1;
  const first = (name) => {
    const given = doc.distribution?.[name];
    return Array.isArray(given) ? doc.distribution.r?.[0] : given?.r?.[0];
  };
  return { min: Math.max(0, ...["mass", `${dof}_stiffness`].map(first).filter(Number.isFinite)), max: FARTHEST * radius };
}

function offsetOf(doc, dof) {
  const { offset, offset_ratio: ratio } = doc[dof] ?? {};
  return offset ?? (ratio === undefined ? 0 : ratio * doc.rotor?.radius);
}

/** Makes the sliders; the changed blade is what is solved. */
export function startWhatIf(store, client, blade, say) {
  const host = at("what-if");
  const rows = document.createElement("div");
  rows.className = "sliders";
  const range = Object.assign(document.createElement("div"), { className: "what-if-range" });
  const ends = ["from", "to"].map((name) => {
    const select = Object.assign(document.createElement("select"), { id: `what-if-${name}` });
    const label = Object.assign(document.createElement("label"), { className: "field", textContent: name === "from" ? "Scaled from " : "to " });
    label.append(select);
    range.append(label);
    select.addEventListener("change", () => set({ [name]: select.value === "" ? null : Number(select.value) }));
    return select;
  });
  const buttons = Object.assign(document.createElement("div"), { className: "what-if-buttons" });
  const [reset, keep] = ["Reset", "Keep in the blade"].map((text) =>
    Object.assign(document.createElement("button"), { type: "button", textContent: text }),
  );
  reset.id = "what-if-reset";
  keep.id = "what-if-keep";
  buttons.append(reset, keep);
  host.append(rows, range, buttons);
  let planned = "";

  /** Whether the lengths among the changes are in the unit that the blade has now. */
  const isInUnit = ({ doc, whatIf }) => whatIf.length === null || whatIf.length === lengthOf(doc) || lengthsOf(whatIf).length === 0;

  function set(change) {
    const state = store.get();
    if (isInUnit(state)) store.set({ whatIf: { ...state.whatIf, ...change, length: lengthOf(state.doc) } });
  }

  /** The blade has another unit of length: the changes follow. They are solved right meanwhile, for they name theirs. */
  async function convert({ doc, whatIf }) {
    const length = lengthOf(doc);
    const result = await client.call(
      "lengths",
      "convert_blade",
      { schema: doc.schema, units: { length: whatIf.length }, distribution: { r: lengthsOf(whatIf) } },
      { length },
    );
    if (result === null || store.get().whatIf !== whatIf || lengthOf(store.get().doc) !== length) return;
    if (result.status === "ok") store.set({ whatIf: withLengths(whatIf, result.value.distribution.r, length) });
    else store.set({ whatIf: NEUTRAL });
  }

  function choose(key, value) {
    const [table, name] = key.split(".");
    const { whatIf } = store.get();
    set({ [table]: { ...whatIf[table], [name]: value } });
  }

  function valueOf(key, { doc, whatIf }) {
    const [table, name] = key.split(".");
    if (table === "offsets") return whatIf.offsets[name] ?? offsetOf(doc, name);
    return whatIf[table][name] ?? 1;
  }

  function fit(doc) {
    const wanted = plan(doc);
    const signature = wanted.map((row) => row.key).join();
    if (signature !== planned) {
      planned = signature;
      rows.replaceChildren(
        ...wanted.map(({ key, name }) => row(name, key, key.startsWith("offsets") ? {} : { min: -OCTAVES, max: OCTAVES, step: 0.01 })),
      );
    }
    for (const { key } of wanted.filter(({ key }) => key.startsWith("offsets"))) {
      const slider = rows.querySelector(`[data-key="${key}"] input[type="range"]`);
      const { min, max } = offsetRange(doc, key.split(".")[1]);
      Object.assign(slider, { min, max, step: (max - min) / 500 || "any" });
    }
    const radii = radiiOf(doc);
    ends.forEach((select, i) => {
      const whole = i === 0 ? "root" : "tip";
      select.replaceChildren(new Option(whole, ""), ...radii.map((r) => new Option(fieldNumber(r), r)));
    });
    range.hidden = radii.length < 2;
  }

  /** Chooses a radius among those of the blade, and bars what would leave nothing between the two. */
  function showEnd(select, { from, to }, radii) {
    const end = select === ends[0] ? from : to;
    const near = (r) => Math.abs(r - end) <= SAME * Math.abs(end);
    const shown = end === null ? "" : (radii.find(near) ?? end);
    if (shown === end && !radii.includes(end)) select.append(new Option(fieldNumber(end), end));
    select.value = shown;
    for (const option of [...select.options].slice(1)) {
      const r = Number(option.value);
      option.disabled = select === ends[0] ? to !== null && r >= to : from !== null && r <= from;
    }
  }

  function show(state) {
    const { doc, whatIf } = state;
    if (!isInUnit(state)) return void convert(state);
    for (const div of /** @type {HTMLCollectionOf<HTMLElement>} */ (rows.children)) {
      const { key } = div.dataset;
      const [slider, exact] = div.querySelectorAll("input");
      const value = valueOf(key, state);
      const isOffset = key.startsWith("offsets");
      if (slider !== document.activeElement || isOffset === false) slider.value = isOffset ? value : Math.log2(value);
      const words = isOffset ? (Number.isFinite(value) ? fieldNumber(value, 4) : "") : value.toFixed(2);
      const unit = isOffset ? unitOf("length", doc.units) : "×";
      slider.setAttribute("aria-valuetext", `${words} ${isOffset ? unit : "times"}`);
      if (exact !== document.activeElement) exact.value = words;
      div.querySelector(".unit").textContent = unit;
    }
    for (const select of ends) showEnd(select, whatIf, radiiOf(doc));
    const neutral = isNeutral(whatIf);
    reset.disabled = neutral && whatIf.from === null && whatIf.to === null;
    keep.disabled = neutral;
    host.classList.toggle("changed", !neutral);
  }

  rows.addEventListener("input", ({ target }) => {
    if (!(target instanceof HTMLInputElement)) return;
    const { key } = target.closest("div").dataset;
    if (target.type === "range") {
      const value = key.startsWith("offsets") ? target.valueAsNumber : Number((2 ** target.valueAsNumber).toPrecision(4));
      return choose(key, value);
    }
    const value = fieldValue(target.value);
    if (typeof value === "number" && (key.startsWith("offsets") ? value >= 0 : value > 0)) choose(key, value);
  });
  rows.addEventListener("focusout", () => store.get().doc && show(store.get()));
  reset.addEventListener("click", () => store.set({ whatIf: NEUTRAL }));
  keep.addEventListener("click", async () => {
    const { doc, whatIf } = store.get();
    const result = await client.call("keep", "change_blade", doc, changesOf(whatIf));
    if (result === null || store.get().doc !== doc || store.get().whatIf !== whatIf) return;
    if (result.status === "ok") blade.replace(result.value.blade, { whatIf: NEUTRAL });
    else say(`The changes are kept once the blade has no fault: ${result.faults[0].path}: ${result.faults[0].message}`);
  });
  store.subscribe((state, changed) => {
    if (state.doc === null) return;
    if (changed.has("doc")) fit(state.doc);
    if (changed.has("doc") || changed.has("whatIf")) show(state);
  });
}
