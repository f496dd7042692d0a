// Numbers and words as the page shows them, and numbers as its fields hold them. Full precision is kept
// everywhere else.

const FOUR_FIGURES = new Intl.NumberFormat("en-GB", {
  minimumSignificantDigits: 4,
  maximumSignificantDigits: 4,
  useGrouping: false,
});

/** Four significant figures, with a real minus sign. */
export function figures(value) {
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
  const plain = text.trim().replace(/[−‒–]/g, "-").replace(/[\s\u00a0\u202f]/g, "");
  if (plain === "") return undefined;
  const decimal = /^[+-]?\d+,\d+$/.test(plain) && !/^[+-]?[1-9]\d{0,2},\d{3}$/.test(plain);
  const number = Number(decimal ? plain.replace(",", ".") : plain);
  return Number.isFinite(number) ? number : text.trim();
}

/** "0.31 below 3P", with a unit after the number where one is given; nothing is known at rest. */
export function marginWords({ nearest_harmonic: harmonic, margin_per_rev: distance }, unit = "") {
  if (harmonic === null) return "–";
  const size = Math.abs(distance);
  if (size < 5e-5) return `on ${harmonic}P`;
  const words = size < 0.01 ? size.toFixed(4) : size.toFixed(2);
  return `${words}${unit} ${distance < 0 ? "below" : "above"} ${harmonic}P`;
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

/** "±2·10⁻⁹" around the frequency, or both bounds where they are far apart. */
export function boundsWords({ frequency_rad_s: frequency, lower_rad_s: lower, upper_rad_s: upper }) {
  if (lower === null || upper === null) return "–";
  if (!(upper - lower <= CONVERGED * frequency || upper === lower)) return `${figures(lower)}\u00a0…\u00a0${figures(upper)}, not\u00a0converged`;
  const half = Math.max(frequency - lower, upper - frequency, 0);
  return frequency === 0 && half === 0 ? "exact" : `±${roundedUp(half)}`;
}

/** How far a value is from another, in % of that; null where that cannot be said. */
export function percent(value, reference) {
  if (value === null || reference === null) return null;
  if (value === reference) return 0;
  const error = 100 * (value / reference - 1);
  return Number.isFinite(error) ? error : null;
}

/** How far the paper's functions are from the converged frequency: "+0.098 %". */
export function paperWords({ classical_rad_s: classical, converged_rad_s: converged }) {
  const error = percent(classical, converged);
  if (error === null) return "–";
  if (error === 0) return "0 %";
  const size = Math.abs(error);
  if (size < 1e-4) return "<0.0001 %";
  const decimals = Math.min(4, Math.max(0, 1 - Math.floor(Math.log10(size))));
  return `${error < 0 ? "−" : "+"}${size.toFixed(decimals)} %`;
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
