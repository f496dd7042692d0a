// Runs the solver: the small module of the wasm package; or the whole one, where the worker is called
// "whole", or by the folder of the package that it is to come from. The only file that imports them.

import { callChanged } from "./changed.js";

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

onmessage = async ({ data: { id, name, args } }) => {
  const bladefan = await loaded;
  if (bladefan === null) return;
  try {
    postMessage({ id, result: callChanged(bladefan, name, args) });
  } catch (error) {
    postMessage({ id, crashed: text(error) });
  }
};
