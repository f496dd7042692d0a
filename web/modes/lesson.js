// What the convergence chart shows for the chosen mode, in words.

import { at } from "../lib/dom.js";
import { boundsWords, figures, paperWords } from "../lib/format.js";
import { modeOf, nameOf } from "../lib/labels.js";

/** Piecewise functions closer than this to the converged frequency have converged. */
const CONVERGED = 1e-9;

const off = (value, converged) => paperWords({ classical_rad_s: value, converged_rad_s: converged });

/** The lesson of the series of a mode in a convergence report; `functions` is how many of the paper's are asked for. */
export function lessonWords(report, name, functions) {
  const series = report.series.find((series) => nameOf(series) === name);
  if (series === undefined || series.converged_rad_s === null) return "";
  const { label } = series;
  const { classical_rad_s: classical, converged_rad_s: converged, piecewise_functions: counts, piecewise_rad_s: piecewise } = series;
  const known = report.functions.filter((_, i) => classical[i] !== null);
  const sentences = [];
  const count = known.includes(functions) ? functions : known.at(-1);
  if (count !== undefined) {
    const value = classical[report.functions.indexOf(count)];
    sentences.push(`${label} with the paper’s ${count} functions: ${figures(value)} rad/s, ${off(value, converged)}.`);
    const few = known.filter((n) => n <= count / 2).at(-1);
    if (few !== undefined) sentences.push(`With ${few} of them: ${off(classical[report.functions.indexOf(few)], converged)}.`);
  }
  const first = piecewise.findIndex((value) => value !== null);
  const there = piecewise.findIndex((value) => value !== null && Math.abs(value - converged) <= CONVERGED * converged);
  if (first >= 0 && there > first)
    sentences.push(`Piecewise functions: ${off(piecewise[first], converged)} with ${counts[first]}, converged with ${counts[there]}:`);
  else sentences.push(`Piecewise functions: converged${there >= 0 ? ` with ${counts[there]}` : ""}:`);
  const bounds = boundsWords({ ...series, frequency_rad_s: converged });
  sentences.push(`${figures(converged)}${bounds === "–" ? "" : ` ${bounds}`} rad/s.`);
  return sentences.join(" ");
}

/** Shows it below the drawing from now on. */
export function startLesson(store) {
  const place = at("lesson");
  store.subscribe((state, changed) => {
    if (!["drawing", "chosen", "options", "tab"].some((key) => changed.has(key))) return;
    const shown = state.tab === "converge" && state.drawing?.kind === "converge";
    place.hidden = !shown;
    const mode = modeOf(state.modes?.modes ?? [], state.chosen);
    const name = mode === null ? state.chosen : nameOf(mode);
    if (shown) place.textContent = lessonWords(state.drawing.report, name, Number(state.options.functions ?? 15));
    if (shown && place.textContent === "") place.hidden = true;
  });
}
