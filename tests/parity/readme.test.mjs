// The example in the wasm package's README runs, and says what it is there to say.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import test from "node:test";
import { pkg } from "./both.mjs";

test("the example of the README runs", () => {
  const readme = readFileSync(new URL("../../crates/wasm/README.md", import.meta.url), "utf8");
  const [, code] = /```js\n([\s\S]*?)```/.exec(readme);
  const lines = [];
  const require = (name) => (assert.equal(name, "bladefan-wasm"), pkg);
  new Function("require", "console", code)(require, { log: (line) => lines.push(line) });
  assert.match(lines[0], /^1L \d+\.\d\d Hz\n1F /);
  assert.equal(lines[1], "scaled by 2 along with the mass");
});
