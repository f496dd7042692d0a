// What the page's tests share: the server, the browser, and a page that is watched.

import assert from "node:assert/strict";
import { existsSync, mkdirSync } from "node:fs";
import { createRequire } from "node:module";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { chromium } from "playwright-core";
import { serve } from "../../scripts/serve.mjs";

const candidates = [process.env.CHROMIUM, "/usr/bin/chromium", "/usr/bin/google-chrome", "/usr/bin/chromium-browser"];
const executablePath = candidates.find((path) => path && existsSync(path));
const flags = ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync"];

/** Where pictures of the page go, to be looked at. */
export const screenshots = fileURLToPath(new URL("screenshots/", import.meta.url));
/** The server's address and the browser: one of each for the tests of a file. */
export const site = {};
let server;
before(async () => {
  assert.ok(executablePath, "no Chromium found; CHROMIUM names one");
  mkdirSync(screenshots, { recursive: true });
  server = await serve(0);
  site.origin = `http://127.0.0.1:${server.address().port}`;
  site.browser = await chromium.launch({ executablePath, args: flags });
});
after(async () => {
  await site.browser?.close();
  server?.close();
});

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

/**
 * A page that is watched: what the console says, what fails and what is asked of another host is
 * kept in `complaints`, which every test expects to stay empty.
 */
export async function watched(options) {
  const { browser, origin } = site;
  const context = await browser.newContext({ serviceWorkers: "block", reducedMotion: "reduce", viewport: { width: 1280, height: 800 }, acceptDownloads: true, ...options });
  context.setDefaultTimeout(15_000);
  const page = await context.newPage();
  const complaints = [];
  page.on("console", (message) => {
    const blocked = message.text().includes("Service Worker registration blocked"); // by these tests
    if (["error", "warning"].includes(message.type()) && !blocked) complaints.push(`console: ${message.text()}`);
  });
  page.on("pageerror", (error) => complaints.push(`error: ${error.message}`));
  page.on("request", (request) => {
    const url = request.url();
    if (!url.startsWith(`${origin}/`) && !url.startsWith(`blob:${origin}/`)) complaints.push(`request: ${url}`);
  });
  page.on("response", (response) => {
    if (response.status() >= 400) complaints.push(`status ${response.status()}: ${response.url()}`);
  });
  return { page, complaints, close: () => context.close() };
}

/** Opens the calculator, watched, and waits for its first chart. */
export async function open({ fragment = "", ...options } = {}) {
  const opened = await watched(options);
  await opened.page.goto(`${site.origin}/${fragment}`);
  await drawn(opened.page);
  return opened;
}

const axe = createRequire(import.meta.url).resolve("axe-core/axe.min.js");

/**
 * The rules of axe-core that a page breaks, with the elements that break them; the page needs
 * `bypassCSP`. `context` and `options` are axe's own.
 */
export async function findings(page, context = {}, options = {}) {
  if (await page.evaluate(() => typeof axe === "undefined")) await page.addScriptTag({ path: axe });
  const { violations } = await page.evaluate(([context, options]) => axe.run({ include: document, ...context }, { resultTypes: ["violations"], ...options }), [context, options]);
  return violations.map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.target.join(" ")).join(", ")}`);
}

/** Waits until the chart, the table and the slider are there. */
export async function drawn(page) {
  await page.locator("#chart > svg:not(.overlay)").waitFor();
  await page.locator("#modes tbody tr").first().waitFor();
  await page.locator("#speed-slider:enabled").waitFor();
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
