// The frame of a fan chart: from pixels to numbers and back, and where the drawn lines are.

import { labelAt, motionsOf } from "../lib/labels.js";

/** How many rad/s one unit of speed or frequency is, by its name. */
const RAD_S = {};
/** Far outside of every drawing, and still a number that a path takes. */
const FAR = 1e5;

/** Takes in the units as the package has them, before anything is drawn. */
export function knowUnits(units) {
  for (const { name, rad_s } of units) RAD_S[name] = rad_s;
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

  /**
   * Where the drawn lines of the branches are at a speed, as far as that is in the frame: {branch, dof, x, y, slope}
   * with the place among the branches and the motion that leads there.
   */
  points(speed) {
    const { speeds_rad_s: speeds, branches } = this.report;
    const beyond = speeds.findIndex((each) => each > speed);
    const high = Math.max(1, beyond < 0 ? speeds.length - 1 : beyond);
    const x = this.x(speed);
    const [from, to] = [high - 1, high].map((i) => this.x(speeds[i]));
    return branches
      .map((line, branch) => {
        const [low, up] = [high - 1, high].map((i) => this.y(line.frequency_rad_s[i], speeds[i]));
        const slope = (up - low) / (to - from);
        return { branch, dof: motionsOf(labelAt(line, speed))[0], x, y: low + slope * (x - from), slope };
      })
      .filter((point) => this.holds(point, 0.5)); // nor where there is no frequency
  }
}
