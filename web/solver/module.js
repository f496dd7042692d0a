// The wasm module: fetched and compiled once, for every worker.

/** A connection that needs longer than this has most likely stopped. */
const ARRIVAL_MS = 30_000;

const address = new URL("../pkg/bladefan_wasm_bg.wasm", import.meta.url);

/** What is waited for, or a refusal in words for the user where it does not come in time. */
export function inTime(coming, ms = ARRIVAL_MS) {
  let timer;
  const late = new Promise((_, refuse) => {
    timer = setTimeout(() => refuse(new Error(`it has not arrived within ${ms / 1000} seconds`)), ms);
  });
  return Promise.race([coming, late]).finally(() => clearTimeout(timer));
}

async function compiled(signal) {
  const response = await fetch(address, { signal });
  if (!response.ok) throw new Error(`the server answered ${response.status}`);
  // A server that does not know the type may still have the file.
  const known = response.headers.get("Content-Type")?.startsWith("application/wasm");
  return known ? WebAssembly.compileStreaming(response) : WebAssembly.compile(await response.arrayBuffer());
}

let asked = null;

/** The compiled module. Where it did not come, the next one who wants it asks again. */
export function compiledModule() {
  if (asked === null) {
    const fetching = new AbortController();
    asked = inTime(compiled(fetching.signal)).catch((error) => {
      asked = null;
      fetching.abort();
      throw error;
    });
  }
  return asked;
}
