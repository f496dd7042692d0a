// The package in the page: one module in two workers, and what is said where it does not come.

import assert from "node:assert/strict";
import { test } from "node:test";
import { drawn, frequencies, open, pageTest, paste, site } from "./support.mjs";

pageTest("the first chart, the table and the sliders need no second worker, and the module is fetched once", {}, async (page) => {
  // The page as it was opened starts its second worker, too, and may do so late: it is let finish.
  await page.locator("#motion svg.shape-plot").waitFor();
  let release;
  const held = new Promise((resolve) => (release = resolve));
  let workers = 0;
  page.on("framenavigated", () => (workers = 0));
  const modules = [];
  page.on("request", (request) => request.url().endsWith(".wasm") && modules.push(request.url()));
  await page.route("**/solver/worker.js", async (route) => {
    if (++workers > 1) await held;
    await route.continue();
  });
  await page.reload();
  await drawn(page);
  const before = await frequencies(page);
  await page.locator("#what-if-factors-flap_stiffness").fill("0.3");
  await page.waitForFunction((old) => document.querySelectorAll("#modes tbody tr")[1].cells[1].dataset.full !== old, String(before["2F"]));
  assert.equal(await page.locator("#motion svg.shape-plot").count(), 0, "the moving mode waits for the second worker");
  release();
  await page.locator("#motion svg.shape-plot").waitFor();
  assert.equal(modules.length, 1, modules.join());
});

pageTest("the library is what the package reads", {}, async (page) => {
  const compared = await page.evaluate(async () => {
    const { src } = document.querySelector("script[type=module]");
    const bladefan = await import(new URL("../pkg/bladefan_wasm.js", src));
    await bladefan.default();
    const { about, blades: library } = await import(new URL("../pkg/library.js", src));
    const same = (a, b) => JSON.stringify(a) === JSON.stringify(b);
    const faults = [];
    if (!same(bladefan.about().value, about)) faults.push("about");
    const built = bladefan.built_in_blades().value;
    if (built.length !== library.length) faults.push("number of blades");
    for (const [i, { blade, ...rest }] of library.entries()) {
      if (!same(built[i], rest) || !same(bladefan.parse_blade(rest.toml).value, blade)) faults.push(rest.name);
    }
    return { blades: library.length, faults };
  });
  assert.ok(compared.blades >= 5);
  assert.deepEqual(compared.faults, []);
});

test("a module that never arrives is waited for 30 seconds, then said, and another try brings it", async () => {
  const context = await site.browser.newContext({ serviceWorkers: "block" });
  try {
    const page = await context.newPage();
    await page.clock.install();
    let held = true;
    await page.route("**/*.wasm", (route) => (held ? undefined : route.continue())); // no answer, as on a dead connection
    await page.goto(site.origin);
    await page.locator("#blade-choice option[value=sa330]").waitFor({ state: "attached" });
    await page.clock.runFor(29_000);
    assert.equal(await page.locator("#solve-faults").isVisible(), false);
    await page.clock.runFor(2_000);
    await page.locator("#solve-faults", { hasText: "the solver could not be loaded: it has not arrived within 30 seconds" }).waitFor();
    held = false;
    await page.locator("#solve-faults button", { hasText: "Try again" }).click();
    await page.clock.resume();
    await drawn(page);
    await page.locator("#solve-faults").waitFor({ state: "hidden" });
  } finally {
    await context.close();
  }
});

pageTest("what is opened while a file is being read stays, and keeps its name", {}, async (page) => {
  // An own blade is kept as its text, then brought back over a connection on which the worker that reads it takes its time.
  await page.locator("#tab-text").click();
  await page.waitForFunction(() => document.getElementById("blade-text").value.includes("TM 4760"));
  await paste(page, `# mine\n${await page.locator("#blade-text").inputValue()}`);
  await page.waitForFunction(() => Object.keys(localStorage).some((key) => localStorage.getItem(key).includes("# mine")));
  await page.locator("#tab-fan").click();
  await page.waitForTimeout(600);
  const kept = () => page.evaluate(() => JSON.stringify(Object.entries(localStorage)));
  let release;
  const held = new Promise((resolve) => (release = resolve));
  let workers = 0;
  page.on("framenavigated", () => (workers = 0));
  await page.route("**/solver/worker.js", async (route) => {
    if (++workers > 1) await held;
    await route.continue();
  });
  await page.reload();
  await page.locator("#blade-choice option[value=sa330]").waitFor({ state: "attached" });
  await page.locator("#blade-choice").selectOption("sa330");
  await page.locator("#chart > svg:not(.overlay)").waitFor();
  const before = await kept();
  release();
  await page.waitForTimeout(600);
  assert.match(await page.locator("#chart > svg:not(.overlay)").getAttribute("aria-label"), /SA 330/);
  // A change of the other blade does not take the place of the kept one.
  await page.locator("#what-if-factors-mass").fill("0.3");
  await page.waitForFunction((old) => JSON.stringify(Object.entries(localStorage)) !== old, before);
  assert.equal(
    await page.evaluate(
      () =>
        Object.values(localStorage)
          .map((text) => JSON.parse(text))
          .flat()
          .filter((entry) => entry?.content).length,
    ),
    2,
  );
});

test("a library that does not come is said, and another try brings it", async () => {
  const { page, close } = await open();
  try {
    let gone = true;
    await page.route("**/pkg/library.js", (route) => (gone ? route.abort() : route.continue()));
    await page.reload();
    await page.locator("#solve-faults", { hasText: "could not be loaded" }).waitFor();
    gone = false;
    await page.locator("#solve-faults button", { hasText: "Try again" }).click();
    await drawn(page);
    await page.locator("#solve-faults").waitFor({ state: "hidden" });
  } finally {
    await close(); // what the browser tells of the request that failed is no complaint here
  }
});
