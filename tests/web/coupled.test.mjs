// The page with the coupled model: what is said and shown of modes that move in flap, lag and torsion at once.

import assert from "node:assert/strict";
import { test } from "node:test";
import { checked } from "../../web/app/pack.js";
import { boundsWords, figures, frequencyWords, sharesWords } from "../../web/lib/format.js";
import { labelAt, modeOf, motionsOf, nameOf } from "../../web/lib/labels.js";
import { sameMode } from "../../web/modes/movers.js";
import { chordAt } from "../../web/modes/plate.js";
import { leadingOf, motionsDrawn } from "../../web/modes/shape.js";
import { modeWords, paceWords } from "../../web/modes/words.js";
import { fanCsv, shapesCsv } from "../../web/out/download.js";
import { call, pageTest, rows } from "./support.mjs";

/** What no page may show. */
const NO_VALUE = /NaN|undefined|Infinity|\bnull\b/;

async function blade(page, name) {
  const { value } = await call(page, "built_in_blades");
  return (await call(page, "parse_blade", value.find((built) => built.name === name).toml)).value;
}
async function opened(page, name, title) {
  await page.locator("#blade-choice").selectOption(name);
  await page.locator(`#chart > svg[aria-label^="Fan chart of ${title}"]`).waitFor();
  await page.waitForFunction((title) => document.title.startsWith(title), title);
  return blade(page, name);
}
const solved = (page, kind) => page.locator("#model", { hasText: `${kind}, in vacuum` }).waitFor();

test("a mode is named without its second motion, and a branch by its rotor speed", () => {
  assert.equal(nameOf({ label: "1T/F" }), "1T");
  assert.deepEqual(motionsOf("12L/T"), ["lag", "torsion"]);
  assert.deepEqual(motionsOf("?"), []);
  const branch = {
    label: "3F",
    labels: [
      { from_rad_s: 0, label: "1T" },
      { from_rad_s: 5, label: "1T/F" },
      { from_rad_s: 6, label: "3F" },
    ],
  };
  assert.deepEqual([0, 4.9, 5, 9].map((speed) => labelAt(branch, speed)), ["1T", "1T", "1T/F", "3F"]); // prettier-ignore
  assert.equal(labelAt({ label: "2F" }, 3), "2F");
  const modes = ["1F", "1T/F", "2F", "3F"].map((label) => ({ label, dof: motionsOf(label)[0] }));
  assert.equal(modeOf(modes, "1T").label, "1T/F");
  assert.equal(modeOf(modes, "5F").label, "3F", "the highest that there is");
  assert.equal(modeOf(modes, "1L").label, "1F");
  assert.equal(modeOf([], "1F"), null);
});

test("bounds that are missing, shares and unstable modes are said in words", () => {
  const mode = { frequency_rad_s: 10, lower_rad_s: null, upper_rad_s: null, bounds_missing: "separation not proven", error_estimate_rad_s: 1.2e-5 };
  assert.equal(boundsWords(mode, " rad/s"), "separation not proven (about 2·10⁻⁵ rad/s)");
  assert.equal(boundsWords({ ...mode, error_estimate_rad_s: null }), "separation not proven");
  assert.equal(sharesWords({ flap: 0.264, lag: -4e-9, torsion: 0.736 }), "flap 26 %, lag 0 %, torsion 74 %");
  assert.equal(frequencyWords({ unstable: true, frequency_rad_s: null }), "unstable");
  assert.deepEqual([null, NaN, undefined].map(figures), ["–", "–", "–"]);
  const unstable = { unstable: true, eigenvalue_s2: -5.2446, frequency_rad_s: null, frequency_hz: null, per_rev: null, classical_rad_s: null };
  const words = modeWords({ ...unstable, lower_rad_s: null, upper_rad_s: null, shares: { flap: 0, lag: 0, torsion: 1 } }, 15);
  assert.equal(words, "unstable, ω² = −5.245 1/s²; energy flap 0 %, lag 0 %, torsion 100 %");
  assert.match(paceWords(unstable, { mode: 0, slower: 1, held: false }, false), /unstable/);
});

test("each motion is drawn by its energy beside the one that leads", () => {
  const bending = (displacement) => ({ displacement, moment: [1, 2] });
  const components = { flap: bending([0, -3]), lag: bending([0, 0]), torsion: { twist: [0, 0.5], moment: [4, 5] } };
  const shape = { dof: "torsion", shares: { flap: 0.2, lag: 0, torsion: 0.8 }, components };
  assert.deepEqual(motionsDrawn(shape), { flap: [0, -0.5], lag: [0, 0], torsion: [0, 1] });
  assert.deepEqual(leadingOf(shape), { displacement: [0, 0.5], moment: [4, 5] });
  assert.deepEqual(motionsDrawn({ dof: "lag", displacement: [0, 4] }), { lag: [0, 1] });
  const [lead] = chordAt("torsion", 1, { flap: -0.5, torsion: 1 });
  const [alone] = chordAt("torsion", 1, { torsion: 1 });
  assert.ok(lead[2] < alone[2] && lead[1] === alone[1], "both at once");
});

test("a mode is found again in a blade that is a little different", () => {
  const modes = [
    { label: "1F", frequency_rad_s: 10, per_rev: 1 },
    { label: "2F/T", frequency_rad_s: 20, per_rev: 2 },
    { label: "9T", frequency_rad_s: null, per_rev: null },
  ];
  assert.equal(sameMode(modes, { label: "2F", frequency_rad_s: 11 }).label, "2F/T");
  assert.equal(sameMode(modes, { label: "1T/F", frequency_rad_s: 11 }).label, "1F", "else the next one");
  assert.equal(sameMode([], { label: "1F", frequency_rad_s: 10 }), null);
});

test("CSV leaves out what is unstable, and has every motion of a coupled shape", () => {
  assert.equal(fanCsv({ speeds_rad_s: [0, 1], branches: [{ label: "1T", frequency_rad_s: [2, NaN] }] }), "rotor speed [rad/s],1T [rad/s]\n0,2\n1,\n");
  const bending = (n) => ({ displacement: [n], slope: [n + 1], moment: [n + 2], force: [n + 3] });
  const shape = { label: "1T/F", components: { flap: bending(1), lag: bending(5), torsion: { twist: [9], moment: [10] } } };
  const [header, row] = shapesCsv({ model: { kind: "coupled" }, r_m: [0], shapes: [shape] }).split("\n");
  assert.equal(header.split(",").length, 11);
  assert.match(header, /^r \[m\],1T\/F flap,1T\/F flap slope \[1\/m\],.*1T\/F torsion \[rad\],1T\/F torsion moment \[N·m\]$/);
  assert.equal(row, "0,1,2,3,4,5,6,7,8,9,10");
});

test("a view without a model is of the time before there were two", () => {
  const view = (given) => checked({ blade: {}, view: given }).view;
  assert.equal(view({}).model, "auto");
  assert.equal(view({ model: "coupled" }).model, "coupled");
  assert.equal(view({ model: "other" }).model, "auto");
  assert.equal(view({ options: { modes: "5", harmonics: "8" } }).options.modes, undefined);
  assert.equal(view({ options: { modes: "7" } }).options.modes, "7");
  assert.equal(view({ model: "auto", options: { modes: "5" } }).options.modes, "5");
});

pageTest("the table of a coupled blade has its modes, shares and bounds, and the model in words", {}, async (page) => {
  const uh60a = await opened(page, "uh60a", "UH-60A");
  const { value } = await call(page, "modes", uh60a);
  assert.equal(value.model.kind, "coupled");
  const shown = await rows(page);
  assert.deepEqual(
    shown.map(([label]) => label),
    value.modes.map(({ label }) => label),
  );
  assert.ok(value.modes.some(({ mixed }) => mixed));
  value.modes.forEach((mode, i) => {
    assert.equal(shown[i][1], figures(mode.frequency_rad_s));
    assert.equal(shown[i][4], boundsWords(mode));
  });
  const bars = await page.locator("#modes .shares").evaluateAll((all) => all.map((bar) => bar.getAttribute("aria-label")));
  assert.deepEqual(bars, value.modes.map(({ shares }) => sharesWords(shares))); // prettier-ignore
  assert.ok((await page.locator("#model").textContent()).endsWith(value.model.words));
  assert.equal(await page.locator("#modes-words").textContent(), "Modes in all");
  assert.equal(await page.locator("#option-modes").inputValue(), String(value.modes.length));

  // The degrees of freedom choose by leading motion.
  await page.locator("#show-flap").uncheck();
  await page.waitForFunction(() => document.querySelectorAll('#modes tbody tr[data-dof="flap"]:not([hidden])').length === 0);
  assert.equal(await page.locator("#modes tbody tr:visible").count(), value.modes.filter(({ dof }) => dof !== "flap").length);
});

pageTest("the model is chosen, solved everywhere, and kept in the link", {}, async (page) => {
  await page.locator("#model-choice").selectOption("uncoupled");
  await solved(page, "uncoupled");
  assert.equal(await page.locator("#modes tbody tr").count(), 15);
  assert.equal(await page.locator("#modes .shares").count(), 0);
  assert.equal(await page.locator("#shares-column").isHidden(), true);
  await page.locator("#chart > svg text", { hasText: "uncoupled, in vacuum" }).waitFor();
  assert.equal(await page.locator("#modes-words").textContent(), "Modes of each kind");
  await page.locator("#tab-shapes").click();
  await page.locator('#chart > svg[aria-label^="Mode shapes"] text', { hasText: "uncoupled" }).waitFor();
  await page.locator("#share").click();
  await page.waitForFunction(() => location.hash.length > 1);
  await page.reload();
  await solved(page, "uncoupled");
  assert.equal(await page.locator("#model-choice").inputValue(), "uncoupled");
  await page.locator("#model-choice").selectOption("coupled");
  await solved(page, "coupled");
  await page.locator('#chart > svg[aria-label^="Mode shapes"] text', { hasText: /^\s*coupled/ }).waitFor();
});

pageTest("a mixed mode moves in all its motions", { reducedMotion: "no-preference", viewport: { width: 1280, height: 1400 } }, async (page) => {
  const uh60a = await opened(page, "uh60a", "UH-60A");
  const { value } = await call(page, "modes", uh60a);
  const mode = value.modes.find(({ label }) => label.startsWith("1T/"));
  await page.locator('#modes tbody input[value="1T"]').evaluate((radio) => radio.click());
  await page.locator("#motion-title", { hasText: `Mode ${mode.label} at` }).waitFor();
  assert.match(await page.locator("#motion .stage").getAttribute("aria-label"), /^Mode 1T\/F, torsion and flap: the blade seen from the tip/);
  assert.match(await page.locator("#motion-moment").textContent(), /^torsional moment/);
  assert.ok((await page.locator("#motion-detail").textContent()).includes(sharesWords(mode.shares)));
  assert.equal(await page.locator('#motion .shape-plot .beside[data-dof="flap"]').count(), 1);
  const edge = () => page.locator("#motion .edge").getAttribute("d");
  const first = await edge();
  await page.waitForFunction((first) => document.querySelector("#motion .edge").getAttribute("d") !== first, first);
  assert.doesNotMatch(await edge(), NO_VALUE);

  await page.locator("#tab-converge").click();
  await page.locator("#lesson", { hasText: /^1T\/F with the paper’s 15 functions: 135/ }).waitFor();
});

pageTest("what moves a mixed mode is what the package says it does", {}, async (page) => {
  const uh60a = await opened(page, "uh60a", "UH-60A");
  const said = page.locator("#movers li", { hasText: "1T/F" });
  await said.waitFor();
  const words = await said.textContent();
  const [, slope] = /^Torsion stiffness \+1 % moves 1T\/F up by about ([\d.]+)\/rev; about −[\d.]+ % brings the margin to 0\.1\/rev\.$/.exec(words);
  const { value: stiffer } = await call(page, "change_blade", uh60a, [{ what: "distribution.torsion_stiffness", scale: 1.01 }]);
  const perRev = async (blade) => (await call(page, "modes", blade)).value.modes.find(({ label }) => label.startsWith("1T")).per_rev;
  assert.ok(Math.abs((await perRev(stiffer.blade)) - (await perRev(uh60a)) - slope) < 1e-3, words);
});

pageTest("along a branch the readout says what it is called there", {}, async (page) => {
  const uh60a = await opened(page, "uh60a", "UH-60A");
  const { value: fan } = await call(page, "fan", uh60a);
  const middle = (fan.speeds_rad_s[0] + fan.speeds_rad_s.at(-1)) / 2;
  const branch = fan.branches.find(({ labels }) => labels.length > 1);
  const said = page.locator("#chart-said");
  /** The label that is said after a key. */
  async function after(key) {
    const before = await said.textContent();
    await page.keyboard.press(key);
    await page.waitForFunction((before) => document.getElementById("chart-said").textContent !== before, before);
    return (await said.textContent()).split(" ")[0];
  }
  await page.locator("#chart").focus();
  for (let label = await after("ArrowRight"), i = 0; label !== labelAt(branch, middle); i++) {
    assert.ok(i < fan.branches.length, label);
    label = await after("ArrowUp");
  }
  const first = await after("Home");
  assert.equal(first, labelAt(branch, 0));
  assert.equal(await page.locator(".readout > div").first().textContent(), `${first} at 0 rpm`);
  const last = await after("End");
  assert.equal(last, labelAt(branch, fan.speeds_rad_s.at(-1)));
  assert.notEqual(first, last);

  await page.locator("#chart-data summary").click();
  const veerings = page.locator("#chart-data table", { hasText: "veer away" }).locator("tbody tr");
  assert.equal(await veerings.count(), fan.veerings.length);
});

pageTest("an unstable blade is shown without a number where it has none", {}, async (page) => {
  const uniform = await blade(page, "uniform");
  const unstable = {
    ...uniform,
    name: "unstable",
    rotor: { ...uniform.rotor, pitch: 1.3, nominal_speed: 3 },
    distribution: { ...uniform.distribution, torsion_stiffness: 0.01, polar_inertia: 0.01 },
  };
  await page
    .locator("#file-input")
    .setInputFiles({ name: "unstable.json", mimeType: "application/json", buffer: Buffer.from(JSON.stringify(unstable)) });
  await page.locator('#chart > svg[aria-label="Fan chart of unstable"]').waitFor();
  await page.locator("#modes tbody tr", { hasText: "unstable" }).waitFor();
  const row = (await rows(page)).find(([label]) => label === "1T");
  assert.deepEqual(row.slice(1, 7), ["unstable", "–", "–", "–", "–", "–"]);
  await page.locator('#modes tbody input[value="1T"]').evaluate((radio) => radio.click());
  await page.locator("#motion-pace", { hasText: "unstable" }).waitFor();
  await page.evaluate(() => (window.print = () => dispatchEvent(new Event("beforeprint"))));
  const clean = async (place) => {
    const shown = await page.evaluate(() => {
      const parts = [...document.querySelectorAll("main, main *, #report *")];
      const written = parts.flatMap((part) => [...part.attributes].map(({ value }) => value));
      return `${document.querySelector("main").textContent} ${document.querySelector("#report").textContent} ${written.join(" ")}`;
    });
    assert.doesNotMatch(shown, NO_VALUE, place);
  };
  await page.locator("#chart-data summary").click();
  await page.locator("#measured-details summary").click();
  await page.locator("#measured-example").click();
  await page.locator("#measured-table tbody tr").first().waitFor();
  await clean("fan");
  await page.locator("#chart").focus();
  for (const key of ["ArrowRight", "End", "ArrowUp", "ArrowDown", "ArrowDown", "Home"]) {
    await page.keyboard.press(key);
    await page.waitForTimeout(150);
    await clean(key);
  }
  await page.keyboard.press("Control+p");
  await page.waitForFunction(() => document.querySelector("#report").textContent.includes("unstable"));
  await clean("report");
  for (const tab of ["shapes", "converge"]) {
    await page.locator(`#tab-${tab}`).click();
    await page.locator(`#chart > svg[aria-label^="${{ shapes: "Mode shapes", converge: "Convergence" }[tab]}"]`).waitFor();
    await page.waitForTimeout(600);
    await clean(tab);
  }
});
