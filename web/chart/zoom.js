// A part of the fan chart made large: by a box, wheel, two fingers, buttons and keys.

import { at, element } from "../lib/dom.js";
import { frequencyFactor, inUnit } from "./frame.js";

/** So many rotor speeds are solved in a window. */
const COUNT = 101;
const STEP = 1.5;
/** Smallest window, as a share of the whole chart. */
const SMALLEST = 1e-3;
/** A box smaller than this [px] is a slip. */
const SLIP = 6;
/** Two clicks within this time [ms] are one double click. */
const DOUBLE = 500;

/** A window in another unit of frequency; those per revolution do not convert. */
export function windowIn(window, from, to) {
  if (window === null || from === to) return window;
  const factors = [frequencyFactor(from), frequencyFactor(to)];
  const { speeds, frequencies } = window;
  if (!frequencies || factors.includes(null)) return { speeds };
  return { speeds, frequencies: frequencies.map((value) => (value * factors[0]) / factors[1]) };
}

/** A range made `factor` times smaller around a point that keeps its place, within limits. */
export function scaledRange([from, to], centre, factor, [least, most], smallest) {
  const length = Math.min(most - least, Math.max(smallest, (to - from) / factor));
  const share = to > from ? (centre - from) / (to - from) : 0.5;
  const start = Math.min(most - length, Math.max(least, centre - share * length));
  return [start, start + length];
}

/** Makes all ways to zoom; they set `window` of the state. */
export function startZoom(chart, store) {
  const { host } = chart;
  const buttons = { out: at("zoom-out"), in: at("zoom-in"), box: at("zoom-box"), reset: at("zoom-reset") };
  let whole = null; // both axes of the chart as it is without a window
  let boxing = false;
  const fingers = new Map();
  let pinch = null;
  let lastPress = { time: -Infinity, speed: null };

  /** What is asked for, be it drawn yet or not. */
  function now() {
    const { window } = store.get();
    const { frame } = chart;
    return { speeds: window?.speeds.slice(0, 2) ?? frame.speeds, frequencies: window?.frequencies ?? [frame.plot.y.from, frame.plot.y.to] };
  }

  /** Out to twice the chart's speeds and to the highest branch. */
  function limits() {
    const { frame } = chart;
    const { branches, speeds_rad_s: speeds } = frame.report;
    let top = whole.frequencies[1];
    for (const branch of branches) {
      const highest = inUnit(branch.frequency_rad_s.at(-1), speeds.at(-1), frame.unit);
      if (highest * 1.05 > top) top = highest * 1.05;
    }
    return { speeds: [0, 2 * whole.speeds[1]], frequencies: [0, top] };
  }

  function set(speeds, frequencies) {
    const same = (a, b) => Math.abs(a[0] - b[0]) + Math.abs(a[1] - b[1]) < 1e-6 * b[1];
    if (same(speeds, whole.speeds) && same(frequencies, whole.frequencies)) store.set({ window: null });
    else store.set({ window: { speeds: [...speeds, COUNT], frequencies } });
  }

  /** Makes what is shown `factor` times larger around a point of the drawing. */
  function zoom(factor, point = middle()) {
    if (chart.frame === null || whole === null) return;
    const { speeds, frequencies } = now();
    const { left, top, plot } = chart.frame;
    const across = Math.min(1, Math.max(0, (point.x - left) / plot.width));
    const up = Math.min(1, Math.max(0, 1 - (point.y - top) / plot.height));
    const most = limits();
    const make = (range, share, name) => scaledRange(range, range[0] + share * (range[1] - range[0]), factor, most[name], SMALLEST * whole[name][1]);
    set(make(speeds, across, "speeds"), make(frequencies, up, "frequencies"));
  }

  const middle = () => ({ x: (chart.frame.left + chart.frame.right) / 2, y: (chart.frame.top + chart.frame.bottom) / 2 });
  const reset = () => store.set({ window: null });

  function toggleBox(on) {
    boxing = on;
    buttons.box.setAttribute("aria-pressed", String(on));
    host.classList.toggle("boxing", on);
    if (!on) chart.layers.box.replaceChildren();
  }

  function box(start) {
    const clamp = ({ x, y }) => ({
      x: Math.min(chart.frame.right, Math.max(chart.frame.left, x)),
      y: Math.min(chart.frame.bottom, Math.max(chart.frame.top, y)),
    });
    const corner = clamp(start);
    const ends = (to) => ({ x: [corner.x, to.x].sort((a, b) => a - b), y: [corner.y, to.y].sort((a, b) => a - b) });
    return {
      move(to) {
        const { x, y } = ends(clamp(to));
        chart.layers.box.replaceChildren(element("rect", { x: x[0], y: y[0], width: x[1] - x[0], height: y[1] - y[0] }));
      },
      end(to) {
        const { x, y } = ends(clamp(to));
        toggleBox(false);
        if (x[1] - x[0] < SLIP || y[1] - y[0] < SLIP) return;
        const { frame } = chart;
        set(
          x.map((value) => frame.speed(value)),
          [frame.value(y[1]), frame.value(y[0])],
        );
      },
      cancel: () => toggleBox(false),
    };
  }

  /** Two fingers: both keep what is below them. */
  function pinched() {
    const [a, b] = [...fingers.values()];
    const apart = Math.max(20, Math.hypot(a.x - b.x, a.y - b.y));
    const centre = { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 };
    if (pinch !== null) zoom(apart / pinch, centre);
    pinch = apart;
  }

  chart.onPress((point, event) => {
    if (event.pointerType === "touch") {
      fingers.set(event.pointerId, point);
      if (fingers.size === 2) {
        pinch = null;
        pinched();
        return {};
      }
    } else if (event.pointerType !== "mouse" && event.timeStamp - lastPress.time > DOUBLE) {
      lastPress = { time: event.timeStamp, speed: store.get().speed };
    }
    return (boxing || event.shiftKey) && chart.frame.holds(point, 12) ? box(point) : null;
  });
  // The browser counts the presses of a mouse, however long the page takes between them.
  host.addEventListener("mousedown", (event) => {
    if (event.detail === 1) lastPress = { time: event.timeStamp, speed: store.get().speed };
  });
  host.addEventListener("pointermove", (event) => {
    if (!fingers.has(event.pointerId) || chart.frame === null) return;
    fingers.set(event.pointerId, chart.point(event));
    if (fingers.size === 2) pinched();
  });
  for (const type of /** @type {const} */ (["pointerup", "pointercancel"])) {
    addEventListener(type, (event) => {
      fingers.delete(event.pointerId);
      pinch = null;
    });
  }
  host.addEventListener(
    "wheel",
    (event) => {
      if (!event.ctrlKey || chart.frame === null) return;
      event.preventDefault();
      const lines = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 16 : 1;
      zoom(Math.exp(-Math.max(-120, Math.min(120, event.deltaY * lines)) / 300), chart.point(event));
    },
    { passive: false },
  );
  host.addEventListener("dblclick", (event) => {
    if (chart.frame === null || event.target.closest(".handle") || !chart.frame.holds(chart.point(event))) return;
    store.set({ window: null, speed: lastPress.speed }); // the clicks chose a speed on their way
  });
  host.addEventListener("keydown", (event) => {
    if (chart.frame === null || event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key === "+" || event.key === "=") zoom(STEP);
    else if (event.key === "-") zoom(1 / STEP);
    else if (event.key === "0") reset();
    else if (event.key === "Escape" && boxing) toggleBox(false);
  });
  buttons.in.addEventListener("click", () => zoom(STEP));
  buttons.out.addEventListener("click", () => zoom(1 / STEP));
  buttons.box.addEventListener("click", () => toggleBox(!boxing));
  buttons.reset.addEventListener("click", reset);

  chart.onShow((frame) => {
    if (frame === null) return toggleBox(false);
    const axis = [frame.plot.y.from, frame.plot.y.to];
    if (store.get().window === null) whole = { speeds: frame.speeds, frequencies: axis, unit: frame.unit };
    else if (whole?.unit !== frame.unit) {
      // Opened as a window, or in another unit: the whole is as large as what is known of it.
      const to = Math.max(frame.speeds[1], 1.2 * frame.report.nominal.speed_rad_s);
      whole = { speeds: whole?.speeds ?? [0, to], frequencies: [0, axis[1]], unit: frame.unit };
    }
  });
  store.subscribe((state, changed) => {
    if (changed.has("window")) buttons.reset.disabled = state.window === null;
  });
}
