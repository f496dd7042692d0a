// The blade as fields: form, units, history, what-if, text.

import assert from "node:assert/strict";
import { test } from "node:test";
import { setAt, valueAt } from "../../web/blade/document.js";
import { fieldValue } from "../../web/lib/format.js";
import { NEUTRAL, changesOf, lengthsOf, withLengths } from "../../web/lib/what-if.js";
import { call, frequencies, pageTest, paste } from "./support.mjs";

const field = (page, path) => page.locator(`[data-path="${path}"]`);
/** The first flap frequency of the table, once it differs from `old`. */
async function changed(page, label, old) {
  await page.waitForFunction(
    ([label, old]) =>
      [...document.querySelectorAll("#modes tbody tr")].some(
        (row) => row.cells[0].textContent === label && Number(row.cells[1].dataset.full) !== old,
      ),
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
  assert.deepEqual(["12", " 1,5 ", "0,125", "1,234", "−3e2", "1 000", "", "abc", "1e999"].map(fieldValue), [
    12,
    1.5,
    0.125,
    "1,234",
    -300,
    1000,
    undefined,
    "abc",
    "1e999",
  ]);
});

test("what-if is a list of changes with the unit of their lengths", () => {
  const whatIf = {
    ...NEUTRAL,
    factors: { ...NEUTRAL.factors, mass: 2 },
    from: 5,
    to: 7.5,
    offsets: { flap: 4 },
    springs: { lag: 1, flap: 3 },
    length: "in",
  };
  const units = { length: "in" };
  assert.deepEqual(changesOf(whatIf), [
    { what: "distribution.mass", scale: 2, from: 5, to: 7.5, units },
    { what: "flap.offset", set: 4, units },
    { what: "flap.spring", scale: 3 },
  ]);
  assert.deepEqual(changesOf(NEUTRAL), []);
  assert.deepEqual(lengthsOf(whatIf), [5, 7.5, 4]);
  const other = withLengths(whatIf, [127, 190.5, 101.6], "mm");
  assert.deepEqual([other.from, other.to, other.offsets, other.length, other.factors], [127, 190.5, { flap: 101.6 }, "mm", whatIf.factors]);
  assert.deepEqual(withLengths({ ...whatIf, from: null }, [7, 4], "m"), { ...whatIf, from: null, to: 7, offsets: { flap: 4 }, length: "m" });
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

pageTest("what-if sliders move the chart beside the blade as it is, and are kept or reset", { model: "uncoupled" }, async (page) => {
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

pageTest("mass scaled by what-if takes the polar inertia along, and the page says so", { model: "uncoupled" }, async (page) => {
  const before = await frequencies(page);
  await page.locator("#what-if .slider", { hasText: "Mass and polar inertia" }).locator('input[type="range"]').fill("2");
  const heavy = await changed(page, "1T", before["1T"]);
  const { value } = await call(page, "built_in_blades");
  const blade = (await call(page, "parse_blade", value.find(({ name }) => name === "tm4760").toml)).value;
  const four = ({ r, values }) => ({ r, values: values.map((one) => 4 * one) });
  const { mass, polar_inertia: inertia } = blade.distribution;
  const times = (given) => (Array.isArray(given) ? given.map((one) => 4 * one) : typeof given === "number" ? 4 * given : four(given));
  const changedBlade = { ...blade, distribution: { ...blade.distribution, mass: times(mass), polar_inertia: times(inertia) } };
  const expected = await call(page, "modes", changedBlade, { model: "uncoupled" });
  assert.equal(heavy, expected.value.modes.find(({ label }) => label === "1T").frequency_rad_s);
});

pageTest("what-if keeps its lengths when the units are switched, there and back", { model: "uncoupled" }, async (page) => {
  const before = await frequencies(page);
  const offset = page.locator('[data-key="offsets.flap"] input[type="text"]');
  await page.locator("#what-if-from").selectOption("28.25");
  await page.locator("#what-if-factors-flap_stiffness").fill("1");
  await changed(page, "1F", before["1F"]);
  await offset.fill("4");
  await offset.blur();
  const stretched = await page
    .waitForFunction(() => document.querySelector('[data-key="offsets.flap"] input[type="text"]').value === "4")
    .then(() => page.waitForTimeout(400))
    .then(() => frequencies(page));
  for (const [units, radius, shown, from] of [
    ["mm, kg, N", "1397", "101.6", 717.55],
    ["ft, slug, lbf", null, "0.3333", 28.25 / 12],
    ["in, lb, lbf", "55", "4", 28.25],
  ]) {
    await page.locator("#units").selectOption({ label: units });
    if (radius) await page.waitForFunction((radius) => document.querySelector('[data-path="rotor.radius"]').value === radius, radius);
    await page.waitForFunction((shown) => document.querySelector('[data-key="offsets.flap"] input[type="text"]').value === shown, shown);
    assert.ok(Math.abs(Number(await page.locator("#what-if-from").inputValue()) / from - 1) < 1e-12, units);
    await page.waitForTimeout(400);
    const now = await frequencies(page);
    for (const [label, value] of Object.entries(stretched))
      assert.ok(Math.abs(now[label] / value - 1) < 1e-9, `${units} ${label}: ${now[label]} for ${value}`);
  }
  // Undone, the blade is in millimetres again, and the changes follow.
  await page.locator("#units").selectOption({ label: "mm, kg, N" });
  await page.waitForFunction(() => document.querySelector('[data-key="offsets.flap"] input[type="text"]').value === "101.6");
  await page.locator("#undo").click();
  await page.waitForFunction(() => document.querySelector('[data-key="offsets.flap"] input[type="text"]').value === "4");
  await page.locator("#what-if-keep").click();
  await page.locator("#what-if-keep:disabled").waitFor();
  assert.equal(await field(page, "flap.offset").inputValue(), "4");
  assert.equal(await page.locator("#solve-faults li, #blade-faults li").count(), 0);
});

pageTest("another blade typed over the text begins without what-if", { model: "uncoupled" }, async (page) => {
  const before = await frequencies(page);
  await page.locator("#what-if-factors-flap_stiffness").fill("1");
  await changed(page, "1F", before["1F"]);
  const { value } = await call(page, "built_in_blades");
  const { toml } = value.find(({ name }) => name === "bo105");
  await paste(page, toml);
  await page.locator("#message", { hasText: "“What if” is set back" }).waitFor();
  const alone = (await call(page, "modes", (await call(page, "parse_blade", toml)).value, { model: "uncoupled" })).value;
  await page.waitForFunction(
    (last) => Number(document.querySelector("#modes tbody td[data-full]").dataset.full) === last,
    alone.modes[0].frequency_rad_s,
  );
  assert.equal(await page.locator("#what-if-factors-flap_stiffness").inputValue(), "0");
  // Back in the history stands the other blade, which has none either.
  await page.locator("#what-if-factors-flap_stiffness").fill("1");
  await page.locator("#undo").click();
  await page.waitForFunction((last) => Number(document.querySelector("#modes tbody td[data-full]").dataset.full) === last, before["1F"]);
});

const FOREIGN = "these are\nnot the words of a blade";
for (const tab of ["fan", "shapes", "converge", "stations", "text"]) {
  pageTest(`a foreign file opened from ${tab} stands in the text with its faults`, {}, async (page) => {
    await page.locator(`#tab-${tab}`).click();
    await page.waitForTimeout(200);
    await page.locator("#file-input").setInputFiles({ name: "foreign.txt", mimeType: "", buffer: Buffer.from(FOREIGN) });
    await page.locator("#faults li").first().waitFor();
    await page.locator("#message", { hasText: "This is no blade yet" }).waitFor();
    await page.waitForTimeout(400);
    assert.equal(await page.locator("#blade-text").inputValue(), FOREIGN);
    assert.equal(await page.locator("#tab-text").getAttribute("aria-selected"), "true");
    assert.match(await page.locator("#fault-summary").textContent(), /^\d+ faults?; first at line 1/);
    assert.ok((await page.locator(".marks .mark").count()) > 0);
    // It waits there while one looks elsewhere, and there is a way back.
    await page.locator("#tab-fan").click();
    await page.locator("#tab-text").click();
    assert.equal(await page.locator("#blade-text").inputValue(), FOREIGN);
    await page.locator("#drop-draft button").click();
    await page.waitForFunction(() => document.getElementById("blade-text").value.includes("TM 4760"));
    assert.equal(await page.locator("#faults li").count(), 0);
    assert.equal(await page.locator("#last-good").isVisible(), false);
  });
}

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
  await paste(page, "[rotor]\nradius = 2\nnominal_speed = 40\n");
  await page.locator("#faults li").first().waitFor();
  assert.ok((await page.locator("#faults li").count()) >= 4);
  assert.equal(await page.locator("#last-good").isVisible(), true);
});
