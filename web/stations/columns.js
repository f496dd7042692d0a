// The columns of the sheet of stations: the properties of the blade file, as the field calls them.

import { unitOf } from "../lib/unit-words.js";

export const RADIUS = "r";
/**
 * Properties in the order of the sheet. `optional` ones are 0 where they are absent; `rare` ones have a
 * column only where the blade gives them.
 */
export const PROPERTIES = [
  { id: "mass", name: "mass", unit: "mass" },
  { id: "flap_stiffness", name: "flap stiffness", unit: "stiffness" },
  { id: "lag_stiffness", name: "lag stiffness", unit: "stiffness" },
  { id: "torsion_stiffness", name: "torsion stiffness", unit: "stiffness" },
  { id: "polar_inertia", name: "polar inertia", unit: "inertia" },
  { id: "mass_offset", name: "mass offset", unit: "length", optional: true },
  { id: "twist", name: "twist", unit: "angle", optional: true },
  { id: "flap_inertia", name: "flap inertia", unit: "inertia", optional: true, rare: true },
  { id: "lag_inertia", name: "lag inertia", unit: "inertia", optional: true, rare: true },
  { id: "tension_offset", name: "tension offset", unit: "length", optional: true, rare: true },
  { id: "axial_stiffness", name: "axial stiffness", unit: "force", optional: true, rare: true },
  { id: "trapeze_radius", name: "trapeze radius", unit: "length", optional: true, rare: true },
];
const COLUMNS = [{ id: RADIUS, name: "r", unit: "length" }, ...PROPERTIES];

export const column = (id) => COLUMNS.find((one) => one.id === id);
export const unitOfColumn = (id, units) => unitOf(column(id).unit, units);

/** Whether words in round brackets are a unit, not part of a name as in “EI (flap)”. */
const UNIT = /^\s*(mm|cm|m|in|inch|inches|ft|deg|degrees?|rad|°|″|kg|g|lbm?|lbf|slugs?|k?n|nm\^?[2²]?)(?![a-z])/i;

/** Name without case, marks and unit, for comparing. */
const plain = (text) =>
  text
    .toLowerCase()
    .replace(/\[.*?\]/g, " ")
    .replace(/\((.*?)\)/g, (_, words) => (UNIT.test(words) ? " " : ` ${words} `))
    .replace(/[^a-zµμθ0-9/]+/g, " ")
    .trim();

/** What stands in the brackets of a header, or null. */
export const headerUnit = (text) =>
  (/\[([^\]]*)\]/.exec(text)?.[1] ?? [...text.matchAll(/\(([^)]*)\)/g)].map(([, words]) => words).find((words) => UNIT.test(words)))?.trim() ?? null;

/** @type {[string, RegExp][]} */
const NAMES = [
  [RADIUS, /^(r|x|radius|radii|radial (station|position|location|coordinate)|(blade|span|spanwise|radial) station|span|station radius|r m+|r in)$/],
  ["torsion_stiffness", /^gj\b|^g j$|^(?!.*inertia).*\btorsion/],
  ["flap_stiffness", /^(?!.*(inertia|offset|area|radius|hinge)|i ).*\b(flap|flapwise|flapping|flatwise|beam|beamwise|eiflap|eif|eib|out of plane)\b/],
  [
    "lag_stiffness",
    /^(?!.*(inertia|offset|area|radius|hinge)|i ).*\b(lag|lagwise|lead|chord|chordwise|edge|edgewise|inplane|eilag|eil|eic|in plane)\b/,
  ],
  ["mass_offset", /\b(offset|cg|c g|xcg|centre of (mass|gravity)|center of (mass|gravity))\b|^e$/],
  ["polar_inertia", /\binertia\b|^(i ?p|i ?theta|i ?θ|polar|i polar)$/],
  ["twist", /\btwist\b|^(theta|θ)$/],
  ["mass", /^(m|µ|μ|mu|mass|running mass|linear density|mass per (unit )?(length|span)|mass\/(unit )?length|mass distribution)$/],
];

/** The column that a header names, or null. */
export function columnOf(text) {
  const name = plain(text);
  return NAMES.find(([, pattern]) => pattern.test(name))?.[0] ?? null;
}

/** Whether a header gives radii as a ratio: they are no lengths. */
export const isRatio = (text) => /^(r|x|radius)\s*\/\s*r(adius)?$/.test(plain(text));

const SPELLED = (unit) =>
  unit
    .toLowerCase()
    .replace(/²|\^2|\*\*2/g, "2")
    .replace(/[\s·*.×^⋅-]|\*\*/g, "")
    .replace(/inches|inch|″|"/g, "in")
    .replace(/radians|radian/g, "rad")
    .replace(/degrees|degree|°/g, "deg")
    .replace(/lbm/g, "lb");

/** Whether a unit as someone writes it is this column's in these units. */
export function isUnit(text, id, units) {
  const own = SPELLED(unitOfColumn(id, units));
  const { length = "m", mass = "kg" } = units ?? {};
  const same = id === "polar_inertia" ? [own, SPELLED(`${mass}${length}2/${length}`)] : [own];
  const given = SPELLED(text);
  // Products may be written in either order: lbf·in² and in²·lbf.
  const turned = given.replace(/^([a-z]+2?)(lbf|kn|n|kg|g|lb|slug)(?=\/|$)/, "$2$1");
  return same.some((unit) => unit === given || unit === turned);
}
