// Holds the JavaScript to its types: the page's to those of index.html and of the wasm package.
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

for (const { file, start, code, messageText } of faults) {
  const name = file && relative(root, file.fileName).replaceAll("\\", "/");
  const place = file ? `${name}:${file.getLineAndCharacterOfPosition(start).line + 1} ` : "";
  console.error(`${place}TS${code}: ${ts.flattenDiagnosticMessageText(messageText, " ").slice(0, 200)}`);
  process.exitCode = 1;
}
