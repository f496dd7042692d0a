// Keeps results in step with the state: what changed decides what is solved again.

import { changesOf, isNeutral } from "../lib/what-if.js";

/** Keys of the blade file: a fault whose path starts with one is the blade's, others are options'. */
const BLADE_KEYS = /^(schema|name|notes|source|units|rotor|flap|lag|torsion|distribution|point_mass)\b/;

const NONE = [];
/** The old list where the new one says the same, so that nobody hears of a change where there is none. */
const sameOr = (old, fresh) => (JSON.stringify(old) === JSON.stringify(fresh) ? old : fresh);

/** What the tab draws: the fan chart stays in sight beside the tables and texts of the blade. */
export const kindOf = (tab) => (tab === "shapes" || tab === "converge" ? tab : "fan");

/** Whether the chart shares its place with a table or text of the blade. */
export const isShared = (tab) => kindOf(tab) === "fan" && tab !== "fan";

/** Options of the package for this state, by analysis; the speed as the user gave it, nominal where not. */
export function optionsOf(analysis, { model, options, speed, band, window }) {
  const { modes, functions, harmonics, basis } = options;
  const at = { model, modes, speed: speed === null ? null : `${speed.value}${speed.unit}` };
  if (analysis === "fan") return { model, modes, functions, harmonics, basis, band, speeds: window?.speeds };
  if (analysis === "converge") return at;
  return { ...at, functions, basis };
}

/** The degrees of freedom of these that a blade has: without torsion data flap and lag alone. */
function dofsOf(doc, dofs) {
  const bends = doc?.torsion === undefined && doc?.distribution?.torsion_stiffness === undefined;
  const found = bends ? dofs.filter((dof) => dof !== "torsion") : dofs;
  return found.length > 0 ? found : dofs;
}

/** Options of a drawing for this state. */
export function looksOf(kind, state) {
  const { doc, theme, width, height, speedUnit: speed_unit, frequencyUnit: frequency_unit, dofs, closeDofs, measured, window } = state;
  const looks = { ...optionsOf(kind, state), theme, width, speed_unit, frequency_unit };
  if (kind !== "fan") return { ...looks, dof: dofsOf(doc, closeDofs) };
  return { ...looks, height, dof: dofsOf(doc, dofs), measured: measured || null, frequencies: window?.frequencies };
}

/** A result that came late is of use while it is of this blade and of what is looked at now. */
const isOf = (state, now) => state.opened === now.opened && kindOf(state.tab) === kindOf(now.tab);

/** Starts solving: every change of the state's inputs leads to new results in the state. */
export function startKeepingUp(store, client) {
  const faultsOf = { modes: [], draw: [] };

  // What is solved: `given` to the package as it takes it, and `blade`, the changed one, once that has made it.
  // The same as long as the blade and its changes are, so that `blade` of the state is, too.
  let asked = { doc: null };
  function solvedOf({ doc, whatIf }) {
    if (asked.doc !== doc || asked.whatIf !== whatIf) {
      const plain = isNeutral(whatIf);
      asked = { doc, whatIf, given: plain ? doc : { blade: doc, changes: changesOf(whatIf) }, blade: plain ? doc : null };
    }
    return asked;
  }

  /** Takes a result of one lane into the state; a superseded one (null) is dropped. */
  function take(lane, solved, result, accept) {
    if (result === null) return;
    faultsOf[lane] = result.status === "ok" ? [] : result.faults;
    const all = Object.values(faultsOf).flat();
    const distinct = all.filter((fault, i) => all.findIndex((f) => f.path === fault.path && f.message === fault.message) === i);
    const only = (good) => (distinct.length === 0 ? NONE : distinct.filter(good));
    const faults = only((fault) => BLADE_KEYS.test(fault.path));
    const solveFaults = only((fault) => !BLADE_KEYS.test(fault.path));
    solved.blade ??= result.blade ?? null;
    store.set({
      faults,
      solveFaults,
      ...(result.status === "ok" ? { blade: solved.blade, warnings: sameOr(store.get().warnings, result.warnings), ...accept(result.value) } : {}),
    });
  }

  async function modes(state, solved) {
    const { opened, speed } = state;
    const result = await client.call("modes", "modes", solved.given, optionsOf("modes", state));
    if (opened === store.get().opened) take("modes", solved, result, (value) => ({ modes: value, solvedSpeed: speed }));
  }

  // The frequency axis stays while what-if moves the branches: else it is the axis that seems to move.
  let held = { axis: null };

  async function draw(state, solved) {
    const kind = kindOf(state.tab);
    const ours = held;
    const isWhole = kind === "fan" && state.window === null;
    const looks = { ...looksOf(kind, state), ...(isWhole ? { frequencies: held.axis } : {}) };
    const result = await client.call("draw", "chart_svg", kind, solved.given, looks);
    if (isWhole && result?.status === "ok") {
      const { from, to } = result.value.plots[0].y;
      ours.axis ??= [from, to];
    }
    if (isOf(state, store.get()))
      take("draw", solved, result, ({ report, ...drawing }) => ({
        drawing: { kind, name: report.blade, ...drawing, report },
        ...(kind === "fan" ? { fan: report } : {}),
      }));
  }

  /**
   * A fan chart's numbers alone, into the key of the state that is also its lane: `fan` while another
   * chart is drawn, whose speeds and harmonics the page needs; `before` of the blade without what-if.
   */
  async function numbers(key, state, blade) {
    const result = await client.call(key, "fan", blade, { ...optionsOf("fan", state), dof: dofsOf(state.doc, state.dofs) });
    const wanted = key === "fan" || !isNeutral(store.get().whatIf);
    if (result?.status === "ok" && state.doc === store.get().doc && wanted) store.set({ [key]: result.value });
  }

  store.subscribe((state, changed) => {
    const any = (...keys) => keys.some((key) => changed.has(key));
    if (state.doc === null || state.width === 0) return;
    const solves = any("doc", "whatIf", "model", "options") || (any("width") && state.drawing === null);
    const kind = kindOf(state.tab);
    const looks = any("theme", "width", "height", "speedUnit", "frequencyUnit") || (any("tab") && kind !== state.drawing?.kind);
    const chart = kind === "fan" ? any("dofs", "band", "measured", "window") : any("speed", "closeDofs");
    if (any("doc", "model", "options", "frequencyUnit", "dofs", "measured", "window") || (any("whatIf") && isNeutral(state.whatIf)))
      held = { axis: null };
    if (solves || looks || chart || any("speed")) {
      const solved = solvedOf(state);
      if (solves || looks || chart) draw(state, solved);
      if (solves && kind !== "fan") numbers("fan", state, solved.given);
      if (solves || any("speed")) modes(state, solved);
    }
    if (isNeutral(state.whatIf)) {
      if (state.before !== null) store.set({ before: null });
    } else if (any("doc", "whatIf", "model", "options", "window", "dofs") && (state.before === null || !any("whatIf"))) {
      numbers("before", state, state.doc);
    }
  });
}
