// The page's state, in one place. Modules read it, change it through `set`, and hear of changes. What it
// hands out is frozen, with all that lies in it: a change goes through `set`, or throws.

import { NEUTRAL } from "../lib/what-if.js";

/** The choice of the first visit. */
export const FIRST_BLADE = "tm4760";

/** Every key of the state, as it is before anything was opened; there are no others. */
export const STATE = {
  // Where a blade comes from.
  about: null, // version, model line, units
  library: [], // built-in blades
  choice: FIRST_BLADE, // the name of a built-in blade, or OWN

  // The blade under edit.
  doc: null, // as it stands in the fields, in its own units; may have faults
  text: null, // its file, until a field is changed
  good: null, // `doc` as it was last solved, without faults
  draft: null, // a text that was typed or opened and is no blade, beside the one that is
  textFaults: [], // of that text
  opened: 0, // how many blades were opened
  keptAs: null, // the name of its place among the kept blades
  canUndo: false,
  canRedo: false,
  whatIf: NEUTRAL, // changes for a look, beside the blade

  // What is asked for.
  model: "auto", // auto, uncoupled or coupled
  options: {}, // of the solution: modes, functions, harmonics, basis, as the fields hold them; the rest as the package has it
  speed: null, // {value, unit}; null is nominal
  band: [0.9, 1.1], // operating band, as ratios of nominal speed
  window: null, // {speeds: [from, to, count] rad/s, frequencies: [from, to] in the axis's unit} when zoomed
  measured: "", // CSV
  dofs: ["flap", "lag", "torsion"], // shown in the fan chart
  closeDofs: ["flap"], // shown in mode shapes and convergence

  // How it is looked at.
  tab: "fan", // fan, shapes, converge, stations or text
  chosen: "1F", // the mode whose shape is shown beside the table
  speedUnit: "rpm",
  frequencyUnit: "rad/s",
  theme: "light",
  width: 0, // of the chart
  height: null, // of the fan chart where it shares its place, else null

  // What was solved.
  blade: null, // what was last solved: without faults, with what-if
  faults: [], // of the blade, with paths
  solveFaults: [], // of options
  trouble: null, // why nothing can be solved for now, in words
  warnings: [],
  fan: null, // report of the fan chart
  before: null, // fan chart without what-if, while there is some
  modes: null, // report of the modes
  solvedSpeed: null, // the `speed` that they stand for
  drawing: null, // {kind, name, svg, report, …} of the chart that is shown
};

/** Freezes a value and all that lies in it, once. Bytes cannot be frozen. */
function freeze(value) {
  if (typeof value !== "object" || value === null || ArrayBuffer.isView(value) || Object.isFrozen(value)) return value;
  Object.freeze(value);
  // A list of numbers has nothing in it to freeze.
  for (const inner of Array.isArray(value) ? value : Object.values(value)) freeze(inner);
  return value;
}

/** A store of these keys and no others. */
export function createStore(initial = STATE) {
  let state = freeze({ ...initial });
  const listeners = new Set();
  return {
    /** The state as it is now; a later change makes another one. */
    get: () => state,
    /** Merges `changes` and tells every listener which keys really changed. */
    set(changes) {
      const changed = new Set();
      for (const [key, value] of Object.entries(changes)) {
        if (!Object.hasOwn(initial, key)) throw new Error(`the state has no key “${key}”`);
        if (!Object.is(state[key], value)) changed.add(key);
      }
      if (changed.size === 0) return;
      state = freeze({ ...state, ...changes });
      // A listener that sets more makes a newer state, which the next ones are told of.
      for (const listener of listeners) listener(state, changed);
    },
    /** `listener(state, changed)` hears of every change, until the function that this gives is called. */
    subscribe(listener) {
      listeners.add(listener);
      return () => listeners.delete(listener);
    },
  };
}
