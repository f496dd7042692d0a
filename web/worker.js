// Runs the solver. The only file that imports the wasm package: the part that the first view and the
// sliders need at once, the whole when something else is asked for.

import init, * as first from "./pkg/bladefan_first.js";

const text = (error) => (error instanceof Error ? error.message : String(error));

const loaded = init().then(
  () => {
    postMessage({ ready: true });
    return true;
  },
  (error) => {
    postMessage({ failed: text(error) });
    return false;
  },
);

let whole = null;
async function load() {
  const module = await import("./pkg/bladefan_wasm.js");
  await module.default();
  return module;
}

/** Both give the same numbers; the first knows no other chart than the fan, and no measured points on it. */
function holder(name, args) {
  const [kind, , options] = args;
  if (name in first && (name !== "chart_svg" || (kind === "fan" && (options?.measured ?? null) === null))) return first;
  whole ??= load();
  whole.catch(() => (whole = null)); // it may come the next time
  return whole;
}

onmessage = async ({ data: { id, name, args } }) => {
  if (!(await loaded)) return;
  try {
    const bladefan = await holder(name, args);
    postMessage({ id, result: bladefan[name](...args) });
  } catch (error) {
    postMessage({ id, crashed: text(error) });
  }
};
