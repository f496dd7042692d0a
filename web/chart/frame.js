// The frame of a fan chart: from pixels to numbers and back, and what lies between the report's speeds.

/** How many rad/s one unit of speed or frequency is, by its name. */
const RAD_S = {};
/** Far outside of every drawing, and still a number that a path takes. */
const FAR = 1e5;

/** Takes in the units as the package has them, before anything is drawn. */
export function knowUnits(units) {
  for (const { name, rad_s } of units) RAD_S[name] = rad_s;
}

/** A branch's frequency between the report's speeds [rad/s]: λ = ω² is smooth in Ω², a parabola through three points follows it. */
export function between(speeds, frequencies, speed) {
  const last = speeds.length - 1;
  if (last < 2) return frequencies[0] ?? NaN;
  let low = 0;
  let high = last;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (speeds[middle] <= speed) low = middle;
    else high = middle;
  }
  const nearest = speed - speeds[low] < speeds[high] - speed ? low : high;
  const centre = Math.min(last - 1, Math.max(1, nearest));
  const points = [centre - 1, centre, centre + 1].map((i) => ({ x: speeds[i] ** 2, y: frequencies[i] ** 2 }));
  const x = speed ** 2;
  let sum = 0;
  for (const point of points) {
    let term = point.y;
    for (const other of points) if (other !== point) term *= (x - other.x) / (point.x - other.x);
    sum += term;
  }
  return Math.sqrt(Math.max(0, sum));
}

/** A frequency over the rotor speed with the harmonic nearest to it, in the words of the reports; nothing is known at rest. */
export function perRev(frequency, speed) {
  if (!(speed > 0)) return { per_rev: null, nearest_harmonic: null, margin_per_rev: null };
  const per_rev = frequency / speed;
  const nearest_harmonic = Math.max(1, Math.round(per_rev));
  return { per_rev, nearest_harmonic, margin_per_rev: per_rev - nearest_harmonic };
}

/** A frequency [rad/s] in a unit by its name on an axis or among the options; NaN per revolution at rest. */
export function inUnit(frequency, speed, unit) {
  if (unit in RAD_S) return frequency / RAD_S[unit];
  return speed > 0 ? frequency / speed : NaN;
}

/** How many rad/s one unit of frequency is; null for those that depend on the rotor speed. */
export const frequencyFactor = (unit) => RAD_S[unit] ?? null;

/** Pixels are those of the drawing's viewBox; speeds and frequencies are in rad/s. */
export class Frame {
  constructor({ plots, width, height, report }) {
    this.plot = plots[0];
    this.report = report;
    this.width = width;
    this.height = height;
    const { left, top, width: across, height: down } = this.plot;
    this.left = left;
    this.top = top;
    this.right = left + across;
    this.bottom = top + down;
    this.speedUnit = this.plot.x.unit;
    this.unit = this.plot.y.unit;
  }

  x(speed) {
    const { from, to } = this.plot.x;
    return this.left + ((speed / RAD_S[this.speedUnit] - from) / (to - from)) * this.plot.width;
  }

  y(frequency, speed) {
    const { from, to } = this.plot.y;
    const y = this.bottom - ((inUnit(frequency, speed, this.unit) - from) / (to - from)) * this.plot.height;
    return Math.min(FAR, Math.max(-FAR, y));
  }

  /** The speed at a pixel, within the axis. */
  speed(x) {
    const { from, to } = this.plot.x;
    const along = Math.min(1, Math.max(0, (x - this.left) / this.plot.width));
    return Math.max(0, from + along * (to - from)) * RAD_S[this.speedUnit];
  }

  /** The value on the frequency axis at a pixel, in the axis's unit. */
  value(y) {
    const { from, to } = this.plot.y;
    return from + Math.min(1, Math.max(0, (this.bottom - y) / this.plot.height)) * (to - from);
  }

  /** A speed in the unit of the axis. */
  shown(speed) {
    return speed / RAD_S[this.speedUnit];
  }

  /** The axis' ends [rad/s]. */
  get speeds() {
    return [this.plot.x.from, this.plot.x.to].map((value) => value * RAD_S[this.speedUnit]);
  }

  holds({ x, y }, margin = 0) {
    return x >= this.left - margin && x <= this.right + margin && y >= this.top - margin && y <= this.bottom + margin;
  }

  /** A branch's frequency at a speed of the chart [rad/s]. */
  frequency(branch, speed) {
    return between(this.report.speeds_rad_s, branch.frequency_rad_s, speed);
  }

  /** The branches' points at a speed, as far as they are in the frame. */
  points(speed) {
    const x = this.x(speed);
    return this.report.branches
      .map((branch) => {
        const frequency = this.frequency(branch, speed);
        return { branch, frequency, x, y: this.y(frequency, speed) };
      })
      .filter((point) => this.holds(point, 0.5));
  }
}
