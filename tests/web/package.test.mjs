// The package's two modules: the first view needs the small one alone, and both give the same.

import assert from "node:assert/strict";
import { test } from "node:test";
import { drawn, frequencies, open, pageTest, paste } from "./support.mjs";

pageTest("the first chart, the table and the sliders need the small module alone", {}, async (page) => {
  let release;
  const held = new Promise((resolve) => (release = resolve));
  const asked = [];
  await page.route("**/*_bg.wasm", async (route) => {
    asked.push(/(\w+)_bg\.wasm$/.exec(route.request().url())[1]);
    if (asked.at(-1) === "bladefan_wasm") await held;
    await route.continue();
  });
  await page.reload();
  await drawn(page);
  assert.equal(asked[0], "bladefan_first");
  const before = await frequencies(page);
  await page.locator("#what-if-factors-flap_stiffness").fill("0.3");
  await page.waitForFunction((old) => document.querySelectorAll("#modes tbody tr")[1].cells[1].dataset.full !== old, String(before["2F"]));
  assert.equal(await page.locator("#motion svg.shape-plot").count(), 0, "the moving mode waits for the whole");
  release();
  await page.locator("#motion svg.shape-plot").waitFor();
  assert.deepEqual(asked, ["bladefan_first", "bladefan_wasm"]);
});

pageTest("both modules give the same, and the library is what the whole reads", {}, async (page) => {
  const compared = await page.evaluate(async () => {
    const [first, whole] = await Promise.all(["first", "wasm"].map((name) => import(`./pkg/bladefan_${name}.js`)));
    await Promise.all([first.default(), whole.default()]);
    const { about, blades: library } = await import("./pkg/library.js");
    const same = (a, b) => JSON.stringify(a) === JSON.stringify(b);
    const faults = [];
    if (!same(whole.about().value, about)) faults.push("about");
    const built = whole.built_in_blades().value;
    if (built.length !== library.length) faults.push("number of blades");
    for (const [i, { blade, ...rest }] of library.entries()) {
      if (!same(built[i], rest) || !same(whole.parse_blade(rest.toml).value, blade)) faults.push(`library: ${rest.name}`);
      for (const [name, ...args] of [["modes", {}], ["modes", { basis: "classical" }], ["fan", {}]]) {
        if (!same(first[name](blade, ...args), whole[name](blade, ...args))) faults.push(`${name}: ${rest.name}`);
      }
      if (!same(first.chart_svg("fan", blade, { width: 700 }), whole.chart_svg("fan", blade, { width: 700 }))) faults.push(`chart_svg: ${rest.name}`);
    }
    const refused = [first.chart_svg("shapes", library[0].blade), first.chart_svg("fan", library[0].blade, { measured: "x" })];
    return { blades: library.length, faults, refused: refused.map(({ status }) => status) };
  });
  assert.ok(compared.blades >= 5);
  assert.deepEqual(compared.faults, []);
  // What the small module does not know it says, it does not draw something else.
  assert.deepEqual(compared.refused, ["error", "error"]);
});

pageTest("a whole module that does not come is said, and asked for again", {}, async (page) => {
  let gone = true;
  await page.route("**/bladefan_wasm_bg.wasm", (route) => (gone ? route.abort() : route.continue()));
  await page.reload();
  await page.locator("#modes tbody tr").first().waitFor();
  await page.locator("#tab-converge").click();
  await page.locator("#solve-faults:not(:empty)").waitFor();
  gone = false;
  await page.locator("#tab-fan").click();
  await page.locator("#tab-converge").click();
  await page.locator("#chart [data-family]").first().waitFor({ state: "attached" });
});

pageTest("what is opened while a file is being read stays, and keeps its name", {}, async (page) => {
  // An own blade is kept as its text, then brought back over a connection on which the whole module takes its time.
  await page.locator("#tab-text").click();
  await page.waitForFunction(() => document.getElementById("blade-text").value.includes("TM 4760"));
  await paste(page, `# mine\n${await page.locator("#blade-text").inputValue()}`);
  await page.waitForFunction(() => Object.keys(localStorage).some((key) => localStorage.getItem(key).includes("# mine")));
  await page.locator("#tab-fan").click();
  await page.waitForTimeout(600);
  const kept = () => page.evaluate(() => JSON.stringify(Object.entries(localStorage)));
  let release;
  const held = new Promise((resolve) => (release = resolve));
  await page.route("**/bladefan_wasm_bg.wasm", async (route) => {
    await held;
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
  assert.equal(await page.evaluate(() => Object.values(localStorage).map((text) => JSON.parse(text)).flat().filter((entry) => entry?.content).length), 2);
});

test("a library that does not come is said", async () => {
  const { page, close } = await open();
  try {
    await page.route("**/pkg/library.js", (route) => route.abort());
    await page.reload();
    await page.locator("#solve-faults", { hasText: "could not be loaded" }).waitFor();
  } finally {
    await close(); // what the browser tells of the request that failed is no complaint here
  }
});
