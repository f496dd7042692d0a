// Runs two builds side by side; scripts/compare-builds says how.

import { execFile } from "node:child_process";
import { mkdtempSync, readdirSync, readFileSync, realpathSync, rmSync, writeFileSync } from "node:fs";
import { availableParallelism, tmpdir } from "node:os";
import { basename, join } from "node:path";
import { parseArgs } from "node:util";
import { differences } from "./differ.mjs";
import { MEASURED, otherRuns, runsOf } from "./runs.mjs";

const SHOWN = 5;

const { positionals, values: options } = parseArgs({
  allowPositionals: true,
  options: {
    blades: { type: "string" },
    "allow-ulp": { type: "string", default: "0" },
    ignore: { type: "string", default: "" },
    only: { type: "string" },
    all: { type: "boolean", default: false },
    seconds: { type: "string", default: "60" },
  },
});
if (positionals.length !== 2) {
  console.error("usage: scripts/compare-builds OLD NEW [options]; --help lists them");
  process.exit(2);
}
const binaries = positionals.map((path) => realpathSync(path));
const tolerance = { allowed: Number(options["allow-ulp"]), ignore: options.ignore.split(",") };
const only = options.only?.split(",");

const work = mkdtempSync(join(tmpdir(), "compare-builds-"));
process.on("exit", () => rmSync(work, { recursive: true, force: true }));
const measured = join(work, "measured.csv");
writeFileSync(measured, MEASURED);

/** Everything that one run leaves: exit code, both streams, files. */
function outcome(binary, { args, files }) {
  const cwd = mkdtempSync(join(work, "run-"));
  const limits = { cwd, encoding: "utf8", maxBuffer: 1 << 28, timeout: 1000 * Number(options.seconds), env: { NO_COLOR: "1" } };
  return new Promise((resolve) => {
    execFile(binary, args, limits, (error, stdout, stderr) => {
      const end = error ? (error.killed ? "stopped: too long" : `exit code ${error.code ?? error.signal}`) : "exit code 0";
      const made = files.map((file) => {
        try {
          return readFileSync(join(cwd, file), file.endsWith(".png") ? "base64" : "utf8");
        } catch {
          return "no file";
        }
      });
      rmSync(cwd, { recursive: true, force: true });
      resolve({ end, stdout, stderr, made });
    });
  });
}

/** The differences of a run, each with the output it stands in. */
async function compare(run) {
  const [old, now] = [await outcome(binaries[0], run), await outcome(binaries[1], run)];
  const kind = ["json", "csv"].find((format) => run.args.includes(format)) ?? "text";
  const outputs = [
    ["end", "text", old.end, now.end],
    ["standard output", kind, old.stdout, now.stdout],
    ["standard error", "text", old.stderr, now.stderr],
    ...run.files.map((file, i) => [file, "text", old.made[i], now.made[i]]),
  ];
  const found = outputs.map(([output, kind, a, b]) => ({ output, kind, same: a === b, fields: differences(kind, a, b, tolerance) }));
  return { run, found, ends: [old.end, now.end] };
}

async function all(runs) {
  const results = new Array(runs.length);
  let next = 0;
  const worker = async () => {
    while (next < runs.length) {
      const i = next++;
      results[i] = await compare(runs[i]);
      if (process.stderr.isTTY && i % 50 === 0) process.stderr.write(`\r${i} of ${runs.length} runs `);
    }
  };
  await Promise.all(Array.from({ length: availableParallelism() }, worker));
  return results;
}

const short = (value) => {
  const text = String(value).trim();
  return text.length > 90 ? `${text.slice(0, 90)}…` : text;
};
const size = ({ ulps, relative }) =>
  ulps === undefined ? "text" : `${relative.toExponential(1)} relative, ${ulps < 1e6 ? ulps : ulps.toExponential(1)} ulp`;
const words = ({ args }) => args.map((arg) => (arg.includes("/") ? basename(arg) : arg)).join(" ");

/** Prints what one command's runs gave; returns how many outputs differ. */
function report(command, results) {
  const outputs = results.flatMap(({ run, found }) => found.map((each) => ({ run, ...each })));
  const differing = outputs.filter(({ fields }) => fields.length > 0);
  const numbers = differing.filter(({ fields }) => fields.every(({ ulps }) => ulps !== undefined));
  const allowed = outputs.filter(({ same, fields }) => !same && fields.length === 0).length;
  const textOnly = differing.filter(({ fields }) => fields.every(({ ulps }) => ulps === undefined));
  const identical = outputs.filter(({ same }) => same).length;
  const parts = [`${identical} of ${outputs.length} outputs identical`];
  if (allowed) parts.push(`${allowed} within what is allowed`);
  if (numbers.length) parts.push(`${numbers.length} differ in numbers only`);
  if (textOnly.length) parts.push(`${textOnly.length} in text only`);
  const both = differing.length - numbers.length - textOnly.length;
  if (both) parts.push(`${both} in both`);
  console.log(`${command.padEnd(9)} ${results.length} runs: ${parts.join(", ")}`);
  for (const [i, build] of ["old", "new"].entries()) {
    // A refusal compares nothing but its message.
    const without = results.filter(({ ends }) => ends[i] !== "exit code 0");
    if (without.length && command !== "refused")
      console.log(`  ${build} build: ${without.length} runs without a result, the first: ${words(without[0].run)}: ${without[0].ends[i]}`);
  }

  const fields = new Map();
  for (const { run, output, kind, fields: found } of differing) {
    for (const field of found) {
      const name = `${field.path} (${output === "standard output" ? kind : output})`;
      const sum = fields.get(name) ?? { name, outputs: 0, count: 0, relative: 0, ulps: undefined, worst: run };
      sum.outputs += 1;
      sum.count += field.count;
      if (field.ulps !== undefined && (sum.ulps === undefined || field.relative >= sum.relative))
        Object.assign(sum, { relative: field.relative, worst: run });
      if (field.ulps !== undefined) sum.ulps = Math.max(sum.ulps ?? 0, field.ulps);
      fields.set(name, sum);
    }
  }
  for (const sum of [...fields.values()].sort((a, b) => b.relative - a.relative)) {
    console.log(`  ${sum.name}: ${sum.count} in ${sum.outputs} outputs, at most ${size(sum)}; ${words(sum.worst)}`);
  }
  const listed = options.all ? differing : differing.slice(0, SHOWN);
  for (const { run, output, fields: found } of listed) {
    const [first] = found;
    console.log(`    ${words(run)}: ${output}, ${first.at || first.path}: ${short(first.old)} → ${short(first.now)} (${size(first)})`);
  }
  if (listed.length < differing.length) console.log(`    … and ${differing.length - listed.length} more; --all lists them`);
  return differing.length;
}

const builtIn = JSON.parse((await outcome(binaries[0], { args: ["blades", "--format", "json"], files: [] })).stdout);
const names = (builtIn.blades ?? builtIn).map(({ name }) => name);
const files = readdirSync(options.blades)
  .filter((file) => /\.(toml|json)$/.test(file))
  .sort()
  .map((file) => join(options.blades, file));
const faults = new URL("../../tests/faults/cases.json", import.meta.url);
const faulty = JSON.parse(readFileSync(faults, "utf8")).map(({ format, text, replace = [] }, i) => {
  const spoilt = replace.reduce(
    (sound, [from, to]) => sound.replace(from, () => to),
    text ?? readFileSync(new URL(`base.${format}`, faults), "utf8"),
  );
  const file = join(work, `faulty-${i}.${format}`);
  writeFileSync(file, spoilt);
  return file;
});
const runs = [
  ...otherRuns(faulty),
  ...names.flatMap((name) => runsOf(name, measured, true)),
  ...files.flatMap((file) => runsOf(file, measured, false)),
];
const chosen = runs.filter(({ command }) => !only || only.includes(command));

const start = Date.now();
const results = await all(chosen);
console.log(
  `${names.length} built-in blades and ${files.length} files, ${chosen.length} runs of each build, ${Math.round((Date.now() - start) / 1000)} s`,
);
let differing = 0;
for (const command of [...new Set(chosen.map(({ command }) => command))])
  differing += report(
    command,
    results.filter(({ run }) => run.command === command),
  );
console.log(differing ? `${differing} outputs differ` : "nothing differs");
process.exitCode = differing ? 1 : 0;
