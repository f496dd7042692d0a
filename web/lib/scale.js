// What-if: a blade with some of its properties scaled, as another blade of the same file keys.

export const PROPERTIES = ["mass", "flap_stiffness", "lag_stiffness", "torsion_stiffness", "polar_inertia", "mass_offset", "twist"];
const PLAIN = Object.freeze({ flap_stiffness: 1, lag_stiffness: 1, torsion_stiffness: 1, mass: 1 });
const NONE = Object.freeze({});
/** The unchanged blade. `from` and `to` are radii in the blade's unit, null for the whole span. */
export const NEUTRAL = Object.freeze({ factors: PLAIN, from: null, to: null, offsets: NONE, springs: NONE });

/** Whether nothing is changed. */
export function isNeutral({ factors, offsets, springs }) {
  const ones = (table) => Object.values(table).every((factor) => factor === 1);
  return ones(factors) && ones(springs) && Object.keys(offsets).length === 0;
}

/** The blade with the changes; the same object where there are none. */
export function scaled(doc, whatIf) {
  if (doc === null || isNeutral(whatIf)) return doc;
  const out = structuredClone(doc);
  const { factors, from, to, offsets, springs } = whatIf;
  for (const [name, factor] of Object.entries(factors)) {
    const given = out.distribution?.[name];
    if (given === undefined || factor === 1) continue;
    out.distribution[name] = from === null && to === null ? times(given, factor) : timesOn(points(out, name), from ?? -Infinity, to ?? Infinity, factor);
  }
  for (const [dof, offset] of Object.entries(offsets)) {
    if (out[dof] === undefined) continue;
    delete out[dof].offset_ratio;
    out[dof].offset = offset;
  }
  for (const [dof, factor] of Object.entries(springs)) {
    if (typeof out[dof]?.spring === "number") out[dof].spring *= factor;
  }
  return out;
}

const by = (factor) => (value) => (typeof value === "number" ? value * factor : value);

function times(property, factor) {
  if (Array.isArray(property)) return property.map(by(factor));
  if (typeof property === "object" && property !== null) return { ...property, values: property.values.map(by(factor)) };
  return by(factor)(property);
}

/** Radii and values of a property, on `distribution.r`, on radii of its own, or constant. */
export function points(doc, name) {
  const given = doc.distribution[name];
  if (Array.isArray(given)) return { r: doc.distribution.r ?? [], values: given };
  if (typeof given === "object" && given !== null) return { r: given.r ?? [], values: given.values ?? [] };
  return { r: [0, doc.rotor?.radius ?? 1], values: [given, given] };
}

/** The property with the part between two radii scaled, a step at either end of it. */
function timesOn({ r, values }, from, to, factor) {
  const radii = [];
  const out = [];
  const put = (x, y) => {
    radii.push(x);
    out.push(y);
  };
  const inside = (a, b) => a >= from && b <= to;
  for (let i = 0; i + 1 < r.length; i++) {
    const [a, b] = [r[i], r[i + 1]];
    if (!(a < b)) continue;
    const at = (x) => (x === a ? values[i] : x === b ? values[i + 1] : values[i] + ((values[i + 1] - values[i]) * (x - a)) / (b - a));
    const cuts = [a, ...[from, to].filter((x) => x > a && x < b), b];
    for (let k = 0; k + 1 < cuts.length; k++) {
      const own = inside(cuts[k], cuts[k + 1]) ? factor : 1;
      put(cuts[k], at(cuts[k]) * own);
      put(cuts[k + 1], at(cuts[k + 1]) * own);
    }
  }
  return tidy(radii, out);
}

/** Without the second of two equal points. */
function tidy(r, values) {
  const keep = r.map((x, i) => i === 0 || x !== r[i - 1] || values[i] !== values[i - 1]);
  return { r: r.filter((_, i) => keep[i]), values: values.filter((_, i) => keep[i]) };
}
