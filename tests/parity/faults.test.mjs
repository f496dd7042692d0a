// A bad input gives the same faults through the command line and through the package.

import assert from "node:assert/strict";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, test } from "node:test";
import { blades, pkg, run, text } from "./both.mjs";

const folder = mkdtempSync(join(tmpdir(), "bladefan-faults-"));
after(() => rmSync(folder, { recursive: true }));

const base = { toml: text("tests/faults/base.toml"), json: text("tests/faults/base.json") };
const cases = JSON.parse(text("tests/faults/cases.json"));

/** The text of a case: its own, or a good file with replacements. */
function textOf(bad) {
  if (bad.text !== undefined) return bad.text;
  return bad.replace.reduce((text, [from, to]) => {
    assert.ok(text.includes(from), `${bad.name}: the base file has no ${from}`);
    return text.replace(from, () => to);
  }, base[bad.format]);
}

/** A fault in one line, as the command line writes it. */
function line(file, { line, column, path, message }) {
  const place = line === null ? `${file}: ` : `${file}:${line}:${column}: `;
  return `${place}${path === "" ? "" : `${path}: `}${message}`;
}

assert.ok(cases.length >= 50, `${cases.length} cases`);
cases.forEach((bad, i) => {
  test(`${bad.name} (${bad.format})`, () => {
    const content = textOf(bad);
    const answer = pkg.parse_blade(content, bad.format);
    assert.equal(answer.status, "error");
    assert.deepEqual(
      answer.faults.map(({ code, path, line, column, message }) => ({ code, path, line, column, message })),
      bad.faults,
    );

    const file = join(folder, `${i}.${bad.format}`);
    writeFileSync(file, content);
    const { status, stdout, stderr } = run("modes", file);
    assert.equal(status, 2);
    assert.equal(stdout, "");
    assert.deepEqual(
      stderr.trimEnd().split("\n"),
      answer.faults.map((fault) => line(file, fault)),
    );
  });
});

/** @type {[string, object][]} */
const options = [
  ["modes", { speed: "-1" }],
  ["modes", { speed: "660 rpm" }],
  ["modes", { functions: 0, modes: 51 }],
  ["modes", { basis: "classical", modes: 20 }],
  ["modes", { dof: "flap,flap" }],
  ["modes", { basis: "gauss" }],
  ["fan", { speeds: "5:1:10" }],
  ["fan", { speeds: "0:100:1" }],
  ["fan", { harmonics: 0, band: "2:1" }],
  ["shapes", { points: 1 }],
  ["shapes", { normalise: "tip" }],
  ["converge", { up_to: 500 }],
];
for (const [command, given] of options) {
  test(`${command} with ${JSON.stringify(given)}`, () => {
    const { name, blade } = blades[0];
    const answer = pkg[command](blade, given);
    assert.equal(answer.status, "error");
    const args = Object.entries(given).flatMap(([option, value]) => [`--${option.replace("_", "-")}`, String(value)]);
    const { status, stdout, stderr } = run(command, name, ...args);
    assert.equal(status, 2);
    assert.equal(stdout, "");
    assert.deepEqual(
      stderr.trimEnd().split("\n"),
      answer.faults.map((fault) => `--${fault.path.replace("_", "-")}: ${fault.message}`),
    );
  });
}
