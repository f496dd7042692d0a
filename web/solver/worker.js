// Runs the solver: the wasm package, whose compiled module the page sends first. The only file that
// imports its functions.

import * as bladefan from "../pkg/bladefan_wasm.js";

import { callChanged } from "./changed.js";

const text = (error) => (error instanceof Error ? error.message : String(error));

onmessage = ({ data: { module, id, name, args } }) => {
  if (module !== undefined) {
    try {
      bladefan.initSync({ module });
      postMessage({ ready: true });
    } catch (error) {
      postMessage({ failed: text(error) });
    }
    return;
  }
  try {
    postMessage({ id, result: callChanged(bladefan, name, args) });
  } catch (error) {
    postMessage({ id, crashed: text(error) });
  }
};
