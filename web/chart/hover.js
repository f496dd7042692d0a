// What stands at the pointer, or where the keys have gone: branch, speed, frequency, nearest harmonic.

import { at, element } from "../lib/dom.js";
import { fieldNumber, figures, marginWords, perRevWords } from "../lib/format.js";
import { inUnit } from "./frame.js";

/** A branch is meant from this near, in pixels of the screen. */
const REACH = { mouse: 28, pen: 28, touch: 48 };
/** The keys go along a branch in so many steps. */
const STEPS = 100;

/** The lines of the readout, from what the solver says of a branch at a speed. */
export function words(reading, speed, unit, shownSpeed) {
  const { label, frequency_rad_s: frequency, per_rev: ratio } = reading;
  return [
    `${label} at ${fieldNumber(shownSpeed, 4)} ${unit}`,
    `${figures(frequency)} rad/s, ${figures(inUnit(frequency, speed, "Hz"))} Hz${ratio === null ? "" : `, ${perRevWords(ratio)}/rev`}`,
    ...(ratio === null ? [] : [marginWords(reading, "/rev")]),
  ];
}

/** The point of a branch nearest to a pixel, at the pixel's speed; the distance is across the branch. */
export function nearest(frame, { x, y }) {
  const speed = frame.speed(x);
  let best = null;
  for (const point of frame.points(speed)) {
    const distance = Math.abs(y - point.y) / Math.hypot(1, point.slope);
    if (best === null || distance < best.distance) best = { ...point, speed, distance };
  }
  return best;
}

/**
 * Makes the readout. `read(report, speed)` resolves to what the solver says of the report's branches at a speed
 * [rad/s], or null where a newer question has come in; `onSpeed` hears of a speed chosen by Enter, in the unit
 * of the axis.
 */
export function startHover(chart, read, onSpeed) {
  const { host } = chart;
  const box = Object.assign(document.createElement("div"), { className: "readout", hidden: true });
  box.setAttribute("aria-hidden", "true");
  host.append(box);
  const said = at("chart-said");
  let place = null; // {point} of the pointer, or {branch, speed} of the keys, by its place
  let shown = null; // the point that is shown, or is to be as soon as its numbers are there

  /** Shows no point; gives null, as there are no lines of it. */
  function clear() {
    shown = null;
    box.hidden = true;
    chart.layers.hover.replaceChildren();
    return null;
  }

  /** Shows no point, and forgets what was meant. */
  function hide() {
    place = null;
    return clear();
  }

  /** Shows a point at once and its numbers as soon as they are there; resolves to the lines. */
  async function put(point) {
    const { frame } = chart;
    const { branch, dof, speed, x, y } = point;
    shown = point;
    chart.layers.hover.replaceChildren(element("circle", { cx: x, cy: y, r: 5.5, "data-dof": dof }));
    const readings = await read(frame.report, speed);
    const reading = readings?.find((reading) => reading.branch === branch);
    if (shown !== point || reading === undefined) return null;
    const lines = words(reading, speed, frame.speedUnit, frame.shown(speed));
    box.replaceChildren(...lines.map((text) => Object.assign(document.createElement("div"), { textContent: text })));
    box.dataset.dof = dof;
    // Beside the point, on the side that has room.
    box.classList.toggle("leftward", x > (frame.left + frame.right) / 2);
    box.classList.toggle("downward", y < frame.top + 0.3 * frame.plot.height);
    box.hidden = false;
    chart.put(box, x, y);
    return lines;
  }

  /**
   * Shows what is meant now.
   * @returns {Promise<string[] | null> | null} the lines once they are there; null where there is no point to show
   */
  function show() {
    const { frame } = chart;
    if (frame === null || place === null) return hide();
    if (place.point) {
      if (!frame.holds(place.point, 2)) return hide();
      const found = nearest(frame, place.point);
      const scale = host.clientWidth / frame.width;
      if (found === null || found.distance * scale > place.reach) return clear();
      return put(found);
    }
    const points = frame.points(place.speed);
    const point = points.find(({ branch }) => branch === place.branch);
    if (point === undefined) return hide();
    return put({ ...point, speed: place.speed });
  }

  const follow = (event) => {
    if (chart.frame === null) return;
    place = { point: chart.point(event), reach: REACH[event.pointerType] ?? REACH.mouse };
    show();
  };
  host.addEventListener("pointermove", follow);
  host.addEventListener("pointerdown", follow);
  host.addEventListener("pointerleave", (event) => {
    if (event.pointerType !== "touch" && place?.point) hide();
  });
  host.addEventListener("pointercancel", hide);
  addEventListener("pointerdown", ({ target }) => {
    if (!host.contains(target)) hide();
  });

  /** The keys begin at the middle of the chart, or where the pointer was. */
  function begin(frame) {
    const [from, to] = frame.speeds;
    const speed = place?.point ? frame.speed(place.point.x) : (place?.speed ?? (from + to) / 2);
    if (place?.branch !== undefined) return { branch: place.branch, speed: Math.min(to, Math.max(from, speed)) };
    const found = place?.point ? nearest(frame, place.point) : frame.points(speed)[0];
    return found ? { branch: found.branch, speed } : null;
  }

  /** From branch to branch by height, at the same speed. */
  function climb(frame, { branch, speed }, steps) {
    const points = frame.points(speed).sort((a, b) => b.y - a.y);
    const now = points.findIndex((point) => point.branch === branch);
    return points[Math.min(points.length - 1, Math.max(0, now + steps))]?.branch ?? branch;
  }

  host.addEventListener("keydown", (event) => {
    const { frame } = chart;
    if (event.target !== host || frame === null || event.ctrlKey || event.metaKey || event.altKey) return;
    const fresh = place === null || place.point !== undefined;
    if (event.key === "Escape") return hide();
    const along = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    const up = { ArrowUp: 1, ArrowDown: -1 }[event.key];
    const end = { Home: 0, End: 1 }[event.key];
    if (event.key === "Enter" && place?.branch !== undefined) return onSpeed(frame.shown(place.speed));
    if (along === undefined && up === undefined && end === undefined) return;
    event.preventDefault();
    place = begin(frame);
    if (place === null) return;
    const [from, to] = frame.speeds;
    if (!fresh || end !== undefined) {
      const step = ((event.shiftKey ? 10 : 1) * (to - from)) / STEPS;
      if (along) place.speed = Math.min(to, Math.max(from, place.speed + along * step));
      if (up) place.branch = climb(frame, place, up);
      if (end !== undefined) place.speed = [from, to][end];
    }
    const coming = show();
    if (coming === null) said.textContent = "The branch leaves the chart here.";
    else coming.then((lines) => lines && (said.textContent = lines.join(", ")));
  });
  host.addEventListener("blur", () => !place?.point && hide());
  chart.onShow(show);
}
