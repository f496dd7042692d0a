// The rotor speed in the units of the page.

/** How many rad/s one of this unit is. */
export const unitFactor = (state, name) => state.about.speed_units.find((unit) => unit.name === name).rad_s;

/** A rotor speed in the unit of the page; nominal from what was solved there. */
export function shownSpeed(speed, state) {
  if (speed !== null && speed.unit === state.speedUnit) return speed.value;
  return Number((state.modes.speed_rad_s / unitFactor(state, state.speedUnit)).toPrecision(12));
}
