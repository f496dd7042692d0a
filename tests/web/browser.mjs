// A browser, the server and a page that is watched: for the tests of the page and for what measures it.

import assert from "node:assert/strict";
import { existsSync } from "node:fs";
import { chromium } from "playwright-core";
import { serve } from "../../scripts/serve.mjs";

const candidates = [process.env.CHROMIUM, "/usr/bin/chromium", "/usr/bin/google-chrome", "/usr/bin/chromium-browser"];
const executablePath = candidates.find((path) => path && existsSync(path));
const flags = [
  "--no-sandbox",
  "--disable-gpu",
  "--disable-quic",
  "--no-first-run",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
];

/** The server's address and the browser, once they are started. */
export const site = {};

/** Starts both; gives what stops them. */
export async function start() {
  assert.ok(executablePath, "no Chromium found; CHROMIUM names one");
  const server = await serve(0);
  site.origin = `http://127.0.0.1:${server.address().port}`;
  site.browser = await chromium.launch({ executablePath, args: flags });
  return async () => {
    await site.browser.close();
    server.close();
  };
}

/**
 * A page that is watched: what the console says, what fails and what is asked of another host is
 * kept in `complaints`, which every test expects to stay empty.
 */
export async function watched(options) {
  const { browser, origin } = site;
  const context = await browser.newContext({
    serviceWorkers: "block",
    reducedMotion: "reduce",
    viewport: { width: 1280, height: 800 },
    acceptDownloads: true,
    ...options,
  });
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

/** Opens the calculator, watched, and waits for its first chart, or for the one of a `model` that is chosen. */
export async function open({ fragment = "", model = null, ...options } = {}) {
  const opened = await watched(options);
  await opened.page.goto(`${site.origin}/${fragment}`);
  await drawn(opened.page);
  if (model !== null) await chooseModel(opened.page, model);
  return opened;
}

/** Chooses a model, and waits until chart and table are its own. */
export async function chooseModel(page, model) {
  await page.locator("#model-choice").selectOption(model);
  const words = new RegExp(`(^|\\s)${model}, in vacuum`);
  await page.locator("#model", { hasText: words }).waitFor();
  await page.locator("#chart > svg:not(.overlay) text", { hasText: words }).first().waitFor();
}

/** Waits until the chart, the table and the slider are there. */
export async function drawn(page) {
  await page.locator("#chart > svg:not(.overlay)").waitFor();
  await page.locator("#modes tbody tr:not([hidden])").first().waitFor();
  await page.locator("#speed-slider:enabled").waitFor();
}
