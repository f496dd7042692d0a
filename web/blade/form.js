// Rotor and roots as fields. Each field is bound to a path of the blade file by `data-path`.

import { at, make } from "../lib/dom.js";
import { fieldValue } from "../lib/format.js";
import { unitOf } from "../lib/unit-words.js";
import { setAt, valueAt } from "./document.js";

const ROOTS = {
  flap: { name: "Flap", kinds: ["hingeless", "hinged", "spring-hinged"] },
  lag: { name: "Lag", kinds: ["hingeless", "hinged", "spring-hinged"] },
  torsion: { name: "Torsion", kinds: ["rigid", "spring"] },
};
const SPRUNG = ["spring-hinged", "spring"];

/** A labelled field for the number at a path; its unit and its faults stand beside and below. */
function field(label, path, unit) {
  const input = make("input", { type: "text", inputMode: "decimal", autocomplete: "off", spellcheck: false, id: `field-${path}`, dataset: { path } });
  const fault = make("p", { className: "field-fault", id: `fault-${path}`, hidden: true, dataset: { faultOf: path } });
  input.setAttribute("aria-describedby", fault.id);
  return make(
    "div",
    { className: "form-field" },
    make("label", { htmlFor: input.id, textContent: label }),
    make("span", { className: "with-unit" }, input, make("span", { className: "unit", dataset: { unit } })),
    fault,
  );
}

function rootFields(dof) {
  const { name, kinds } = ROOTS[dof];
  const kind = make("select", { id: `field-${dof}.root`, dataset: { path: `${dof}.root` } }, ...kinds.map((kind) => new Option(kind, kind)));
  const measure = make(
    "select",
    { ariaLabel: `${name} offset as`, dataset: { offsetOf: dof } },
    new Option("", "offset"),
    new Option("R", "offset_ratio"),
  );
  const offset = field("offset", `${dof}.offset`, "length");
  offset.querySelector(".unit").replaceWith(measure);
  return make(
    "fieldset",
    { className: "form-root", dataset: { dof } },
    make("legend", { textContent: name }),
    make("div", { className: "form-field" }, make("label", { htmlFor: kind.id, textContent: "root" }), kind),
    offset,
    field("spring", `${dof}.spring`, "spring"),
  );
}

/** Which of offset and offset_ratio a root gives. */
const measured = (doc, dof) => (doc[dof]?.offset_ratio !== undefined ? "offset_ratio" : "offset");

function show(form, doc) {
  for (const dof of Object.keys(ROOTS)) {
    const input = form.querySelector(`[data-path^="${dof}.offset"]`);
    input.dataset.path = `${dof}.${measured(doc, dof)}`;
    const choice = form.querySelector(`[data-offset-of="${dof}"]`);
    choice.options[0].textContent = unitOf("length", doc.units);
    choice.value = measured(doc, dof);
    const spring = form.querySelector(`[data-path="${dof}.spring"]`);
    spring.closest(".form-field").hidden = !SPRUNG.includes(doc[dof]?.root) && doc[dof]?.spring === undefined;
  }
  for (const unit of form.querySelectorAll(".unit")) unit.textContent = unitOf(unit.dataset.unit, doc.units) ?? "";
  for (const input of form.querySelectorAll("[data-path]")) {
    if (input === document.activeElement && input.tagName === "INPUT") continue;
    const value = valueAt(doc, input.dataset.path);
    input.value = value ?? "";
  }
}

/** Marks the fields that faults name, and says beside them what is wrong. */
function showFaults(form, faults) {
  for (const input of form.querySelectorAll("[data-path]")) {
    const { path } = input.dataset;
    const own = faults.filter((fault) => fault.path === path);
    input.setAttribute("aria-invalid", String(own.length > 0));
    const note = input.closest(".form-field").querySelector(".field-fault");
    if (note === null) continue;
    note.textContent = own.map((fault) => fault.message).join("; ");
    note.hidden = own.length === 0;
  }
}

/** Another root: the spring goes where none is taken, and comes as 0 where one is. */
function chooseRoot(doc, dof, kind) {
  setAt(doc, `${dof}.root`, kind);
  if (!SPRUNG.includes(kind)) setAt(doc, `${dof}.spring`, undefined);
  else if (doc[dof].spring === undefined) setAt(doc, `${dof}.spring`, 0);
}

function chooseMeasure(doc, dof, measure) {
  const other = measure === "offset" ? "offset_ratio" : "offset";
  const { radius } = doc.rotor ?? {};
  const value = doc[dof]?.[other];
  setAt(doc, `${dof}.${other}`, undefined);
  const known = typeof value === "number" && typeof radius === "number" && radius > 0;
  const moved = known ? Number((measure === "offset" ? value * radius : value / radius).toPrecision(15)) : value;
  setAt(doc, `${dof}.${measure}`, moved ?? (measure === "offset_ratio" ? 0 : undefined));
}

/** Makes the form: it shows the blade, and every change goes into it. */
export function startForm(store, blade) {
  const form = at("form");
  const speed = make("select", { ariaLabel: "Unit of nominal speed", id: "nominal-unit", dataset: { convert: "speed" } });
  const nominal = field("nominal speed", "rotor.nominal_speed", "speed");
  nominal.querySelector(".unit").replaceWith(speed);
  form.append(
    make(
      "div",
      { className: "form-field wide" },
      make("label", { htmlFor: "field-name", textContent: "name" }),
      make("input", { type: "text", id: "field-name", autocomplete: "off", dataset: { path: "name", text: "" } }),
    ),
    field("radius", "rotor.radius", "length"),
    nominal,
    field("blades", "rotor.blades", ""),
    ...Object.keys(ROOTS).map(rootFields),
  );
  form.addEventListener("input", ({ target }) => {
    if (!(target instanceof HTMLInputElement)) return;
    const { path, text } = target.dataset;
    if (path === undefined) return;
    const value = text === undefined ? fieldValue(target.value) : target.value === "" ? undefined : target.value;
    blade.edit((doc) => setAt(doc, path, value), path);
  });
  form.addEventListener("change", ({ target }) => {
    if (!(target instanceof HTMLSelectElement)) return;
    const { path, offsetOf } = target.dataset;
    if (path?.endsWith(".root")) blade.edit((doc) => chooseRoot(doc, path.split(".")[0], target.value));
    if (offsetOf !== undefined) blade.edit((doc) => chooseMeasure(doc, offsetOf, target.value));
  });
  form.addEventListener("focusout", () => store.get().doc && show(form, store.get().doc));
  store.subscribe((state, changed) => {
    if (changed.has("doc") && state.doc !== null) show(form, state.doc);
    if (changed.has("faults")) showFaults(form, state.faults);
  });
}
