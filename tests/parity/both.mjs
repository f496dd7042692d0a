// The two ways to the same solver: the command line and the wasm package in Node.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { existsSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { fileURLToPath } from "node:url";

const root = new URL("../../", import.meta.url);
const here = (path) => fileURLToPath(new URL(path, root));

const binary = process.env.BLADEFAN ?? ["target/release/bladefan", "target/debug/bladefan"].map(here).find(existsSync);
assert.ok(binary, "no bladefan to compare with: cargo build -p bladefan, or name one in BLADEFAN");
const folder = process.env.BLADEFAN_PKG ?? here("crates/wasm/pkg-node");
assert.ok(existsSync(folder), "no wasm package to compare with: scripts/wasm-package, or name one in BLADEFAN_PKG");

/** The wasm package. */
export const pkg = createRequire(import.meta.url)(`${folder}/bladefan_wasm.js`);

/** Runs the command line; gives its exit code and both streams. */
export function run(...args) {
  const { status, stdout, stderr, error } = spawnSync(binary, args, { encoding: "utf8", maxBuffer: 1 << 28, env: { NO_COLOR: "1" } });
  if (error) throw error;
  return { status, stdout, stderr };
}

/** The JSON result of a command. */
export function json(...args) {
  const { status, stdout, stderr } = run(...args, "--format", "json");
  assert.equal(status, 0, `bladefan ${args.join(" ")}: ${stderr}`);
  return JSON.parse(stdout);
}

/** The value of an answer of the package. */
export function value(answer) {
  assert.equal(answer.status, "ok", JSON.stringify(answer.faults));
  return answer.value;
}

/** Every built-in blade as the package reads it, with the name that the command line knows. */
export const blades = value(pkg.built_in_blades()).map(({ name, toml }) => ({ name, toml, blade: value(pkg.parse_blade(toml, "toml")) }));

/**
 * Fails unless both are the same: keys and their order, texts, and every number the same f64
 * (-0 is not 0, NaN is NaN). Returns how many numbers were compared.
 */
export function same(a, b, path = "") {
  if (a === null || b === null || typeof a !== "object" || typeof b !== "object") {
    assert.ok(Object.is(a, b), `${path}: ${a} is not ${b}`);
    return typeof a === "number" ? 1 : 0;
  }
  assert.equal(Array.isArray(a), Array.isArray(b), path);
  assert.deepEqual(Object.keys(a), Object.keys(b), path);
  return Object.keys(a).reduce((count, key) => count + same(a[key], b[key], `${path}.${key}`), 0);
}

/** A file of this repository as text. */
export const text = (path) => readFileSync(here(path), "utf8");
