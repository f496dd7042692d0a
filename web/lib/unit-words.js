// Units of the blade file as the page writes them beside its numbers.

/** The unit of what a field holds, in the blade's units. */
export function unitOf(kind, units) {
  const { length = "m", mass = "kg", force = "N", speed = "rad/s", angle = "rad" } = units ?? {};
  return {
    length,
    angle,
    force,
    speed,
    mass: `${mass}/${length}`,
    stiffness: `${force}·${length}²`,
    spring: `${force}·${length}/rad`,
    inertia: `${mass}·${length}`,
  }[kind];
}
