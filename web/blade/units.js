// The units of the blade: switched at any time, its numbers converted by the package.

import { at } from "../lib/dom.js";

const SETS = [
  { name: "SI (m, kg, N)", units: { length: "m", mass: "kg", force: "N" } },
  { name: "mm, kg, N", units: { length: "mm", mass: "kg", force: "N" } },
  { name: "in, lb, lbf", units: { length: "in", mass: "lb", force: "lbf" } },
  { name: "ft, slug, lbf", units: { length: "ft", mass: "slug", force: "lbf" } },
];

const given = ({ length = "m", mass = "kg", force = "N" } = {}) => ({ length, mass, force });
const same = (a, b) => ["length", "mass", "force"].every((key) => a[key] === b[key]);

/** Makes the choice of units, and that of the nominal speed's. */
export function startUnits(store, client, blade, say) {
  const choice = at("units");
  const speed = /** @type {HTMLSelectElement} */ (at("nominal-unit"));

  async function convert(units) {
    const { doc } = store.get();
    const result = await client.call("convert", "convert_blade", doc, units);
    if (result === null || store.get().doc !== doc) return;
    if (result.status === "ok") blade.edit((copy) => replace(copy, result.value));
    else say(`Units are converted once the blade has no fault: ${result.faults[0].path}: ${result.faults[0].message}`);
    show(store.get());
  }

  function show({ doc, about }) {
    if (doc === null || about === null) return;
    const now = given(doc.units);
    const known = SETS.findIndex((set) => same(set.units, now));
    choice.replaceChildren(
      ...SETS.map((set, i) => new Option(set.name, String(i), false, i === known)),
      ...(known < 0 ? [new Option(`${now.length}, ${now.mass}, ${now.force}`, "-1", false, true)] : []),
    );
    choice.disabled = false;
    const speedUnit = doc.units?.speed ?? "rad/s";
    speed.replaceChildren(...about.speed_units.map(({ name }) => new Option(name, name, false, name === speedUnit)));
  }

  choice.addEventListener("change", () => convert(SETS[Number(choice.value)].units));
  speed.addEventListener("change", () => convert({ speed: speed.value }));
  store.subscribe((state, changed) => {
    if (changed.has("doc") || changed.has("about")) show(state);
  });
}

/** Makes one object equal to another in place. */
function replace(object, other) {
  for (const key of Object.keys(object)) delete object[key];
  Object.assign(object, structuredClone(other));
}
