// What is said of the chosen mode.

import { boundsWords, fieldNumber, figures, frequencyWords, marginWords, paperWords, perRevWords, sharesWords } from "../lib/format.js";

/** The chosen mode in one line, with what the table has no room for. */
export function modeWords(mode, functions) {
  const parts = mode.unstable
    ? [`unstable, ω² = ${figures(mode.eigenvalue_s2)} 1/s²`]
    : [`${frequencyWords(mode)} rad/s`, `${figures(mode.frequency_hz)} Hz`];
  if (mode.per_rev !== null) parts.push(`${perRevWords(mode.per_rev)}/rev, ${marginWords(mode)}`);
  if (mode.shares) parts.push(`energy ${sharesWords(mode.shares)}`);
  const bounds = boundsWords(mode, " rad/s");
  if (bounds !== "–") parts.push(`bounds ${bounds}`);
  if (mode.classical_rad_s !== null) parts.push(`the paper’s ${functions} functions ${figures(mode.classical_rad_s)} rad/s, ${paperWords(mode)}`);
  return parts.join("; ");
}

/** "33 times slower than real". */
export function slowerWords(slower) {
  if (slower >= 0.95 && slower < 1.05) return "as fast as real";
  const times = slower >= 1 ? slower : 1 / slower;
  return `${times >= 10 ? times.toFixed(0) : fieldNumber(times, 2)} times ${slower >= 1 ? "slower" : "faster"} than real`;
}

/** How a mode moves on the page, from its pace there; `even` where every mode has the same. */
export function paceWords(mode, { mode: hertz, slower, held }, even) {
  if (mode.unstable) return "This mode is unstable here: the blade does not swing but leaves its place. Its shape is shown.";
  if (hertz === 0) return "This mode has no frequency here: the blade turns freely about its hinge.";
  const words = [`Deflection not to scale; ${slowerWords(slower)}${held && !even ? ", slowed further to be seen" : ""}.`];
  if (mode.per_rev !== null) words.push(`${fieldNumber(mode.per_rev, 3)} swings per revolution.`);
  if (mode.shares) words.push("Each motion is as large as its share of the energy.");
  return words.join(" ");
}
