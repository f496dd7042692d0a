// The blade as fields: form, units, history, what-if, text.

import assert from "node:assert/strict";
import { test } from "node:test";
import { setAt, valueAt } from "../../web/blade/document.js";
import { fieldValue } from "../../web/lib/format.js";
import { NEUTRAL, points, scaled } from "../../web/lib/scale.js";
import { call, frequencies, pageTest, paste } from "./support.mjs";

const field = (page, path) => page.locator(`[data-path="${path}"]`);
/** The first flap frequency of the table, once it differs from `old`. */
async function changed(page, label, old) {
  await page.waitForFunction(
    ([label, old]) => [...document.querySelectorAll("#modes tbody tr")].some((row) => row.cells[0].textContent === label && Number(row.cells[1].dataset.full) !== old),
    [label, old],
  );
  return (await frequencies(page))[label];
}

test("paths lead to values, and values are read as they are typed", () => {
  const doc = { distribution: { mass: [1, 2, 3] } };
  assert.equal(valueAt(doc, "distribution.mass[1]"), 2);
  assert.equal(valueAt(doc, "rotor.radius"), undefined);
  setAt(doc, "rotor.radius", 5);
  setAt(doc, "distribution.mass[1]", undefined);
  // eslint-disable-next-line no-sparse-arrays -- a station without a value has none, not undefined
  assert.deepEqual(doc, { distribution: { mass: [1, , 3] }, rotor: { radius: 5 } });
  assert.deepEqual(["12", " 1,5 ", "0,125", "1,234", "−3e2", "1 000", "", "abc", "1e999"].map(fieldValue), [12, 1.5, 0.125, "1,234", -300, 1000, undefined, "abc", "1e999"]);
});

test("a part of the span is scaled with a step at either end", () => {
  const doc = { rotor: { radius: 10 }, distribution: { r: [0, 5, 5, 10], mass: [2, 2, 1, 3], flap_stiffness: 7 } };
  const whatIf = { ...NEUTRAL, factors: { ...NEUTRAL.factors, mass: 2, flap_stiffness: 3 }, from: 5, to: 7.5 };
  const { distribution } = scaled(doc, whatIf);
  assert.deepEqual(distribution.mass, { r: [0, 5, 7.5, 7.5, 10], values: [2, 2, 4, 2, 3] });
  assert.deepEqual(distribution.flap_stiffness, { r: [0, 5, 5, 7.5, 7.5, 10], values: [7, 7, 21, 21, 7, 7] });
  assert.deepEqual(scaled(doc, { ...whatIf, from: null, to: null }).distribution.mass, [4, 4, 2, 6]);
  assert.equal(scaled(doc, NEUTRAL), doc);
  assert.deepEqual(points(doc, "flap_stiffness"), { r: [0, 10], values: [7, 7] });
});

pageTest("a number in the form is solved, undone and redone", {}, async (page) => {
  const before = (await frequencies(page))["1F"];
  await field(page, "flap.offset").fill("5.5");
  await page.locator("#blade-faults li, #modes").first().waitFor();
  // The stations begin at 3 in, so the hinge may move outward.
  const after = await changed(page, "1F", before);
  assert.ok(after > before, "more offset, more stiffness by rotation");
  await page.locator("#undo").click();
  assert.equal(await changed(page, "1F", after), before);
  assert.equal(await field(page, "flap.offset").inputValue(), "3");
  await page.keyboard.press("Control+y");
  assert.equal(await changed(page, "1F", before), after);
});

pageTest("a fault stands at its field, and the last good chart stays", {}, async (page) => {
  await field(page, "rotor.radius").fill("-1");
  await page.locator('[data-fault-of="rotor.radius"]').waitFor();
  assert.match(await page.locator('[data-fault-of="rotor.radius"]').textContent(), /greater than 0/);
  assert.equal(await field(page, "rotor.radius").getAttribute("aria-invalid"), "true");
  assert.equal(await page.locator("#last-good").isVisible(), true);
  assert.match(await page.locator("#chart > svg").first().getAttribute("aria-label"), /^Fan chart of TM 4760/);
  await field(page, "rotor.radius").fill("a lot");
  await page.locator('[data-fault-of="rotor.radius"]', { hasText: "a lot" }).waitFor();
  await field(page, "rotor.radius").fill("55");
  await page.locator("#last-good").waitFor({ state: "hidden" });
  assert.equal(await page.locator(".field-fault:visible").count(), 0);
});

pageTest("another root takes its spring along, and an offset is a length or a share of the radius", {}, async (page) => {
  const before = (await frequencies(page))["1F"];
  assert.equal(await field(page, "flap.spring").isVisible(), false);
  await field(page, "flap.root").selectOption("spring-hinged");
  await field(page, "flap.spring").waitFor();
  await field(page, "flap.spring").fill("20000");
  const sprung = await changed(page, "1F", before);
  assert.ok(sprung > before);
  await field(page, "flap.root").selectOption("hingeless");
  assert.ok((await changed(page, "1F", sprung)) > before);
  assert.equal(await field(page, "flap.spring").isVisible(), false);
  await page.locator('[data-offset-of="flap"]').selectOption("offset_ratio");
  assert.equal(Number(await field(page, "flap.offset_ratio").inputValue()), Number((3 / 55).toPrecision(15)));
  await page.locator('[data-offset-of="flap"]').selectOption("offset");
  assert.equal(await field(page, "flap.offset").inputValue(), "3");
});

pageTest("units are converted, not reinterpreted, there and back", {}, async (page) => {
  const before = await frequencies(page);
  await page.locator("#units").selectOption({ label: "SI (m, kg, N)" });
  await page.waitForFunction(() => document.querySelector('[data-path="rotor.radius"]').value === "1.397");
  const si = await frequencies(page);
  for (const [label, value] of Object.entries(before)) assert.ok(Math.abs(si[label] / value - 1) < 1e-12, label);
  await page.locator("#nominal-unit").selectOption("Hz");
  await page.waitForFunction(() => document.querySelector('[data-path="rotor.nominal_speed"]').value === "11");
  await page.locator("#units").selectOption({ label: "in, lb, lbf" });
  await page.waitForFunction(() => document.querySelector('[data-path="rotor.radius"]').value === "55");
  assert.equal(await field(page, "lag.spring").inputValue(), "464");
});

pageTest("what-if sliders move the chart beside the blade as it is, and are kept or reset", {}, async (page) => {
  const before = await frequencies(page);
  const slider = page.locator("#what-if-factors-torsion_stiffness");
  await slider.fill("1");
  const stiffer = await changed(page, "1T", before["1T"]);
  // But for the centrifugal share, which is small here.
  assert.ok(Math.abs(stiffer / before["1T"] - Math.SQRT2) < 1e-3, `twice the stiffness: ${stiffer / before["1T"]}`);
  await page.locator("#what-if-reset").click();
  assert.equal(await changed(page, "1T", stiffer), before["1T"]);
  await slider.fill("1");
  await changed(page, "1T", before["1T"]);
  await page.locator("#what-if-keep").click();
  await page.locator("#what-if-keep:disabled").waitFor();
  assert.ok(Math.abs((await frequencies(page))["1T"] / stiffer - 1) < 1e-12, "kept in the blade");
  await page.locator("#undo").click();
  assert.equal(await changed(page, "1T", stiffer), before["1T"]);
  // A part of the span alone.
  await page.locator("#what-if-from").selectOption("28.25");
  await page.locator("#what-if-factors-mass").fill("0.5");
  assert.ok((await changed(page, "2F", before["2F"])) !== before["2F"]);
  assert.equal(await page.locator("#solve-faults li, #blade-faults li").count(), 0);
});

pageTest("the text follows the fields, and the fields the text", {}, async (page) => {
  await field(page, "rotor.blades").fill("4");
  await page.locator("#tab-text").click();
  await page.waitForFunction(() => /blades = 4/.test(document.getElementById("blade-text").value));
  const text = await page.locator("#blade-text").inputValue();
  const { value } = await call(page, "parse_blade", text);
  assert.equal(value.rotor.blades, 4);
  await paste(page, text.replace("blades = 4", "blades = 5"));
  await page.waitForFunction(() => document.querySelector('[data-path="rotor.blades"]').value === "5");
  await field(page, "rotor.radius").fill("-55");
  await page.waitForFunction(() => document.getElementById("blade-text").value.includes('"radius": -55'));
});

pageTest("a blade is built from nothing but the form and the text", {}, async (page) => {
  await paste(page, '[rotor]\nradius = 2\nnominal_speed = 40\n');
  await page.locator("#faults li").first().waitFor();
  assert.ok((await page.locator("#faults li").count()) >= 4);
  assert.equal(await page.locator("#last-good").isVisible(), true);
});
