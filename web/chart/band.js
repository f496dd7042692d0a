// The operating band: two edges that are moved on the chart, and the crossings between them in words.

import { at, element } from "../lib/dom.js";
import { crossingWords, crossingsWithin, fieldNumber } from "../lib/format.js";

/** Edges are set in steps of this ratio of nominal speed, and keep this far apart. */
const STEP = 0.01;
/** Farther than the chart nobody looks. */
const FARTHEST = 3;
/** So many crossings are told one by one. */
const MOST = 24;

const rounded = (ratio) => Number((Math.round(ratio / STEP) * STEP).toFixed(4));

/** Makes the edges; they set `band` of the state. */
export function startBand(chart, store) {
  const note = at("band-note");
  const edges = ["from", "to"].map((name, i) => {
    const label = i === 0 ? "Lower end of the operating band" : "Upper end of the operating band";
    const handle = chart.handle(`band-handle ${name}`, label, {
      drag: ({ x }) => set(i, chart.frame.speed(x) / chart.frame.report.nominal.speed_rad_s),
      step: (steps) => set(i, store.get().band[i] + steps * STEP),
      end: (first) => set(i, first ? limits(i)[0] : Math.min(limits(i)[1], chart.frame.speeds[1] / chart.frame.report.nominal.speed_rad_s)),
    });
    const value = Object.assign(document.createElement("span"), { className: "value" });
    value.setAttribute("aria-hidden", "true");
    handle.append(value);
    return { handle, value };
  });

  function limits(i) {
    const { band } = store.get();
    return i === 0 ? [0, rounded(band[1] - STEP)] : [rounded(band[0] + STEP), FARTHEST];
  }

  function set(i, ratio) {
    const [least, most] = limits(i);
    const band = [...store.get().band];
    band[i] = Math.min(most, Math.max(least, rounded(ratio)));
    if (band[i] !== store.get().band[i]) store.set({ band });
  }

  function showEdges({ band }) {
    const { frame } = chart;
    const nominal = frame?.report.nominal.speed_rad_s;
    const lines = edges.map(({ handle, value }, i) => {
      const x = nominal > 0 ? frame.x(band[i] * nominal) : NaN;
      const seen = x >= frame?.left - 0.5 && x <= frame?.right + 0.5;
      handle.hidden = !seen;
      if (!seen) return null;
      const words = `${fieldNumber(band[i])} of nominal, ${fieldNumber(frame.shown(band[i] * nominal), 4)} ${frame.speedUnit}`;
      value.textContent = words;
      value.classList.toggle("leftward", x > (frame.left + frame.right) / 2);
      const [from, to] = limits(i);
      chart.put(handle, x, frame.top);
      chart.value(handle, { from, to, now: band[i], words });
      return element("path", { d: `M${x} ${frame.top}V${frame.bottom}` });
    });
    chart.layers.edges.replaceChildren(...lines.filter((line) => line !== null));
  }

  function showWords({ band, window }) {
    const { frame } = chart;
    note.hidden = frame === null;
    if (frame === null || !(frame.report.nominal.speed_rad_s > 0)) return;
    const { report, speedUnit } = frame;
    const shown = (speed) => frame.shown(speed);
    const ends = band.map((ratio) => fieldNumber(shown(ratio * report.nominal.speed_rad_s), 4));
    const [first, last] = [report.speeds_rad_s[0], report.speeds_rad_s.at(-1)];
    const cut = window !== null && (band[0] * report.nominal.speed_rad_s < first || band[1] * report.nominal.speed_rad_s > last);
    const all = crossingsWithin(report, band).map(
      (crossing) => `${crossingWords(crossing)} at ${fieldNumber(shown(crossing.speed_rad_s), 4)} ${speedUnit}`,
    );
    const along = report.coincident.map(({ label, harmonic }) => `${label} lies on ${harmonic}P at every speed`);
    const told = [...along, ...all.slice(0, MOST), ...(all.length > MOST ? [`${all.length - MOST} more`] : [])];
    const text = `Band of ${ends[0]} to ${ends[1]} ${speedUnit}${cut ? ", as far as it is in view" : ""}: ${told.length === 0 ? `no crossing up to ${report.harmonics}P` : told.join("; ")}.`;
    if (note.textContent !== text) note.textContent = text;
  }

  const show = () => {
    showEdges(store.get());
    showWords(store.get());
  };
  chart.onShow(show);
  store.subscribe((state, changed) => changed.has("band") && chart.frame !== null && showEdges(state));
}
