// Keeps results in step with the state: what changed decides what is solved again.

/** Options of the package for this state, by analysis; the speed as the user gave it, nominal where not. */
export function optionsOf(analysis, { options, speed }) {
  const { modes, functions, harmonics } = options;
  const at = { modes, speed: speed === null ? null : `${speed.value}${speed.unit}` };
  if (analysis === "fan") return { modes, functions, harmonics };
  if (analysis === "converge") return at;
  return { ...at, functions };
}

/** Starts solving: every change of the state's inputs leads to new results in the state. */
export function startSolving(store, client) {
  const faultsOf = { fan: [], modes: [], draw: [] };

  /** Takes a result of one lane into the state; a superseded one (null) is dropped. */
  function take(lane, result, accept) {
    if (result === null) return;
    faultsOf[lane] = result.status === "ok" ? [] : result.faults;
    const all = Object.values(faultsOf).flat();
    const distinct = all.filter((fault, i) => all.findIndex((f) => f.path === fault.path && f.message === fault.message) === i);
    store.set({ solveFaults: distinct, ...(result.status === "ok" ? accept(result.value) : {}) });
  }

  async function parse(text) {
    const result = await client.call("parse", "parse_blade", text);
    if (result === null) return;
    if (result.status === "ok") store.set({ blade: result.value, faults: [], warnings: result.warnings });
    else store.set({ faults: result.faults, warnings: [] });
  }

  async function fan(state) {
    take("fan", await client.call("fan", "fan", state.blade, optionsOf("fan", state)), (value) => ({ fan: value }));
  }

  async function modes(state) {
    const { speed } = state;
    const options = optionsOf("modes", state);
    const [found, margins] = await Promise.all([
      client.call("modes", "modes", state.blade, options),
      client.call("margins", "margins", state.blade, options),
    ]);
    if (found === null || margins === null) return;
    take("modes", found.status === "ok" ? margins : found, (value) => ({
      modes: found.value,
      margins: value,
      solvedSpeed: speed,
    }));
  }

  async function draw(state) {
    const kind = state.tab;
    const name = state.blade.name;
    const { theme, width, speedUnit: speed_unit, frequencyUnit: frequency_unit } = state;
    const options = { ...optionsOf(kind, state), theme, width, speed_unit, frequency_unit };
    const result = await client.call("draw", "chart_svg", kind, state.blade, options);
    take("draw", result, (value) => ({ drawing: { kind, name, ...value } }));
  }

  /** The shapes of the chosen mode's degree of freedom, beside the table. */
  async function drawSide(state) {
    const { chosen, theme, sideWidth: width, speedUnit: speed_unit } = state;
    const { dof } = state.modes.modes.find((mode) => mode.label === chosen) ?? state.modes.modes[0];
    const options = { ...optionsOf("shapes", state), dof, theme, width, speed_unit };
    const name = `${dof} mode shapes of ${state.blade.name}`;
    const result = await client.call("side", "chart_svg", "shapes", state.blade, options);
    // Its faults are those of the modes.
    if (result?.status === "ok") store.set({ side: { name, ...result.value } });
  }

  store.subscribe((state, changed) => {
    const any = (...keys) => keys.some((key) => changed.has(key));
    if (any("text")) parse(state.text);
    if (state.blade === null || state.width === 0) return;
    const solves = any("blade", "options") || any("width") && state.fan === null;
    const looks = any("tab", "theme", "width", "speedUnit", "frequencyUnit");
    if (solves || looks || (state.tab !== "fan" && any("speed"))) draw(state);
    if (solves || any("speed")) modes(state);
    if (solves) fan(state);
    const beside = state.sideWidth > 0 && state.tab !== "shapes" && state.modes !== null;
    if (beside && any("modes", "chosen", "theme", "tab", "sideWidth", "speedUnit")) drawSide(state);
  });
}
