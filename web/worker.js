// Runs the solver. The only file that imports the wasm package.

import init, * as bladefan from "./pkg/bladefan_wasm.js";

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

onmessage = async ({ data: { id, name, args } }) => {
  if (!(await loaded)) return;
  try {
    postMessage({ id, result: bladefan[name](...args) });
  } catch (error) {
    postMessage({ id, crashed: text(error) });
  }
};
