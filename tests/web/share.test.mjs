// Blades that leave the page and come back: link, memory, files, no network.

import assert from "node:assert/strict";
import { test } from "node:test";
import { pack, unpack } from "../../web/app/pack.js";
import { NEUTRAL } from "../../web/lib/scale.js";
import { drawn, frequencies, open, pageTest } from "./support.mjs";

const state = {
  doc: { schema: "bladefan-blade/1", rotor: { radius: 2 } }, text: null, choice: "", tab: "shapes", speed: { value: 300, unit: "rpm" }, speedUnit: "rpm",
  frequencyUnit: "Hz", dofs: ["flap"], closeDofs: ["lag"], band: [0.8, 1.2], window: null, chosen: "2F", options: { modes: "4" }, measured: "a,b", whatIf: NEUTRAL,
};
const UNIFORM = `schema = "bladefan-blade/1"
name = "uniform, sent"
rotor = { radius = 1, nominal_speed = 1 }
flap = { root = "hingeless" }
lag = { root = "hingeless" }
torsion = { root = "rigid" }
distribution = { mass = 1, flap_stiffness = 1, lag_stiffness = 1, torsion_stiffness = 1, polar_inertia = 1 }
`;
const words = async (packed) => unpack(packed).then(() => "read", (error) => error.message);

test("what is packed is unpacked", async () => {
  const { blade, choice, view } = await unpack(await pack(state));
  assert.deepEqual(JSON.parse(blade), state.doc);
  assert.equal(choice, "");
  const { doc, text, choice: _, ...rest } = state;
  assert.deepEqual(view, rest);
  assert.equal((await unpack(await pack({ ...state, text: "# mine" }))).blade, "# mine");
});

test("what is broken or hostile is refused in words", async () => {
  const good = await pack(state);
  assert.equal(await words(good), "read");
  for (const bad of ["", "1", "1.", good.slice(0, -8), good.replace("1.", "x."), `${good}%`, "1.AAAA", "1.<script>"]) {
    assert.equal(await words(bad), "it is cut off or changed", bad);
  }
  assert.equal(await words(good.replace("1.", "2.")), "it was made by another version of this page");
  assert.equal(await words(`1.${"A".repeat(500_000)}`), "it is longer than a blade can be");
  const bomb = await pack({ ...state, text: "0".repeat(50_000_000) });
  assert.equal(await words(bomb), "it unpacks to more than a blade can hold");
  // Views that break their rules are left out, one by one.
  const odd = { tab: "nowhere", closeDofs: ["flap", "flap"], speed: { value: -1, unit: "rpm" }, dofs: [], band: "wide", options: { modes: 4 }, whatIf: { factors: { mass: -2 } }, window: { speeds: ["a"] } };
  assert.deepEqual(Object.keys((await unpack(await pack({ ...state, ...odd }))).view).sort(), ["chosen", "frequencyUnit", "measured", "speedUnit"]);
});

test("a link carries blade and view to another browser", async () => {
  const first = await open();
  let link, expected;
  try {
    const { page } = first;
    await page.locator('[data-path="lag.spring"]').fill("1000");
    await page.locator("#what-if-factors-flap_stiffness").fill("0.5");
    await page.locator("#speed-number").fill("500");
    await page.locator("#frequency-unit").selectOption("Hz");
    await page.locator("#option-modes").fill("3");
    await page.locator("#numbers-title", { hasText: "500 rpm" }).waitFor();
    await page.waitForFunction(() => document.querySelectorAll("#modes tbody tr").length === 9);
    await page.locator("#share").click();
    await page.locator("#message", { hasText: "link" }).waitFor();
    link = page.url();
    expected = await frequencies(page);
    assert.deepEqual(first.complaints, []);
  } finally {
    await first.close();
  }
  assert.ok(link.length < 4000, `${link.length} letters`);
  const second = await open({ fragment: new URL(link).hash });
  try {
    const { page } = second;
    await page.locator("#numbers-title", { hasText: "500 rpm" }).waitFor();
    await page.waitForFunction(() => document.querySelectorAll("#modes tbody tr").length === 9);
    assert.deepEqual(await frequencies(page), expected);
    assert.equal(await page.locator('[data-path="lag.spring"]').inputValue(), "1000");
    assert.equal(await page.locator("#frequency-unit").inputValue(), "Hz");
    assert.equal(await page.locator("#option-modes").inputValue(), "3");
    assert.equal(await page.locator("#what-if-factors-flap_stiffness").inputValue(), "0.5");
    assert.deepEqual(second.complaints, []);
  } finally {
    await second.close();
  }
});

const sent = await pack({ ...state, doc: null, text: UNIFORM, measured: "", chosen: "1F" });
pageTest("a link opened again is kept once", { fragment: `#${sent}` }, async (page) => {
  for (let i = 0; i < 3; i++) {
    await page.waitForFunction(() => JSON.parse(localStorage.getItem("bladefan-blades") ?? "[]").length === 1);
    await page.reload();
    await drawn(page);
    await page.waitForTimeout(800);
  }
  assert.equal(await page.evaluate(() => JSON.parse(localStorage.getItem("bladefan-blades")).length), 1);
});

for (const fragment of ["#nonsense", "#1.AAAA", "#%", "#1.%3Cscript%3E"]) {
  pageTest(`a broken link gives a message and the page as it would be: ${fragment}`, { fragment }, async (page) => {
    await page.locator("#message", { hasText: "The link cannot be read" }).waitFor();
    assert.equal(await page.locator("#blade-choice").inputValue(), "tm4760");
  });
}

pageTest("an own blade is back at the next visit, with a way to the built-in ones", {}, async (page) => {
  await page.locator('[data-path="name"]').fill("my blade");
  await page.locator('[data-path="rotor.nominal_speed"]').fill("700");
  await page.locator("#numbers-title", { hasText: "700 rpm" }).waitFor();
  await page.waitForFunction(() => localStorage.getItem("bladefan-blades")?.includes("my blade"));
  await page.waitForTimeout(600);
  await page.reload();
  await drawn(page);
  await page.locator("#message", { hasText: "Your blade is back" }).waitFor();
  await page.locator("#numbers-title", { hasText: "700 rpm" }).waitFor();
  assert.equal(await page.locator('[data-path="name"]').inputValue(), "my blade");

  await page.locator("#blade-choice").selectOption("sa330");
  await page.waitForFunction(() => document.querySelector('[data-path="name"]').value.includes("SA 330"));
  const kept = page.locator("#blade-choice optgroup option", { hasText: "my blade" });
  await page.locator("#blade-choice").selectOption(await kept.getAttribute("value"));
  await page.locator("#numbers-title", { hasText: "700 rpm" }).waitFor();

  await page.locator("#download summary").click();
  await page.locator("#forget").click();
  await page.locator("#message", { hasText: "forgotten" }).waitFor();
  assert.equal(await page.evaluate(() => localStorage.getItem("bladefan-blades")), null);
});

pageTest("a kept blade that is broken does no harm", {}, async (page) => {
  for (const broken of ["{", "7", '[{"id":"a","packed":"1.x","name":"b","time":1}]', '[{"id":1}]']) {
    await page.evaluate((broken) => localStorage.setItem("bladefan-blades", broken), broken);
    await page.reload();
    await drawn(page);
    assert.equal(await page.locator("#blade-choice").inputValue(), "tm4760", broken);
  }
});

pageTest("a file of 10 MB is refused, and nothing is lost", {}, async (page) => {
  const before = await frequencies(page);
  await page.locator("#file-input").setInputFiles({ name: "huge.toml", mimeType: "", buffer: Buffer.alloc(10_000_000, "#") });
  await page.locator("#message", { hasText: "huge.toml has 10 MB" }).waitFor();
  assert.deepEqual(await frequencies(page), before);
});
