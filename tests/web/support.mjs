// What the page's tests share.

import assert from "node:assert/strict";
import { mkdirSync } from "node:fs";
import { createRequire } from "node:module";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { open, start } from "./browser.mjs";

export { chooseModel, drawn, open, site, watched } from "./browser.mjs";

/** Where pictures of the page go, to be looked at. */
export const screenshots = fileURLToPath(new URL("screenshots/", import.meta.url));

// One server and one browser for the tests of a file.
let stop;
before(async () => {
  mkdirSync(screenshots, { recursive: true });
  stop = await start();
});
after(() => stop?.());

/** A test with a page of its own, whose console and network must stay clean. */
export function pageTest(name, options, body) {
  test(name, async () => {
    const { page, complaints, close } = await open(options);
    try {
      await body(page);
      assert.deepEqual(complaints, []);
    } finally {
      await close();
    }
  });
}

const axe = createRequire(import.meta.url).resolve("axe-core/axe.min.js");

/**
 * The rules of axe-core that a page breaks, with the elements that break them; the page needs
 * `bypassCSP`. `context` and `options` are axe's own.
 */
export async function findings(page, context = {}, options = {}) {
  if (await page.evaluate(() => typeof axe === "undefined")) await page.addScriptTag({ path: axe });
  const { violations } = await page.evaluate(
    ([context, options]) => axe.run({ include: document, ...context }, { resultTypes: ["violations"], ...options }),
    [context, options],
  );
  return violations.map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.target.join(" ")).join(", ")}`);
}

/** Puts a text into the editor as a user who pastes it. */
export async function paste(page, text) {
  if ((await page.locator("#tab-text").getAttribute("aria-selected")) !== "true") await page.locator("#tab-text").click();
  await page.locator("#blade-text").fill(text);
}

/** The table's rows as texts. */
export function rows(page) {
  return page.locator("#modes tbody tr").evaluateAll((all) => all.map((row) => [...row.cells].map((cell) => cell.textContent)));
}

/** Full-precision frequencies of the table in rad/s, by label. */
export function frequencies(page) {
  return page
    .locator("#modes tbody tr")
    .evaluateAll((all) => Object.fromEntries(all.map((row) => [row.cells[0].textContent, Number(row.cells[1].dataset.full)])));
}

/** Runs an export of the wasm package in the page's own thread, as the independent second way. */
export function call(page, name, ...args) {
  return page.evaluate(
    async ([name, args]) => {
      const { src } = document.querySelector("script[type=module]");
      const bladefan = await import(new URL("../pkg/bladefan_wasm.js", src));
      await bladefan.default();
      return bladefan[name](...args);
    },
    [name, args],
  );
}

/** Clicks something that starts a download and gives its name and text. */
export async function downloaded(page, click) {
  const [file] = await Promise.all([page.waitForEvent("download"), click()]);
  const chunks = [];
  for await (const chunk of await file.createReadStream()) chunks.push(chunk);
  return { name: file.suggestedFilename(), bytes: Buffer.concat(chunks) };
}
