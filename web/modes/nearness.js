// How near to a harmonic is near.

/** Margins to a harmonic below this, per rev, are worth a look … */
export const NEAR = 0.1;
/** … and below this a mode is taken as excited by it. */
export const TOO_NEAR = 0.05;

/** "near", "too near" or nothing, for harmonics up to the last one looked at. */
export function nearness({ nearest_harmonic: harmonic, margin_per_rev: margin }, harmonics = Infinity) {
  if (harmonic === null || harmonic > harmonics) return "";
  const size = Math.abs(margin);
  return size < TOO_NEAR ? "too near" : size < NEAR ? "near" : "";
}

/** Modes that are near a harmonic, the nearest first. */
export function nearModes(modes, harmonics) {
  return modes.filter((mode) => nearness(mode, harmonics) !== "").sort((a, b) => Math.abs(a.margin_per_rev) - Math.abs(b.margin_per_rev));
}

/** What the words mean. */
export const nearNote = (harmonics) => `near: less than ${NEAR}/rev from a harmonic up to ${harmonics}P; too near: less than ${TOO_NEAR}/rev.`;
