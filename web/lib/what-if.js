// What-if: changes of a blade for a look, beside it. The package makes the changed blade of them.

const PLAIN = Object.freeze({ flap_stiffness: 1, lag_stiffness: 1, torsion_stiffness: 1, mass: 1 });
const NONE = Object.freeze({});
/**
 * The unchanged blade. `from` and `to` are radii, null for the whole span; these and the `offsets` are in
 * the unit `length`, whatever the blade's own becomes; null is the blade's own.
 */
export const NEUTRAL = Object.freeze({ factors: PLAIN, from: null, to: null, offsets: NONE, springs: NONE, length: null });

/** The unit of length of a blade. */
export const lengthOf = (doc) => doc.units?.length ?? "m";

/** Whether nothing is changed. */
export function isNeutral({ factors, offsets, springs }) {
  const ones = (table) => Object.values(table).every((factor) => factor === 1);
  return ones(factors) && ones(springs) && Object.keys(offsets).length === 0;
}

/** The changes as the package takes them, with the unit that their lengths are in. */
export function changesOf({ factors, from, to, offsets, springs, length }) {
  const units = length === null ? {} : { units: { length } };
  const scaled = (table) => Object.entries(table).filter(([, factor]) => factor !== 1);
  return [
    ...scaled(factors).map(([name, scale]) => ({ what: `distribution.${name}`, scale, from, to, ...units })),
    ...Object.entries(offsets).map(([dof, set]) => ({ what: `${dof}.offset`, set, ...units })),
    ...scaled(springs).map(([dof, scale]) => ({ what: `${dof}.spring`, scale })),
  ];
}

/** The lengths among the changes in one list, and the same changes with others in their place. */
export const lengthsOf = ({ from, to, offsets }) => [from, to, ...Object.values(offsets)].filter((length) => length !== null);
export function withLengths(whatIf, lengths, length) {
  const rest = [...lengths];
  const [from, to] = [whatIf.from, whatIf.to].map((end) => (end === null ? null : rest.shift()));
  const offsets = Object.fromEntries(Object.keys(whatIf.offsets).map((dof) => [dof, rest.shift()]));
  return { ...whatIf, from, to, offsets, length };
}
