// Whether plain data has the form of a blade, whatever its values are: then the form and the sheet can
// show it, and the package says what is wrong with it.

const ROOTS = ["flap", "lag", "torsion"];
const TABLES = ["rotor", "units", "source", ...ROOTS];

const isTable = (value) => typeof value === "object" && value !== null && !Array.isArray(value);
const isLeaf = (value) => ["number", "string", "boolean"].includes(typeof value);
/** Values may be missing in a list: JSON has null for them. */
const isList = (value) => Array.isArray(value) && value.every((entry) => entry === null || isLeaf(entry));
const isCurve = (value) =>
  isTable(value) && Object.keys(value).every((key) => ["r", "values"].includes(key)) && isList(value.r) && isList(value.values);

const isFlat = (value) => isTable(value) && Object.values(value).every(isLeaf);

/** Whether a value is a blade but for its values. */
export function isBladeShaped(doc) {
  if (!isTable(doc)) return false;
  const { distribution = {}, point_mass: masses = [], ...rest } = doc;
  if (!Array.isArray(masses) || !masses.every(isFlat)) return false;
  if (!isTable(distribution) || (distribution.r !== undefined && !isList(distribution.r))) return false;
  const properties = Object.values(distribution).every((value) => isLeaf(value) || isList(value) || isCurve(value));
  return properties && Object.entries(rest).every(([key, value]) => (TABLES.includes(key) ? isFlat(value) : isLeaf(value)));
}
