// Runs the solver: the small module of the wasm package; or the whole one, where the worker is called
// "whole", or by the folder of the package that it is to come from. The only file that imports them.

const text = (error) => (error instanceof Error ? error.message : String(error));

const entry = { "": "../pkg/bladefan_first.js", whole: "../pkg/bladefan_wasm.js" }[self.name] ?? `../pkg/${self.name}/bladefan_wasm.js`;
const loaded = import(entry)
  .then(async (bladefan) => {
    await bladefan.default();
    postMessage({ ready: true });
    return bladefan;
  })
  .catch((error) => {
    postMessage({ failed: text(error) });
    return null;
  });

/**
 * A blade given as {blade, changes} is changed first: what-if is solved in one call, and its answer holds
 * the changed `blade`, too.
 */
function call(bladefan, name, args) {
  const at = args.findIndex((arg) => arg?.blade !== undefined && arg.changes !== undefined);
  if (at < 0) return bladefan[name](...args);
  const changed = bladefan.change_blade(args[at].blade, args[at].changes);
  if (changed.status !== "ok") return changed;
  const { blade } = changed.value;
  return { ...bladefan[name](...args.with(at, blade)), blade };
}

onmessage = async ({ data: { id, name, args } }) => {
  const bladefan = await loaded;
  if (bladefan === null) return;
  try {
    postMessage({ id, result: call(bladefan, name, args) });
  } catch (error) {
    postMessage({ id, crashed: text(error) });
  }
};
