// Builds the documentation: every page of the list below and every other file of docs/ in Markdown,
// with the pictures and tables that they link to. Run by scripts/docs-site.
//
// Why these packages (November 2026): all are maintained, have no dependencies of their own and
// install in a second. mdBook is minutes of compiling, and KaTeX's and MathJax's HTML is laid out by
// style attributes, which the pages' Content-Security-Policy forbids.
//   marked         Markdown as GitHub reads it
//   temml          TeX to MathML, which browsers draw by themselves
//   stix-two-math  the font for it, since many systems have none
import { cpSync, existsSync, mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { dirname, posix } from "node:path";
import { fileURLToPath } from "node:url";
import { Equations } from "./equations.mjs";
import { render } from "./markdown.mjs";
import { layOut } from "./page.mjs";

const root = fileURLToPath(new URL("../../", import.meta.url));
const packages = fileURLToPath(new URL("node_modules/", import.meta.url));
const aside = `${root}target/docs-site`;
const site = `${root}web/docs`;
const read = (path) => readFileSync(root + path, "utf8");

/** In the order of reading, with the names that the navigation has for them. */
const listed = new Map([
  ["README.md", "Overview"],
  ["docs/CALCULATOR.md", "Using the calculator"],
  ["docs/BLADE_FORMAT.md", "Blade format"],
  ["docs/THEORY.md", "Theory"],
  ["docs/VALIDATION.md", "Validation"],
  ["docs/ARCHITECTURE.md", "Architecture"],
  ["CONTRIBUTING.md", "Contributing"],
  ["CHANGELOG.md", "Changelog"],
]);

/** README.md is the index; docs/BLADE_FORMAT.md becomes blade-format.html. */
function addressOf(source) {
  if (source === "README.md") return "index.html";
  return `${source
    .replace(/^docs\//, "")
    .replace(/\.md$/, "")
    .toLowerCase()
    .replaceAll("_", "-")}.html`;
}

const inDocs = readdirSync(`${root}docs`, { recursive: true }).map((path) => `docs/${path.replaceAll("\\", "/")}`);
const sources = [...new Set([...listed.keys(), ...inDocs.filter((path) => path.endsWith(".md")).sort()])];
const addresses = new Map(sources.map((source) => [source, addressOf(source)]));
const [, repository] = /^repository = "(.*)"$/m.exec(read("Cargo.toml"));

/** Files of docs/ that a page links to, with their addresses. */
const files = new Map();

/** Where a link of a page leads on the site, and the page's name; a link that leads nowhere ends the build. */
function resolve(source, link) {
  if (/^[a-z]+:/i.test(link) || link.startsWith("#")) return { href: link };
  const [path, ...fragment] = link.split("#");
  const target = posix.join(posix.dirname(source), decodeURI(path));
  if (!existsSync(root + target)) throw new Error(`${source} links to ${link}, which is not there`);
  const after = ["", ...fragment].join("#");
  const here = (address) => posix.relative(posix.dirname(addresses.get(source)), address) + after;
  if (addresses.has(target)) return { href: here(addresses.get(target)), name: listed.get(target) };
  if (!/^docs\/.*\.\w+$/.test(target)) return { href: `${repository}/blob/main/${target}${after}` };
  files.set(target, target.slice("docs/".length));
  return { href: here(files.get(target)) };
}

function write(address, text) {
  mkdirSync(dirname(`${aside}/${address}`), { recursive: true });
  writeFileSync(`${aside}/${address}`, text);
}

rmSync(aside, { recursive: true, force: true });
const equations = new Equations();
const pages = sources.map((source) => {
  const page = render(read(source), { name: source, equations, resolve: (link) => resolve(source, link) });
  return { ...page, address: addresses.get(source), name: listed.get(source) ?? page.title };
});
pages.forEach((page, i) => write(page.address, layOut(page, pages, pages[i - 1], pages[i + 1])));
for (const [source, address] of files) cpSync(root + source, `${aside}/${address}`);

// The calculator's colours, from where it has them.
const [colours] = /^:root \{[^}]*\}\n/m.exec(read("web/styles/page.css"));
write("docs.css", colours + read("scripts/docs/docs.css"));
write("math.css", readFileSync(`${packages}temml/dist/Temml-Local.css`, "utf8") + read("scripts/docs/math.css") + equations.css());
const font = "@fontsource/stix-two-math";
cpSync(`${packages}temml/dist/Temml.woff2`, `${aside}/Temml.woff2`); // primes and script letters
cpSync(`${packages}temml/LICENSE`, `${aside}/Temml-LICENSE.txt`);
cpSync(`${packages}${font}/files/stix-two-math-latin-400-normal.woff2`, `${aside}/STIXTwoMath.woff2`);
cpSync(`${packages}${font}/LICENSE`, `${aside}/STIXTwoMath-LICENSE.txt`);

rmSync(site, { recursive: true, force: true });
cpSync(aside, site, { recursive: true }); // a rename would fail where target/ lies on another disk
console.log(`docs-site: ${pages.length} pages, ${equations.count} equations in web/docs`);
