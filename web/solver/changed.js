// A blade given as {blade, changes} is changed first: what-if is solved in one call.

/** Calls an export of the wasm package. Where a blade was changed for it, the answer holds that `blade`, too. */
export function callChanged(bladefan, name, args) {
  const at = args.findIndex((arg) => arg?.blade !== undefined && arg.changes !== undefined);
  if (at < 0) return bladefan[name](...args);
  const changed = bladefan.change_blade(args[at].blade, args[at].changes);
  if (changed.status !== "ok") return changed;
  const { blade } = changed.value;
  return { ...bladefan[name](...args.with(at, blade)), blade };
}
