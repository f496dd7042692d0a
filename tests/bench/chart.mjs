// Times of one fan chart and of one speed (TM 4760, from the parsed blade) in the package for Node,
// beside the native ones:
//
//     scripts/wasm-package && node tests/bench/chart.mjs
//
// The native times are measured in the same run, by `cargo bench -p bladefan-core -- --chart-time`.
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { fileURLToPath } from "node:url";

const root = fileURLToPath(new URL("../..", import.meta.url));
const bladefan = createRequire(import.meta.url)(`${root}/crates/wasm/pkg-node/bladefan_wasm.js`);

/** The value of a reply, or an end with its faults. */
function value(reply) {
  if (reply.status !== "ok") throw new Error(JSON.stringify(reply.faults));
  return reply.value;
}

/** Least time of `runs` runs [ms]: the one that other work on the machine disturbed least. */
function best(runs, run) {
  let least = Infinity;
  for (let i = 0; i < runs; i++) {
    const start = performance.now();
    run();
    least = Math.min(least, performance.now() - start);
  }
  return least;
}

const text = readFileSync(`${root}/crates/core/src/library/blades/tm4760.toml`, "utf8");
const blade = value(bladefan.parse_blade(text, "toml"));
const chart = value(bladefan.fan(blade, { modes: 5 }));
if (chart.branches.length !== 15 || chart.speeds_rad_s.length !== 101) throw new Error("not the chart meant");

const bench = ["bench", "--quiet", "-p", "bladefan-core", "--bench", "speed", "--", "--chart-time"];
const native = execFileSync("cargo", bench, { cwd: root, encoding: "utf8" }).trim().split("\n").map(Number);
const work = [
  ["converged fan chart, 3 x 5 modes, 101 speeds", () => bladefan.fan(blade, { modes: 5 })],
  ["the same with 15 classical functions", () => bladefan.fan(blade, { modes: 5, basis: "classical" })],
  ["one speed with bounds", () => bladefan.modes(blade, { modes: 5 })],
];
work.forEach(([name, run], index) => {
  // The engine first interprets, then compiles: measured after it has seen the code.
  best(50, run);
  const inNode = best(151, run);
  console.log(`${name}: native ${native[index].toFixed(2)} ms, Node ${inNode.toFixed(2)} ms, ratio ${(inNode / native[index]).toFixed(2)}`);
});
