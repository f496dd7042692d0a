// What modes and branches are called: by a number and the letter of the leading motion, "1T", with a second
// motion behind it where a coupled mode is mixed, "1T/F". The first part names a mode among those of one speed.

const MOTIONS = { F: "flap", L: "lag", T: "torsion" };

/** "1T" of a mode that is called "1T/F". */
export const nameOf = ({ label }) => label.split("/")[0];

/** The motions in a label, the leading one first. */
export const motionsOf = (label) => [...label].map((letter) => MOTIONS[letter]).filter((motion) => motion !== undefined);

/** What a branch of a fan chart is called at a rotor speed. */
export function labelAt({ label, labels = [] }, speed) {
  return (labels.findLast(({ from_rad_s: from }) => from <= speed) ?? labels[0] ?? { label }).label;
}

/**
 * The mode of this name. There may be none, for coupled modes are as many as asked for in all: then the highest
 * with the same leading motion, or the lowest of all; null of none.
 */
export function modeOf(modes, name) {
  const [motion] = motionsOf(name);
  return modes.find((mode) => nameOf(mode) === name) ?? modes.findLast(({ dof }) => dof === motion) ?? modes[0] ?? null;
}
