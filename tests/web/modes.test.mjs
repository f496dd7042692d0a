// The chosen mode in motion, margins and what moves them, the lesson of convergence, the report.

import assert from "node:assert/strict";
import { test } from "node:test";
import { lessonWords } from "../../web/modes/lesson.js";
import { NEAR, TOO_NEAR, nearModes, nearness } from "../../web/modes/nearness.js";
import { STAGE, camera, chordAt, hubPaths, platePaths } from "../../web/modes/plate.js";
import { REVOLUTION_S, largest, nodeWords, pace } from "../../web/modes/shape.js";
import { call, pageTest } from "./support.mjs";

const modesTest = (name, options, body) =>
  pageTest(name, { reducedMotion: "no-preference", model: "uncoupled", ...options }, async (page) => {
    await page.locator("#motion-title", { hasText: "Mode 1F" }).waitFor();
    await body(page);
  });

const choose = async (page, label) => {
  await page.locator(`#modes tbody input[value="${label}"]`).evaluate((radio) => radio.click());
  await page.locator("#motion-title", { hasText: `Mode ${label} ` }).waitFor();
};
const openBlade = async (page, name, title) => {
  await page.locator("#blade-choice").selectOption(name);
  await page.waitForFunction((title) => document.title.startsWith(title), title);
};
async function blade(page, name) {
  const { value } = await call(page, "built_in_blades");
  return (await call(page, "parse_blade", value.find((built) => built.name === name).toml)).value;
}
const face = (page) => page.locator("#motion .face").getAttribute("d");
const pause = (page, milliseconds) => page.waitForTimeout(milliseconds);
const table = (page) =>
  page
    .locator("#modes tbody tr")
    .evaluateAll((all) => all.map((row) => ({ label: row.cells[0].textContent, near: row.dataset.near, words: row.cells[6].textContent })));

test("nodes and the largest value are said in words", () => {
  assert.equal(nodeWords([]), "No node between root and tip");
  assert.equal(nodeWords([0.781]), "Node at r/R 0.78");
  assert.equal(nodeWords([0.1, 0.5, 0.9]), "Nodes at r/R 0.10, 0.50 and 0.90");
  assert.deepEqual(largest([0, 0.5, 1], [1, -3, 2]), { at: 0.5, value: -3 });
  assert.equal(largest([0, 1], [0, 0]), null);
});

test("the pace keeps the true ratios", () => {
  const at = (frequency, even = false, speed = 10) => pace({ frequency, speed, nominal: 10 }, even);
  assert.equal(at(20).mode, 2 * at(10).mode);
  assert.equal(at(10).mode, 1 / REVOLUTION_S);
  assert.equal(at(10, false, 5).rotor, 0.5 / REVOLUTION_S);
  for (const [frequency, even] of [
    [3, false],
    [70, false],
    [700, false],
    [3, true],
    [700, true],
  ]) {
    const { mode, rotor } = at(frequency, even);
    assert.ok(Math.abs(mode / rotor - frequency / 10) < 1e-9, "mode to rotor");
    assert.ok(mode <= 5 && rotor <= 5);
  }
  assert.equal(at(700).held, true);
  assert.equal(at(3, true).mode, at(70, true).mode);
  assert.equal(at(0).mode, 0);
  assert.ok(Number.isFinite(pace({ frequency: 5, speed: 0, nominal: 0 }, false).mode));
});

test("the blade stays on the stage in its best view", () => {
  const at = [0.05, 0.5, 1];
  for (const [dof, view] of [
    ["flap", "side"],
    ["lag", "above"],
    ["torsion", "twist"],
  ]) {
    const project = camera(view, dof);
    for (const share of [-1, 1]) {
      for (const x of at) {
        for (const point of chordAt(dof, x, { [dof]: share })) {
          const [left, top] = project(point);
          assert.ok(left >= 0 && left <= STAGE.width && top >= 0 && top <= STAGE.height, `${dof} ${x} ${share}: ${left}, ${top}`);
        }
      }
    }
    const { face, edge, ribs } = platePaths(dof, at, { [dof]: [0, 0.3, 1] }, 1, project);
    for (const path of [face, edge, ribs, ...Object.values(hubPaths(0.05, project))]) assert.doesNotMatch(path, /NaN|Infinity/);
  }
});

test("margins are near below one threshold and too near below another", () => {
  const mode = (margin, harmonic = 3) => ({ label: "2F", nearest_harmonic: harmonic, margin_per_rev: margin });
  assert.equal(nearness(mode(-TOO_NEAR * 0.99)), "too near");
  assert.equal(nearness(mode(TOO_NEAR)), "near");
  assert.equal(nearness(mode(NEAR)), "");
  assert.equal(nearness(mode(0, 60), 10), "", "beyond the harmonics looked at");
  assert.equal(nearness({ nearest_harmonic: null, margin_per_rev: null }), "");
  assert.deepEqual(
    nearModes([mode(0.09), mode(0.2), mode(-0.01)], 10).map((m) => m.margin_per_rev),
    [-0.01, 0.09],
  );
});

test("the lesson is said in numbers of functions", () => {
  const series = {
    label: "2F",
    classical_rad_s: [null, 110, 107.2],
    converged_rad_s: 100,
    lower_rad_s: 100 - 1e-9,
    upper_rad_s: 100 + 1e-9,
    piecewise_functions: [4, 8, 12],
    piecewise_rad_s: [101, 100.001, 100],
  };
  const report = { functions: [1, 7, 15], series: [series] };
  assert.equal(
    lessonWords(report, "2F", 15),
    "2F with the paper’s 15 functions: 107.2 rad/s, +7.2 %. With 7 of them: +10 %. Piecewise functions: +1.0 % with 4, converged with 12: 100.0 ±2·10⁻⁹ rad/s.",
  );
  assert.match(lessonWords(report, "2F", 99), /^2F with the paper’s 15 functions/, "the most there are");
  assert.equal(lessonWords(report, "9F", 15), "");
  assert.doesNotMatch(
    lessonWords({ functions: [1], series: [{ ...series, classical_rad_s: [null], piecewise_rad_s: [0, 0, 0], converged_rad_s: 0 }] }, "2F", 1),
    /NaN|undefined/,
  );
});

modesTest("the mode chosen in the table is shown with its nodes and moment", {}, async (page) => {
  assert.match(await page.locator("#motion-nodes").textContent(), /^No node between root and tip; hinged at r\/R 0\.055/);
  await choose(page, "3F");
  const { value } = await call(page, "shapes", await blade(page, "tm4760"), { model: "uncoupled", dof: ["flap"], points: 121 });
  const shape = value.shapes.find(({ label }) => label === "3F");
  const nodes = shape.nodes_m.map((r) => r / value.radius_m);
  assert.equal(nodes.length, 2);
  assert.ok((await page.locator("#motion-nodes").textContent()).startsWith(nodeWords(nodes)));
  assert.equal(await page.locator("#motion .shape-plot .node").count(), 2);
  const largestMoment = Math.max(...shape.moment.map(Math.abs)) / Math.max(...shape.displacement.map(Math.abs));
  const said = Number(/largest ([\d.]+) N·m per m of deflection/.exec(await page.locator("#motion-moment").textContent())[1]);
  assert.ok(Math.abs(said / largestMoment - 1) < 1e-3, `${said} for ${largestMoment}`);
  assert.match(await page.locator("#motion .stage").getAttribute("aria-label"), /^Mode 3F, flap: the blade seen from the side.*Nodes at r\/R/);
  assert.match(
    await page.locator("#motion-detail").textContent(),
    /349\.8 rad\/s; 55\.67 Hz; 5\.061\/rev, 0\.06 above 5P; bounds ±.*the paper’s 15 functions 352\.1 rad\/s, \+0\.68 %/,
  );
});

modesTest("the view follows the degree of freedom until one is chosen", {}, async (page) => {
  const view = () => page.locator('#motion [name="motion-view"]:checked').inputValue();
  assert.equal(await view(), "side");
  await choose(page, "2L");
  assert.equal(await view(), "above");
  assert.match(await page.locator("#motion-moment").textContent(), /^lagwise bending moment/);
  await choose(page, "1T");
  assert.equal(await view(), "twist");
  assert.match(await page.locator("#motion-moment").textContent(), /^torsional moment, .* N·m per rad of twist/);
  const before = await page.locator("#motion .faint").getAttribute("d");
  await page.locator("#motion-side").focus();
  await page.keyboard.press("ArrowRight");
  assert.equal(await view(), "above");
  assert.notEqual(await page.locator("#motion .faint").getAttribute("d"), before);
  await choose(page, "2T");
  assert.equal(await view(), "above", "it holds for modes of the same kind");
  await choose(page, "2F");
  assert.equal(await view(), "side");
});

modesTest("the blade moves, pauses, and the rest stands still", { viewport: { width: 1280, height: 1200 } }, async (page) => {
  await page.locator('#motion[data-runs="true"]').waitFor();
  const one = await face(page);
  await page.waitForFunction((one) => document.querySelector("#motion .face").getAttribute("d") !== one, one);
  await page.locator("#motion-play").click();
  assert.equal(await page.locator("#motion-play").textContent(), "Play");
  const still = await face(page);
  await pause(page, 250);
  assert.equal(await face(page), still);
  assert.equal(await page.locator("#motion .other").isVisible(), true, "the extremes are shown");
  const frames = await page.evaluate(async () => {
    let asked = 0;
    const real = requestAnimationFrame;
    window.requestAnimationFrame = (done) => (asked++, real(done));
    await new Promise((resolve) => setTimeout(resolve, 200));
    return asked;
  });
  assert.equal(frames, 0, "no frames are asked for while nothing moves");
  await page.locator("#motion-play").focus();
  await page.keyboard.press("Enter");
  await page.waitForFunction((still) => document.querySelector("#motion .face").getAttribute("d") !== still, still);
});

modesTest("true relative frequency: 2F is faster than 1F by the true ratio", {}, async (page) => {
  const pace = async () => Number(await page.locator("#motion").getAttribute("data-pace"));
  const first = await pace();
  await choose(page, "2F");
  const second = await pace();
  const { value } = await call(page, "modes", await blade(page, "tm4760"), { model: "uncoupled" });
  const [f1, f2] = value.modes.map((mode) => mode.frequency_rad_s);
  assert.ok(Math.abs(second / first - f2 / f1) < 1e-9);
  await page.locator("#motion-relative").uncheck();
  const even = await pace();
  await choose(page, "1F");
  assert.equal(await pace(), even, "without it every mode has the same pace");
});

modesTest("out of sight nothing runs", { viewport: { width: 390, height: 600 } }, async (page) => {
  await page.locator('#motion[data-runs="false"]').waitFor();
  await page.locator("#motion .stage").scrollIntoViewIfNeeded();
  await page.locator('#motion[data-runs="true"]').waitFor();
  await page.evaluate(() => {
    Object.defineProperty(document, "hidden", { value: true });
    document.dispatchEvent(new Event("visibilitychange"));
  });
  await page.locator('#motion[data-runs="false"]').waitFor();
});

modesTest(
  "who wants less motion gets a still of the extremes and may play it",
  { reducedMotion: "reduce", viewport: { width: 1280, height: 1200 } },
  async (page) => {
    assert.equal(await page.locator("#motion").getAttribute("data-runs"), "false");
    const still = await face(page);
    await pause(page, 200);
    assert.equal(await face(page), still);
    assert.equal(await page.locator("#motion .other").isVisible(), true);
    assert.ok((await page.locator("#motion .other").getAttribute("d")).startsWith(still), "the blade stands at an extreme");
    await page.locator("#motion-play").click();
    await page.waitForFunction((still) => document.querySelector("#motion .face").getAttribute("d") !== still, still);
  },
);

modesTest("a mode without frequency stands still and says why", {}, async (page) => {
  await page.locator("#speed-number").fill("0");
  await page.locator("#motion-title", { hasText: "at 0 rpm" }).waitFor();
  assert.match(await page.locator("#motion-pace").textContent(), /no frequency/);
  assert.equal(await page.locator("#motion").getAttribute("data-runs"), "false");
  assert.equal(await page.locator("#movers li").count(), 0);
  await choose(page, "2F");
  await page.locator("#motion-pace", { hasText: "than real" }).waitFor();
});

modesTest("every mode of every blade is drawn from numbers", {}, async (page) => {
  const { value } = await call(page, "built_in_blades");
  for (const { name, title } of value) {
    await openBlade(page, name, title);
    for (const label of ["1F", "5F", "1L", "5L", "1T", "5T"]) {
      await choose(page, label);
      const paths = await page.locator("#motion path").evaluateAll((all) => all.map((path) => path.getAttribute("d") ?? "").join());
      assert.doesNotMatch(paths, /NaN|Infinity|undefined/, `${name} ${label}`);
      assert.doesNotMatch(await page.locator("#motion").textContent(), /NaN|Infinity|undefined|null/);
    }
  }
});

modesTest("near modes are worded and coloured, and the words explained", {}, async (page) => {
  const { value } = await call(page, "modes", await blade(page, "tm4760"), { model: "uncoupled" });
  for (const { label, near, words } of await table(page)) {
    const mode = value.modes.find((mode) => mode.label === label);
    assert.equal(near, nearness(mode, 10), label);
    assert.equal(words.startsWith("too near "), near === "too near", words);
    assert.equal(/^near /.test(words), near === "near", words);
  }
  assert.equal(await page.locator("#near-note").textContent(), "near: less than 0.1/rev from a harmonic up to 10P; too near: less than 0.05/rev.");
});

modesTest("what moves a near mode is what the package says it does", {}, async (page) => {
  const said = page.locator("#movers li", { hasText: "3F" });
  await said.waitFor();
  const words = await said.textContent();
  const [, slope, change] = /^Flap stiffness \+1 % moves 3F up by about ([\d.]+)\/rev; about \+([\d.]+) % brings the margin to 0.1\/rev\.$/.exec(
    words,
  );
  const tm = await blade(page, "tm4760");
  const scaled = (factor) => ({
    ...tm,
    distribution: { ...tm.distribution, flap_stiffness: tm.distribution.flap_stiffness.map((value) => value * factor) },
  });
  const margin = async (factor) => (await call(page, "modes", scaled(factor), { model: "uncoupled", dof: ["flap"] })).value.modes[2].margin_per_rev;
  assert.ok(Math.abs((await margin(1.01)) - (await margin(1)) - Number(slope)) < 1e-3, words);
  assert.ok(Math.abs((await margin(1 + Number(change) / 100)) - NEAR) < 2e-3, words);
  assert.match(await page.locator("#movers li", { hasText: "1F" }).textContent(), /hardly move 1F\. 1F of a hinged blade lies near 1P\./);

  await openBlade(page, "hingeless-1000", "torsionally soft");
  await page.waitForFunction(() => !document.querySelector("#movers").textContent.includes("3F"));
});

modesTest("the convergence tab says what it shows, of the chosen mode", {}, async (page) => {
  await page.locator("#tab-converge").click();
  await page.locator("#lesson", { hasText: /^1F with the paper’s 15 functions/ }).waitFor();
  await choose(page, "2T");
  await page.locator("#lesson", { hasText: /^2T with the paper’s 15 functions: 1901 rad\/s, \+3\.1 %\..*converged with \d+/ }).waitFor();
  assert.deepEqual(await page.locator("#close-tools input:checked").evaluateAll((all) => all.map((box) => box.value)), ["torsion"]);
  await page.locator("#close-torsion").click();
  assert.equal(await page.locator("#close-torsion").isChecked(), true, "one at least");
  await page.locator("#option-functions").fill("6");
  await page.locator("#lesson", { hasText: "the paper’s 6 functions" }).waitFor();
  await page.locator("#tab-fan").click();
  await page.locator("#lesson").waitFor({ state: "hidden" });
});

modesTest("mode shapes fit the window and more are a click away", {}, async (page) => {
  await page.locator("#tab-shapes").click();
  await page.locator('#chart > svg[aria-label^="Mode shapes"]').waitFor();
  assert.equal(await page.locator("#chart [data-label]").evaluateAll((all) => all.every((part) => part.dataset.label.endsWith("F"))), true);
  const end = await page.locator("#chart").evaluate((chart) => chart.getBoundingClientRect().bottom);
  assert.ok(end <= 800, `the drawing ends at ${end}`);
  await page.locator("#close-lag").check();
  await page.locator('#chart [data-label="1L"]').first().waitFor();
  await page.locator("#tab-fan").click();
  await page.locator("#close-tools").waitFor({ state: "hidden" });
});

for (const [width, columns] of [
  [360, 5],
  [390, 5],
  [600, 7],
  [768, 7],
  [820, 6],
  [1280, 6],
  [1366, 6],
  [1920, 7],
]) {
  modesTest(`at ${width} px the table has ${columns} columns, and nothing scrolls sideways`, { viewport: { width, height: 800 } }, async (page) => {
    for (const [name, title] of [
      ["sa330", "SA 330"],
      ["uniform", "uniform"],
      ["tm4760", "TM 4760"],
    ]) {
      await openBlade(page, name, title);
      const fits = await page.evaluate(() => ({
        page: document.documentElement.scrollWidth - document.documentElement.clientWidth,
        table: document.querySelector(".numbers").scrollWidth - document.querySelector(".numbers").clientWidth,
        columns: [...document.querySelector("#modes tbody tr").cells].filter((cell) => cell.offsetWidth > 0).length,
      }));
      assert.deepEqual(fits, { page: 0, table: 0, columns }, name);
    }
  });
}

for (const width of [360, 390, 820, 1280]) {
  modesTest(
    `at ${width} px the table of a coupled blade scrolls nowhere sideways`,
    { model: "coupled", viewport: { width, height: 800 } },
    async (page) => {
      await openBlade(page, "uh60a", "UH-60A");
      const wider = (place) => page.locator(place).evaluate(({ scrollWidth, clientWidth }) => scrollWidth - clientWidth);
      assert.deepEqual([await wider("html"), await wider(".numbers")], [0, 0]);
    },
  );
}

/** A page whose print() only says that it was called. */
async function printing(page) {
  await page.evaluate(() => {
    window.prints = 0;
    window.print = () => {
      window.prints++;
      dispatchEvent(new Event("beforeprint"));
    };
  });
}
/** Pages of the PDF that the browser prints. */
async function pages(page, format) {
  const pdf = await page.pdf({ format, preferCSSPageSize: false, margin: { top: "11mm", bottom: "11mm", left: "12mm", right: "12mm" } });
  return pdf.toString("latin1").match(/\/Type\s*\/Page\b(?!s)/g).length;
}

modesTest("menu and Ctrl+P print the same report, on one page", { colorScheme: "dark" }, async (page) => {
  await printing(page);
  await page.locator("#download summary").click();
  await page.locator("#print").click();
  await page.waitForFunction(() => window.prints === 1);
  const report = page.locator("#report");
  const text = await report.textContent();
  for (const words of [
    "TM 4760 research blade",
    "660 rpm, nominal",
    "NASA TM 4760",
    "radius 55 in",
    "flap hinged at 3 in",
    "Properties along the span",
    "flap EI [lbf·in²]",
    "0.05 above 1P, too near",
    "+0.098 %",
    "Crossings, 0.9 to 1.1 of nominal speed",
    "3F × 5P",
    "uncoupled, in vacuum",
    "bladefan 0.",
    page.url().split("#")[0],
  ]) {
    assert.ok(text.includes(words), `${words} in ${text}`);
  }
  assert.equal(text.includes("#"), false, "the address without its fragment");
  assert.equal(await report.locator("svg").count(), 1);
  const back = await report.locator("svg").evaluate((svg) => svg.querySelector("rect, polygon").getAttribute("fill"));
  assert.match(back, /^#f|^white/i, "light colours on paper");
  await page.evaluate(() => dispatchEvent(new Event("afterprint")));
  assert.equal(await report.textContent(), "");
  await page.keyboard.press("Control+p");
  await page.waitForFunction(() => window.prints === 2);
  assert.equal(await report.textContent(), text);
  assert.equal(await report.isVisible(), false, "not on the screen");
  await page.emulateMedia({ media: "print" });
  assert.equal(await report.isVisible(), true);
  assert.equal(await page.locator("main").isVisible(), false);
  await page.emulateMedia({ media: null });
  for (const format of ["A4", "Letter"]) assert.equal(await pages(page, format), 1, format);
});

/** Whether the report at hand takes one page of each format, with tables no wider than their place. */
async function fitsPaper(page, name) {
  await page.emulateMedia({ media: "print" });
  await page.setViewportSize({ width: 718, height: 1039 });
  const sideways = await page.evaluate(() =>
    [...document.querySelectorAll("#report table, #report")].map((part) => part.scrollWidth - part.parentElement.clientWidth),
  );
  assert.ok(Math.max(...sideways) <= 0, sideways.join());
  await page.screenshot({ path: new URL(`screenshots/report-${name}.png`, import.meta.url).pathname, fullPage: true });
  await page.emulateMedia({ media: null });
  await page.setViewportSize({ width: 1280, height: 800 });
  for (const format of ["A4", "Letter"]) assert.equal(await pages(page, format), 1, format);
}

modesTest("a full report still has one page, and says what it leaves out", {}, async (page) => {
  await printing(page);
  const tm = await blade(page, "sa330");
  const r = Array.from({ length: 60 }, (_, i) => 0.2 + ((tm.rotor.radius - 0.2) * i) / 59);
  r[59] = tm.rotor.radius;
  const along = (value) => r.map((_, i) => value * (1 + i / 100));
  const long = {
    ...tm,
    name: "A blade with a name that is rather long, as names of blades go, and sixty stations",
    notes: "Notes that go on and on. ".repeat(40),
  };
  long.distribution = {
    r,
    mass: along(9.123456),
    flap_stiffness: along(123456.7),
    lag_stiffness: along(1234567.8),
    torsion_stiffness: along(98765.4),
    polar_inertia: along(0.1234),
    mass_offset: along(0.01),
    twist: along(-5.12),
  };
  const { value: toml } = await call(page, "write_blade", long, "toml");
  await page.locator("#file-input").setInputFiles({ name: "long.toml", mimeType: "text/plain", buffer: Buffer.from(toml) });
  await page.waitForFunction(() => document.title.startsWith("A blade with a name"));
  await page.locator("#option-harmonics").fill("40");
  await page.locator("#near-note", { hasText: "40P" }).waitFor();
  const slider = page.locator("#what-if-factors-mass");
  await slider.evaluate((input) => {
    input.value = 0.1;
    input.dispatchEvent(new Event("input", { bubbles: true }));
  });
  await pause(page, 1000);
  await page.keyboard.press("Control+p");
  await page.waitForFunction(() => window.prints === 1);
  const text = () => page.locator("#report").textContent();
  assert.match(await text(), /What if, already in these numbers: mass and polar inertia × 1\.07/);
  assert.match(await text(), /The first 28 of 60 stations\./);
  assert.match(await text(), /The first 12 of \d+ crossings\./);
  await fitsPaper(page, "many-crossings");

  await page.locator("#option-modes").fill("10");
  await page.waitForFunction(() => document.querySelectorAll("#modes tbody tr").length === 30);
  await pause(page, 1000);
  await page.keyboard.press("Control+p");
  await page.waitForFunction(() => window.prints === 2);
  for (const label of ["6F", "6L", "6T"]) assert.ok((await text()).includes(label));
  assert.match(await text(), /The lowest 18 of 30 modes\./);
  assert.match(await text(), /The first 26 of 60 stations\./);
  await fitsPaper(page, "many-modes");
});

modesTest("the report of a coupled blade has its shares, and one page", { model: "coupled" }, async (page) => {
  await printing(page);
  await openBlade(page, "uh60a", "UH-60A");
  await page.locator("#print").evaluate((button) => button.click());
  await page.waitForFunction(() => window.prints === 1);
  const text = await page.locator("#report").textContent();
  for (const words of ["F, L, T %", "1T/F", "27, 21, 52", "coupled, in vacuum"]) assert.ok(text.includes(words), `${words} in ${text}`);
  await fitsPaper(page, "coupled");
});
