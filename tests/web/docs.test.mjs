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

/** What the browser makes of every page, by the page's address. */
const seen = new Map();
test("every page opens, and nothing is asked of another host", async () => {
  await eachPage({}, async (page) => {
    seen.set(
      page.url(),
      await page.evaluate(async () => {
        await document.fonts.ready;
        const text = document.querySelector("main").cloneNode(true);
        for (const other of text.querySelectorAll("code, math")) other.remove();
        return {
          links: [...document.querySelectorAll("a")].map((link) => link.href),
          ids: [...document.querySelectorAll("[id]")].map((element) => element.id),
          broken: [...document.images].filter((image) => image.naturalWidth === 0 || image.alt === "").map((image) => image.src),
          displayed: document.querySelectorAll(".equation > math").length,
          equations: {
            flat: [...document.querySelectorAll("math")].filter((math) => math.getBoundingClientRect().height < 4).length,
            faults: document.querySelectorAll("merror, .temml-error").length,
            left: text.textContent.match(/.*[$\\].*/g),
            font: document.querySelector("math") === null || document.fonts.check('16px "STIX Two Math"'),
          },
        };
      }),
    );
  });
});

test("every page is linked to, and every link, image and anchor leads somewhere", async () => {
  const targets = new Set();
  for (const [address, { links, ids, broken }] of seen) {
    assert.deepEqual(broken, [], address);
    assert.equal(new Set(ids).size, ids.length, `${address}: an id twice`);
    for (const href of links.filter((href) => !href.startsWith("https://"))) {
      const [target, id] = href.split("#");
      targets.add(target);
      assert.ok(id === undefined || seen.get(target)?.ids.includes(decodeURIComponent(id)), `${address} links to ${href}`);
    }
  }
  for (const address of seen.keys()) assert.ok(targets.has(address), `nothing links to ${address}`);
  assert.ok(targets.has(`${site.origin}/`), "no way back to the calculator");
  assert.ok(readFileSync(`${root}web/index.html`, "utf8").includes('href="docs/"'), "no way from the calculator");
  for (const target of targets.add(`${site.origin}/docs/`)) {
    assert.ok(target.startsWith(`${site.origin}/`), target);
    assert.equal((await fetch(target)).status, 200, target);
  }
});

test("every equation is drawn", () => {
  for (const [address, { equations }] of seen) assert.deepEqual(equations, { flat: 0, faults: 0, left: null, font: true }, address);
  const displayed = [...seen.values()].reduce((sum, page) => sum + page.displayed, 0);
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
    // Three hundred equations take long to look through, and have the text's colour.
    const text = { exclude: ["math"] };
    await eachPage({ viewport: { width, height }, colorScheme: "light", bypassCSP: true }, async (page, name) => {
      const sideways = await page.evaluate(async () => {
        await document.fonts.ready; // equations have another width before
        return document.documentElement.scrollWidth - innerWidth;
      });
      assert.ok(sideways <= 0, `${name} is ${sideways} px too wide`);
      assert.deepEqual(await findings(page, width === 390 ? text : undefined), [], name);
      await page.emulateMedia({ colorScheme: "dark" });
      assert.deepEqual(await findings(page, text, { runOnly: ["color-contrast"] }), [], `${name}, dark`);
      await page.emulateMedia({ colorScheme: "light" });
    });
  });
}

test("no script, and none is allowed", () => {
  for (const name of names) {
    const html = readFileSync(`${root}web/docs/${name}`, "utf8");
    assert.ok(!/<script|<style| style=| on\w+="/.test(html), name);
    assert.match(html, /http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'self';/);
  }
});
