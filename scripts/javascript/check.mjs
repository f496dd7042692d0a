// Holds the JavaScript to its types: the page's to those of index.html and of the wasm package.
// `node check.mjs` fails on a fault in a file that has none in known.json, or on more than it has there;
// `node check.mjs --write` counts anew. The list may only get shorter.
import { readFileSync, writeFileSync } from "node:fs";
import { relative } from "node:path";
import { fileURLToPath } from "node:url";
import ts from "typescript";

const here = (path) => fileURLToPath(new URL(path, import.meta.url));
const root = here("../../");

/** The types of the page's elements, by id, out of index.html. */
function elements() {
  const page = readFileSync(here("../../web/index.html"), "utf8");
  const known = [...page.matchAll(/<([a-z][a-z0-9]*)\b[^>]*?\bid="([^"]+)"/g)].map(
    ([, tag, id]) => `  ${JSON.stringify(id)}: HTMLElementTagNameMap[${JSON.stringify(tag)}];`,
  );
  if (known.length < 50) throw new Error("index.html was not read");
  return `interface Elements {\n${known.join("\n")}\n}\n`;
}

writeFileSync(here("elements.d.ts"), elements());
const faults = [];
for (const config of ["tsconfig.web.json", "tsconfig.node.json"]) {
  const host = { ...ts.sys, onUnRecoverableConfigFileDiagnostic: (fault) => faults.push(fault) };
  const { fileNames, options } = ts.getParsedCommandLineOfConfigFile(here(config), {}, host);
  if (fileNames.length < 10) throw new Error(`${config} names hardly any file`);
  faults.push(...ts.getPreEmitDiagnostics(ts.createProgram(fileNames, options)));
}

const listed = new Map();
for (const { file, start, code, messageText } of faults) {
  const name = file ? relative(root, file.fileName).replaceAll("\\", "/") : "";
  const line = file ? file.getLineAndCharacterOfPosition(start).line + 1 : 0;
  listed.set(name, [...(listed.get(name) ?? []), `${name}:${line} TS${code}: ${ts.flattenDiagnosticMessageText(messageText, " ").slice(0, 200)}`]);
}
const counts = Object.fromEntries([...listed].sort().map(([name, lines]) => [name, lines.length]));
if (process.argv.includes("--write")) writeFileSync(here("known.json"), `${JSON.stringify(counts, null, 2)}\n`);
const known = JSON.parse(readFileSync(here("known.json"), "utf8"));
for (const [name, lines] of listed) {
  if (lines.length > (known[name] ?? 0)) {
    console.error(lines.join("\n"));
    process.exitCode = 1;
  }
}
// What is mended is taken off the list, lest it come back.
const mended = Object.keys(known).filter((name) => (counts[name] ?? 0) < known[name]);
if (mended.length > 0) {
  console.error(`fewer faults than known.json says, count anew with --write: ${mended.join(", ")}`);
  process.exitCode = 1;
}
