// Numbers and words as the page shows them, and numbers as its fields hold them. Full precision is kept
// everywhere else.

const FOUR_FIGURES = new Intl.NumberFormat("en-GB", {
  minimumSignificantDigits: 4,
  maximumSignificantDigits: 4,
  useGrouping: false,
});

/** Four significant figures, with a real minus sign; nothing is known of what is no number. */
export function figures(value) {
  if (!Number.isFinite(value)) return "–";
  if (value === 0) return "0";
  return FOUR_FIGURES.format(value).replace("-", "−");
}

/** A number for an input field: up to `digits` significant figures, no trailing zeros. */
export function fieldNumber(value, digits = 5) {
  return String(Number(value.toPrecision(digits)));
}

/**
 * The number that a field holds; its text where that is none; undefined where it is empty. A comma is
 * a decimal one, but 1,234 may mean two numbers and is neither.
 */
export function fieldValue(text) {
  const plain = text
    .trim()
    .replace(/[−‒–]/g, "-")
    .replace(/[\s\u00a0\u202f]/g, "");
  if (plain === "") return undefined;
  const decimal = /^[+-]?\d+,\d+$/.test(plain) && !/^[+-]?[1-9]\d{0,2},\d{3}$/.test(plain);
  const number = Number(decimal ? plain.replace(",", ".") : plain);
  return Number.isFinite(number) ? number : text.trim();
}

/** The frequency of a mode; a coupled one may have none. */
export const frequencyWords = (mode) => (mode.unstable ? "unstable" : figures(mode.frequency_rad_s));

/** A share of a mode's energy in percent; the rounding of none may be below 0. */
export const shareFigure = (share) => (100 * Math.max(0, share)).toFixed(0);

/** "flap 26 %, lag 21 %, torsion 52 %", the motions' shares of a mode's energy. */
export const sharesWords = (shares) =>
  Object.entries(shares)
    .map(([motion, share]) => `${motion} ${shareFigure(share)} %`)
    .join(", ");

/** "0.31 below 3P", with a unit after the number where one is given; nothing is known at rest. */
export function marginWords({ nearest_harmonic: harmonic, margin_per_rev: distance }, unit = "") {
  if (harmonic === null) return "–";
  const size = Math.abs(distance);
  if (size < 5e-5) return `on ${harmonic}P`;
  const words = size < 0.01 ? size.toFixed(4) : size.toFixed(2);
  return `${words}${unit} ${distance < 0 ? "below" : "above"} ${harmonic}P`;
}

/** A frequency over the rotor speed: "2.981"; nothing is known at rest. */
export const perRevWords = (perRev) => (perRev === null ? "–" : perRev.toFixed(3));

/** Where a branch meets a harmonic: "4F × 9P". */
export const crossingWords = ({ label, harmonic }) => `${label} × ${harmonic}P`;

/** The crossings of a fan chart within a band, two ratios of nominal speed, the slowest first. */
export function crossingsWithin({ crossings, nominal }, band) {
  const [from, to] = band.map((ratio) => ratio * nominal.speed_rad_s);
  return crossings.filter(({ speed_rad_s: speed }) => speed >= from && speed <= to).sort((a, b) => a.speed_rad_s - b.speed_rad_s);
}

/** Of several modes the one closest to a harmonic up to the last that is looked at; null where none is near one, as at rest. */
export function closestOf(modes, harmonics = Infinity) {
  const near = modes.filter((mode) => mode.nearest_harmonic !== null && mode.nearest_harmonic <= harmonics);
  return near.reduce((a, b) => (a !== null && Math.abs(a.margin_per_rev) <= Math.abs(b.margin_per_rev) ? a : b), null);
}

/** Bounds further apart than this share of the frequency: not converged. */
const CONVERGED = 1e-3;

const RAISED = { "-": "⁻", 0: "⁰", 1: "¹", 2: "²", 3: "³", 4: "⁴", 5: "⁵", 6: "⁶", 7: "⁷", 8: "⁸", 9: "⁹" };

/** One digit and a power of ten, rounded up: a bound may not promise more than it holds. */
function roundedUp(value) {
  if (!(value > 0)) return "0";
  let [digit, power] = value.toExponential(0).split("e").map(Number);
  if (Number(`${digit}e${power}`) < value) [digit, power] = digit === 9 ? [1, power + 1] : [digit + 1, power];
  return `${digit}·10${[...String(power)].map((letter) => RAISED[letter]).join("")}`;
}

/** "separation not proven (about 2·10⁻⁵)" where a mode has no bounds; empty where it has. */
function missingWords({ bounds_missing: missing, error_estimate_rad_s: error }, unit) {
  if (!missing) return "";
  return error === null ? missing : `${missing} (about ${roundedUp(error)}${unit})`;
}

/** "±2·10⁻⁹" around the frequency, with a unit after it where one is given, or both bounds where they are far apart. */
export function boundsWords(mode, unit = "") {
  const missing = missingWords(mode, unit);
  if (missing !== "") return missing;
  const { frequency_rad_s: frequency, lower_rad_s: lower, upper_rad_s: upper } = mode;
  if (lower === null || upper === null) return "–";
  if (!(upper - lower <= CONVERGED * frequency || upper === lower)) return `${figures(lower)}\u00a0…\u00a0${figures(upper)}, not\u00a0converged`;
  const half = Math.max(frequency - lower, upper - frequency, 0);
  return frequency === 0 && half === 0 ? "exact" : `±${roundedUp(half)}${unit}`;
}

/** How far a value is from another, in % of that; null where that cannot be said. */
export function percent(value, reference) {
  if (value === null || reference === null) return null;
  if (value === reference) return 0;
  const error = 100 * (value / reference - 1);
  return Number.isFinite(error) ? error : null;
}

/** A difference in % with its sign and two figures: "+0.098 %", "−12 %". */
export function percentWords(difference) {
  if (difference === null) return "–";
  if (difference === 0) return "0 %";
  const size = Math.abs(difference);
  if (size < 1e-4) return "<0.0001 %";
  const decimals = Math.min(4, Math.max(0, 1 - Math.floor(Math.log10(size))));
  return `${difference < 0 ? "−" : "+"}${size.toFixed(decimals)} %`;
}

/** How far the paper's functions are from the converged frequency: "+0.098 %". */
export const paperWords = ({ classical_rad_s: classical, converged_rad_s: converged }) => percentWords(percent(classical, converged));

/** What a word must not begin with in a spreadsheet, which takes such words for formulas, and some wide letters for the narrow ones. */
const FORMULA = /^[=+\-@\t\r\n\uff1d\uff0b\uff0d\uff20]/;

/** A cell for a spreadsheet: every digit of a number; a word that begins like a formula with an apostrophe before it; nothing for null or NaN. */
export function cellText(value) {
  if (typeof value === "number") return Number.isNaN(value) ? "" : String(value);
  const text = String(value ?? "");
  return FORMULA.test(text) ? `'${text}` : text;
}

/** The assumed functions in words. */
export function basisWords({ family, functions }) {
  const given = Object.entries(functions).filter(([, count]) => count !== null);
  if (family === "classical" && given.length > 0) return `classical, ${given[0][1]} functions`;
  return [`${family} functions`, ...given.map(([dof, count]) => `${dof} ${count}`)].join(", ");
}

/** TOML or JSON, by the first character that is not blank, as the package takes a text. */
export function textFormat(text) {
  return text.trimStart().startsWith("{") ? "json" : "toml";
}
