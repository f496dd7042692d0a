// What would move a mode that is near a harmonic: the blade solved again with a little more and a
// little less of what holds the mode, and a straight line through both.

import { at } from "../lib/dom.js";
import { percentWords } from "../lib/format.js";
import { motionsOf, nameOf } from "../lib/labels.js";
import { optionsOf } from "../solver/keep-up.js";
import { NEAR, nearModes } from "./nearness.js";

const NAMES = { flap: "Flap", lag: "Lag", torsion: "Torsion" };
/** The change that is solved, up and down. */
const SHARE = 0.01;
/** A change larger than this is no use, and too large for a straight line. */
const MOST_PERCENT = 50;
/** A mode that moves less than this per percent is hardly moved. */
const HARDLY = 1e-3;
/** So many modes are looked at, the nearest first. */
const MOST_MODES = 3;
const IDLE_MS = 300;

/** What holds a motion, the usual first: {name, what}, the latter its path in the blade file. */
function leversOf(blade, dof) {
  const name = NAMES[dof];
  const found = [{ name: `${name} stiffness`, what: `distribution.${dof}_stiffness` }];
  const { root, spring, offset, offset_ratio: ratio } = blade[dof] ?? {};
  if (spring > 0) found.push({ name: `${name} spring`, what: `${dof}.spring` });
  if (root !== "hingeless" && dof !== "torsion" && (offset > 0 || ratio > 0)) found.push({ name: `${name} hinge offset`, what: `${dof}.offset` });
  return found;
}

/** What holds a mode: what holds its leading motion, then, where it is mixed, the second one. */
const levers = (blade, { label }) => motionsOf(label).flatMap((motion) => leversOf(blade, motion));

/** The same mode of a blade that is a little different: by its name, or else the one next to it. */
export function sameMode(modes, mode) {
  const away = (other) => Math.abs(other.frequency_rad_s - mode.frequency_rad_s);
  const swinging = modes.filter((other) => other.per_rev !== null);
  return swinging.find((other) => nameOf(other) === nameOf(mode)) ?? swinging.sort((a, b) => away(a) - away(b))[0] ?? null;
}

/** How far per percent a mode moves, in 1/rev: `less` and `more` are [percent, per rev], or null where it could not be solved. */
export function slopeOf(now, less, more) {
  const [a, b] = [less ?? [0, now], more ?? [0, now]];
  return a[0] === b[0] ? null : (b[1] - a[1]) / (b[0] - a[0]);
}

/** The change in percent that brings the margin to `wanted`, away from the harmonic; null where it is no use. */
export function changeFor(margin, slope, wanted = NEAR) {
  const percent = ((margin < 0 ? -1 : 1) * wanted - margin) / slope;
  return Number.isFinite(percent) && Math.abs(percent) <= MOST_PERCENT ? percent : null;
}

const twoFigures = (value) => String(Number(Math.abs(value).toPrecision(2)));

/**
 * What moves a mode, in words, from what each lever does to it: "Flap stiffness +1 % moves 3F up by
 * about 0.011/rev; about +3.6 % brings the margin to 0.1/rev."
 */
export function moverWords({ label, margin_per_rev: margin }, pulls) {
  const idle = pulls.filter(({ slope }) => Math.abs(slope) < HARDLY).map(({ name }) => name);
  const sentences =
    idle.length === 0
      ? []
      : [`${idle.join(" and ").replace(/ and ./g, (start) => start.toLowerCase())} hardly ${idle.length === 1 ? "moves" : "move"} ${label}.`];
  for (const { name, slope } of pulls.filter(({ slope }) => Math.abs(slope) >= HARDLY)) {
    const change = changeFor(margin, slope);
    const moves = `${name} +1 % moves ${label} ${slope < 0 ? "down" : "up"} by about ${twoFigures(slope)}/rev`;
    sentences.push(change === null ? `${moves}.` : `${moves}; about ${percentWords(change)} brings the margin to ${NEAR}/rev.`);
  }
  return sentences.join(" ");
}

/** Shows it from now on, some time after the last change. */
export function startMovers(store, client) {
  const list = at("movers");
  let waiting;
  let current = null; // the report that is looked at
  let upTo; // the last harmonic that is looked at

  /** One lever on one mode; null where a newer question has come in. */
  async function pull(state, mode, { name, what }) {
    // Modes of a coupled blade are counted together.
    const { modes: all, model } = state.modes;
    const wanted = model.kind === "coupled" ? { modes: Math.min(all.length, all.indexOf(mode) + 2) } : { dof: [mode.dof], modes: mode.number };
    const options = { ...optionsOf("modes", { ...state, speed: state.solvedSpeed }), ...wanted };
    const ends = [];
    for (const share of [-SHARE, SHARE]) {
      const result = await client.call("sensitivity", "modes", { blade: state.blade, changes: [{ what, scale: 1 + share }] }, options);
      if (result === null || current !== state.modes) return null;
      const moved = result.status === "ok" ? sameMode(result.value.modes, mode) : null;
      ends.push(moved ? [100 * share, moved.per_rev] : null);
    }
    return { name, slope: slopeOf(mode.per_rev, ...ends) };
  }

  async function ask() {
    const state = store.get();
    const seen = state.modes.modes.filter(({ dof }) => state.dofs.includes(dof));
    const near = nearModes(seen, upTo ?? 0).slice(0, MOST_MODES);
    const said = [];
    for (const mode of near) {
      const pulls = [];
      for (const lever of levers(state.blade, mode)) {
        const pulled = await pull(state, mode, lever);
        if (pulled === null) return;
        if (pulled.slope === null) continue;
        pulls.push(pulled);
        if (changeFor(mode.margin_per_rev, pulled.slope) !== null) break; // the usual one will do
      }
      const natural =
        nameOf(mode) === "1F" && mode.nearest_harmonic === 1 && state.blade.flap.root === "hinged" ? " 1F of a hinged blade lies near 1P." : "";
      if (pulls.length > 0) said.push(Object.assign(document.createElement("li"), { textContent: moverWords(mode, pulls) + natural }));
    }
    list.replaceChildren(...said);
  }

  store.subscribe(({ modes, fan }, changed) => {
    if (!["modes", "fan", "dofs"].some((key) => changed.has(key)) || modes === null) return;
    if (modes === current && fan?.harmonics === upTo && !changed.has("dofs")) return;
    current = modes;
    upTo = fan?.harmonics;
    clearTimeout(waiting);
    list.replaceChildren(); // they were of other numbers
    waiting = setTimeout(ask, IDLE_MS);
  });
}
