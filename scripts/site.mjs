// The page as it is served: index.html and sw.js at the top, and beside them one folder, named after its
// contents, with all that the page runs: its own modules and styles and the wasm package. So a
// page of one version never runs with files of another, whatever a browser or a proxy has kept.
//   import { site } from "./site.mjs"; … site() …       every file by its path, as bytes
//   node scripts/site.mjs FOLDER                        writes them there, with the documentation
import { createHash } from "node:crypto";
import { cpSync, existsSync, mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { dirname, join, relative, sep } from "node:path";
import { fileURLToPath } from "node:url";

export const web = fileURLToPath(new URL("../web/", import.meta.url));

/** What stands at the top, where browsers look for it; the rest is of one version. */
const isTop = (path) => ["index.html", "sw.js", "icon.svg"].includes(path);
/** The documentation is no part of what runs, and no browser asks for the types. */
const isServed = (path) => !path.startsWith("docs/") && !path.endsWith(".d.ts") && !path.split("/").some((part) => part.startsWith("."));

/** Every file of the page by its path in the page's folder, as bytes. */
export function sources(folder = web) {
  const files = readdirSync(folder, { recursive: true, withFileTypes: true }).filter((entry) => entry.isFile());
  const paths = files.map((entry) => relative(folder, join(entry.parentPath, entry.name)).replaceAll(sep, "/"));
  return new Map(
    paths
      .filter(isServed)
      .sort()
      .map((path) => [path, readFileSync(join(folder, path))]),
  );
}

/** The text with one thing in it replaced; a text without it is a mistake of ours. */
function replaced(text, from, to) {
  if (text.split(from).length !== 2) throw new Error(`the page has no single place for “${from}”`);
  return text.replace(from, () => to);
}

/** The files as they are served, and the version that they are. */
export function site(files = sources()) {
  for (const needed of ["index.html", "sw.js", "pkg/bladefan_wasm_bg.wasm", "pkg/library.js"]) {
    if (!files.has(needed)) throw new Error(`the page lacks ${needed}; scripts/wasm-package builds the package`);
  }
  const hash = createHash("sha256");
  for (const [path, bytes] of files) hash.update(`${path}\0${bytes.length}\0`).update(bytes);
  const version = hash.digest("hex").slice(0, 12);

  const served = new Map();
  for (const [path, bytes] of files) served.set(isTop(path) ? path : `${version}/${path}`, bytes);
  const text = (path) => files.get(path).toString("utf8");
  const page = text("index.html").replaceAll(/\b(src|href)="([^"]+)"/g, (whole, name, path) =>
    served.has(`${version}/${path}`) ? `${name}="${version}/${path}"` : whole,
  );
  // All that the first chart needs is asked for at once, rather than import by import.
  const early = [
    `<link rel="preload" as="fetch" type="application/wasm" crossorigin href="${version}/pkg/bladefan_wasm_bg.wasm">`,
    ...[...files.keys()]
      .filter((path) => path.endsWith(".js") && !["sw.js", "solver/worker.js"].includes(path))
      .map((path) => `<link rel="modulepreload" href="${version}/${path}">`),
  ];
  served.set("index.html", Buffer.from(replaced(page, "</head>", `  ${early.join("\n  ")}\n</head>`)));
  const kept = ["icon.svg", ...[...served.keys()].filter((path) => path.startsWith(`${version}/`))];
  const worker = replaced(text("sw.js"), 'const VERSION = "";', `const VERSION = "${version}";`);
  served.set("sw.js", Buffer.from(replaced(worker, "const FILES = [];", `const FILES = ${JSON.stringify(kept)};`)));
  return { version, files: served };
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const [folder] = process.argv.slice(2);
  if (folder === undefined) throw new Error("scripts/site.mjs needs the folder to write to");
  rmSync(folder, { recursive: true, force: true });
  const { version, files } = site();
  for (const [path, bytes] of files) {
    mkdirSync(dirname(join(folder, path)), { recursive: true });
    writeFileSync(join(folder, path), bytes);
  }
  if (existsSync(`${web}docs`)) cpSync(`${web}docs`, join(folder, "docs"), { recursive: true });
  console.log(`version ${version}: ${files.size} files in ${folder}`);
}
