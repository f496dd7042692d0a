// The documentation beside the calculator: links, equations, and pages that need no script.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync, readdirSync } from "node:fs";
import { before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { Equations } from "../../scripts/docs/equations.mjs";
import { render } from "../../scripts/docs/markdown.mjs";
import { findings, site, watched } from "./support.mjs";

const root = fileURLToPath(new URL("../../", import.meta.url));
let names;
before(() => {
  execFileSync(`${root}scripts/docs-site`);
  names = readdirSync(`${root}web/docs`, { recursive: true }).filter((name) => name.endsWith(".html"));
});

/** Opens every page in turn, watched. */
async function eachPage(options, body) {
  const { page, complaints, close } = await watched(options);
  try {
    for (const name of names) {
      await page.goto(`${site.origin}/docs/${name}`);
      await body(page, name);
    }
    assert.deepEqual(complaints, []);
  } finally {
    await close();
  }
}

test("every page is reached, and every link, image and anchor leads somewhere", async () => {
  const links = new Map([["../", ["docs/"]]]);
  const anchors = new Map();
  await eachPage({}, async (page, name) => {
    const here = await page.evaluate(() => ({
      links: [...document.querySelectorAll("a")].map((link) => link.href),
      ids: [...document.querySelectorAll("[id]")].map((element) => element.id),
      broken: [...document.images].filter((image) => image.naturalWidth === 0 || image.alt === "").map((image) => image.src),
    }));
    assert.deepEqual(here.broken, [], name);
    assert.equal(new Set(here.ids).size, here.ids.length, `${name}: an id twice`);
    links.set(name, here.links);
    anchors.set(`${site.origin}/docs/${name}`, here.ids);
  });
  const all = [...links].flatMap(([name, to]) => to.map((href) => ({ name, href })));
  const inside = all.filter(({ href }) => href.startsWith(site.origin));
  assert.deepEqual(all.filter(({ href }) => !href.startsWith(site.origin) && !href.startsWith("https://") && href !== "docs/"), []);
  for (const { name, href } of inside.filter(({ href }) => href.includes("#"))) {
    const [address, id] = href.split("#");
    assert.ok(anchors.get(address)?.includes(decodeURIComponent(id)), `${name} links to ${href}`);
  }
  const targets = new Set(inside.map(({ href }) => href.split("#")[0]));
  for (const name of names) assert.ok(targets.has(`${site.origin}/docs/${name}`), `nothing links to ${name}`);
  for (const target of targets) assert.equal((await fetch(target)).status, 200, target);
  assert.ok(targets.has(`${site.origin}/`), "no way back to the calculator");
  const calculator = readFileSync(`${root}web/index.html`, "utf8");
  assert.ok(calculator.includes('href="docs/"'), "the calculator does not link to its documentation");
  assert.equal((await fetch(`${site.origin}/docs/`)).status, 200);
});

test("every equation is drawn", async () => {
  let displayed = 0;
  await eachPage({}, async (page, name) => {
    const seen = await page.evaluate(async () => {
      await document.fonts.ready;
      const equations = [...document.querySelectorAll("math")];
      const left = document.querySelector("main").cloneNode(true);
      for (const code of left.querySelectorAll("code, math")) code.remove();
      return {
        displayed: document.querySelectorAll(".equation > math").length,
        flat: equations.filter((math) => math.getBoundingClientRect().height < 4).length,
        faults: document.querySelectorAll("merror, .temml-error, math[style]").length,
        left: left.textContent.match(/.*[$\\].*/g),
        font: equations.length === 0 || document.fonts.check('16px "STIX Two Math"'),
      };
    });
    displayed += seen.displayed;
    delete seen.displayed;
    assert.deepEqual(seen, { flat: 0, faults: 0, left: null, font: true }, name);
  });
  const sources = [...readdirSync(`${root}docs`, { recursive: true }).map((name) => `docs/${name}`), "README.md", "CONTRIBUTING.md", "CHANGELOG.md"];
  const texts = sources.filter((name) => name.endsWith(".md")).map((name) => readFileSync(root + name, "utf8"));
  assert.equal(displayed, texts.join("\n").match(/^\s*```math$/gm).length);
  assert.ok(displayed > 15);
});

test("Markdown is read as on GitHub", () => {
  const read = (text) => render(text, { name: "test", equations: new Equations(), resolve: (href) => ({ href: `to/${href}` }) }).body;
  const math = (text) => read(`# T\n\n${text}`).match(/<math/g)?.length ?? 0;
  assert.equal(math("$a_1$ and $b_2$, ($c$)"), 3);
  assert.equal(math("5 $ and 6 $, or $5 and 6$7, or `$x$`"), 0);
  assert.ok(!read("# T\n\n*not* $a*b$ and $c*d$").includes("<em>b"));
  assert.match(read("# T\n\n($c$),"), /<span class="kept">\(<math>.*<\/math>\),<\/span>/);
  assert.match(read("# T\n\n## A `b`: c, d\n\n## A `b`: c, d"), /id="a-b-c-d".*id="a-b-c-d-1"/s);
  assert.match(read('# T\n\n<img src="a.svg" alt="a">\n\n[csv](a.csv)'), /src="to\/a.svg".*href="to\/a.csv"/s);
  assert.throws(() => read("# T\n\n$\\nonsense$"), /test: .*nonsense/s);
});

for (const [width, height] of [[1280, 800], [390, 844]]) {
  test(`nothing to find at ${width} px, light and dark, and no scrolling sideways`, async () => {
    // Three hundred equations take long to look through, and are the same at every width and of the text's colour.
    const text = { exclude: ["math"] };
    await eachPage({ viewport: { width, height }, colorScheme: "light", bypassCSP: true }, async (page, name) => {
      const sideways = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
      assert.ok(sideways <= 0, `${name} is ${sideways} px too wide`);
      assert.deepEqual(await findings(page, width === 390 ? text : undefined), [], name);
      await page.emulateMedia({ colorScheme: "dark" });
      assert.deepEqual(await findings(page, text, { runOnly: ["color-contrast"] }), [], `${name}, dark`);
      await page.emulateMedia({ colorScheme: "light" });
    });
  });
}

test("no script, and none is allowed", async () => {
  await eachPage({ javaScriptEnabled: false }, async (page, name) => {
    const html = await page.content();
    assert.ok(!/<script|<style| style=| on\w+="/.test(html), name);
    assert.match(html, /http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'self';/);
    await page.locator("article h1").waitFor();
  });
});
