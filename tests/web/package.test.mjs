// The package's two modules: the first view needs the small one alone, and both give the same.

import assert from "node:assert/strict";
import { frequencies, pageTest } from "./support.mjs";

const wasmOf = (requests) => [...new Set(requests.map((url) => /(\w+)_bg\.wasm$/.exec(url)?.[1]).filter(Boolean))];

pageTest("the first view and the sliders load the small module alone, a convergence chart the whole", {}, async (page) => {
  const requests = [];
  page.on("request", (request) => requests.push(request.url()));
  await page.reload();
  await page.locator("#modes tbody tr").first().waitFor();
  await page.locator("#motion svg").first().waitFor();
  const before = await frequencies(page);
  await page.locator("#what-if-factors-flap_stiffness").fill("0.3");
  while ((await frequencies(page))["2F"] === before["2F"]) await page.waitForTimeout(20);
  assert.deepEqual(wasmOf(requests), ["bladefan_first"]);
  await page.locator("#tab-converge").click();
  await page.locator("#chart [data-family]").first().waitFor({ state: "attached" });
  assert.deepEqual(wasmOf(requests), ["bladefan_first", "bladefan_wasm"]);
});

pageTest("both modules give the same, and the library is what the whole reads", {}, async (page) => {
  const compared = await page.evaluate(async () => {
    const [first, whole] = await Promise.all(["first", "wasm"].map((name) => import(`./pkg/bladefan_${name}.js`)));
    await Promise.all([first.default(), whole.default()]);
    const { about, library } = await import("./pkg/library.js");
    const same = (a, b) => JSON.stringify(a) === JSON.stringify(b);
    const faults = [];
    if (!same(whole.about().value, about)) faults.push("about");
    const built = whole.built_in_blades().value;
    if (built.length !== library.length) faults.push("number of blades");
    for (const [i, { blade, ...rest }] of library.entries()) {
      if (!same(built[i], rest) || !same(whole.parse_blade(rest.toml).value, blade)) faults.push(`library: ${rest.name}`);
      for (const [name, ...args] of [["modes", {}], ["modes", { basis: "classical" }], ["fan", {}], ["shapes", { points: 21 }]]) {
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
