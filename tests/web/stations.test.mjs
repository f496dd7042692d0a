// The sheet of stations in Chromium, as its users type, paste and move in it.

import assert from "node:assert/strict";
import { test } from "node:test";
import { downloaded, frequencies, open, screenshots, pageTest } from "./support.mjs";

/** A test in the tab of stations of a built-in blade. */
const sheetTest = (name, blade, body, options = {}) =>
  pageTest(name, options, async (page) => {
    if (blade !== "tm4760") await choose(page, blade);
    await page.locator("#tab-stations").click();
    await page.locator(".sheet td").first().waitFor();
    await body(page);
  });

async function choose(page, name) {
  const title = await page.title();
  await page.locator("#blade-choice").selectOption(name);
  await page.waitForFunction((title) => document.title !== title, title);
}
/** Opens a blade file of these contents. */
async function openBlade(page, blade) {
  await page.locator("#file-input").setInputFiles({ name: "b.json", mimeType: "", buffer: Buffer.from(JSON.stringify(blade)) });
}
const BLADE = {
  schema: "bladefan-blade/1",
  name: "test blade",
  rotor: { radius: 10, nominal_speed: 30 },
  flap: { root: "hingeless" },
  lag: { root: "hingeless" },
  torsion: { root: "rigid" },
  distribution: {
    r: [0, 4, 4, 10],
    mass: [6, 6, 5, 5],
    flap_stiffness: [9e4, 9e4, 4e4, 4e4],
    lag_stiffness: { r: [0, 10], values: [9e5, 5e5] },
    torsion_stiffness: 8e4,
    polar_inertia: 0.1,
  },
};
const cell = (page, row, column) => page.locator(`.sheet tbody tr[data-row="${row}"] td`).nth(column);
const click = (page, row, column) => cell(page, row, column).click();
/** Texts of the cells, rows of stations only. */
const table = (page, columns) =>
  page
    .locator(".sheet tbody tr:not(.whole):not(.new)")
    .evaluateAll((all, columns) => all.map((row) => [...row.querySelectorAll("td")].slice(0, columns).map((td) => td.textContent)), columns);
const focused = (page) =>
  page.evaluate(() => [Number(document.activeElement.closest("tr")?.dataset.row), Number(document.activeElement.dataset.col)]);
const type = (page, ...keys) =>
  keys.reduce((before, key) => before.then(() => (/^[A-Z]/.test(key) ? page.keyboard.press(key) : page.keyboard.type(key))), Promise.resolve());
/** Pastes as Ctrl+V does. */
const paste = (page, text) =>
  page.evaluate((text) => {
    const data = new DataTransfer();
    data.setData("text/plain", text);
    document.activeElement.dispatchEvent(new ClipboardEvent("paste", { clipboardData: data, bubbles: true, cancelable: true }));
  }, text);
const copy = (page, kind = "copy") =>
  page.evaluate((kind) => {
    const data = new DataTransfer();
    document.activeElement.dispatchEvent(new ClipboardEvent(kind, { clipboardData: data, bubbles: true, cancelable: true }));
    return data.getData("text/plain");
  }, kind);
const said = (page) => page.locator("#stations-said").textContent();
const faults = (page) => page.locator("#stations-faults li").allTextContents();
/** Runs something and waits for other frequencies. */
async function solved(page, work) {
  const old = JSON.stringify(await frequencies(page));
  await work();
  await page.waitForFunction(
    (old) =>
      JSON.stringify(
        Object.fromEntries(
          [...document.querySelectorAll("#modes tbody tr")].map((row) => [row.cells[0].textContent, Number(row.cells[1].dataset.full)]),
        ),
      ) !== old,
    old,
  );
  return frequencies(page);
}
async function mine(page, blade = BLADE) {
  await openBlade(page, blade);
  await page.waitForFunction((name) => document.title.startsWith(name), blade.name);
}

sheetTest("stations stand in columns with their units, steps marked", "tm4760", async (page) => {
  const heads = await page
    .locator(".sheet thead th")
    .evaluateAll((all) => all.map((th) => [...th.querySelectorAll(".column-name, .unit")].map((one) => one.textContent).join(" ")));
  assert.deepEqual(heads, [
    "",
    "r in",
    "mass lb/in",
    "flap stiffness lbf·in²",
    "lag stiffness lbf·in²",
    "torsion stiffness lbf·in²",
    "polar inertia lb·in",
    "mass offset in",
    "twist rad",
    "flap inertia lb·in",
    "lag inertia lb·in",
    "axial stiffness lbf",
  ]);
  assert.deepEqual((await table(page, 2)).slice(0, 3), [
    ["3", "0.4251"],
    ["6.87", "0.4251"],
    ["6.87", "0.1938"],
  ]);
  assert.equal(await page.locator('.sheet tr[data-row="2"] th').textContent(), "3 step");
  assert.match(await page.locator('.sheet tr[data-row="1"] th').getAttribute("aria-label"), /step, inboard/);
});

sheetTest("typing changes the blade at once; Escape and Ctrl+Z take it back", "bo105", async (page) => {
  const before = await frequencies(page);
  await click(page, 5, 1);
  const heavier = await solved(page, () => type(page, "7"));
  assert.ok(heavier["1F"] < before["1F"]);
  await solved(page, () => type(page, "Escape"));
  assert.deepEqual(await frequencies(page), before);
  assert.equal(await cell(page, 5, 1).textContent(), "5.7");
  assert.equal(await page.locator("#blade-choice").inputValue(), "bo105", "taken back wholly");

  await solved(page, () => type(page, "7", ".5", "Enter"));
  assert.equal(await cell(page, 5, 1).textContent(), "7.5");
  await click(page, 5, 1);
  await type(page, "F2");
  assert.equal(await page.locator(".sheet td input").inputValue(), "7.5");
  await type(page, "9");
  await type(page, "Control+z");
  assert.equal(await cell(page, 5, 1).textContent(), "7.5", "in the cell: its typing");
  await type(page, "Control+z");
  assert.equal(await cell(page, 5, 1).textContent(), "5.7", "then the step before");
  await type(page, "Control+y");
  assert.equal(await cell(page, 5, 1).textContent(), "7.5");
  assert.deepEqual(await focused(page), [5, 1]);
});

sheetTest("keys move as in a spreadsheet", "tm4760", async (page) => {
  await click(page, 1, 1);
  const at = async (key, place) => {
    await type(page, key);
    assert.deepEqual(await focused(page), place, key);
  };
  await at("ArrowDown", [2, 1]);
  await at("ArrowRight", [2, 2]);
  await at("Enter", [3, 2]);
  await at("Shift+Enter", [2, 2]);
  await at("Tab", [2, 3]);
  await at("Tab", [2, 4]);
  await at("Enter", [3, 2]);
  await at("Shift+Tab", [3, 1]);
  await at("Home", [3, 0]);
  await at("End", [3, 10]);
  await at("Control+Home", [-1, 0]);
  await at("ArrowUp", [-1, 0]);
  await at("PageDown", [9, 0]);
  await at("Control+ArrowDown", [30, 0]);
  await click(page, 3, 1);
  await type(page, "1", "ArrowRight");
  assert.deepEqual(await focused(page), [3, 2], "arrows go on after typing");
  await type(page, "F2", "ArrowLeft");
  assert.ok(await page.locator(".sheet td input").isVisible(), "and move in the text after F2");
  await type(page, "Tab");
  assert.deepEqual(await focused(page), [3, 3]);
  await type(page, "End", "Tab");
  assert.equal(await page.locator(".sheet :focus").count(), 0, "Tab leaves at the end of a row");
});

sheetTest("blocks are selected, copied with every digit, cut, cleared and pasted", "tm4760", async (page) => {
  await mine(page, { ...BLADE, distribution: { ...BLADE.distribution, mass: [1 / 3, 6, 5, 5] } });
  await click(page, 0, 0);
  await type(page, "Shift+ArrowDown", "Shift+ArrowRight");
  assert.equal(await page.locator('.sheet td[aria-selected="true"]').count(), 4);
  assert.equal(await copy(page), "0\t0.3333333333333333\n4\t6");
  await cell(page, 1, 1).hover();
  await page.mouse.down();
  await cell(page, 2, 2).hover();
  await page.mouse.up();
  assert.equal(await copy(page), "6\t90000\n5\t40000");
  assert.equal(await copy(page, "cut"), "6\t90000\n5\t40000");
  assert.equal(await cell(page, 1, 1).textContent(), "");
  await page.locator("#stations-count", { hasText: "4 faults" }).waitFor();
  await paste(page, "6\t90000\n5\t40000");
  await page.locator("#stations-faults").waitFor({ state: "hidden" });
  await click(page, 1, 1);
  await type(page, "Shift+ArrowDown");
  await paste(page, "5,5e0\t");
  assert.match(await said(page), /^2 rows × 1 column pasted/, "one value fills a block");
  assert.equal(await copy(page), "5.5\n5.5");
  await type(page, "Control+z");
  await click(page, 3, 1);
  await type(page, "Delete");
  await page.locator('.sheet td[aria-invalid="true"]').waitFor();
  await type(page, "Control+z");
  await page.locator("#stations-faults").waitFor({ state: "hidden" });
  await type(page, "Control+a");
  assert.deepEqual(
    (await copy(page)).split("\n").map((row) => row.split("\t").slice(0, 2)),
    [
      ["0", "0.3333333333333333"],
      ["4", "6"],
      ["4", "5"],
      ["10", "5"],
    ],
  );
});

test("the clipboard of the system works, too", async () => {
  const { page, close } = await open({ permissions: ["clipboard-read", "clipboard-write"] });
  try {
    await page.locator("#tab-stations").click();
    await click(page, 0, 1);
    await type(page, "Shift+ArrowDown", "Control+c");
    assert.equal(await page.evaluate(() => navigator.clipboard.readText()), "0.4251\n0.4251");
    await page.evaluate(() => navigator.clipboard.writeText("0,5\t2\n0,75\t3\n"));
    await type(page, "Control+v");
    assert.deepEqual(
      (await table(page, 3)).slice(0, 2).map((row) => row.slice(1)),
      [
        ["0.5", "2"],
        ["0.75", "3"],
      ],
    );
    assert.equal(await said(page), "2 rows × 2 columns pasted; decimal commas read as points.");
  } finally {
    await close();
  }
});

sheetTest("rows are added, repeated, moved and deleted by button and key", "tm4760", async (page) => {
  await mine(page);
  const radii = async () => (await table(page, 2)).map((row) => row.join(":"));
  await click(page, 1, 0);
  await page.locator('[data-command="above"]').click();
  assert.deepEqual(await radii(), ["0:6", "2:6", "4:6", "4:5", "10:5"]);
  await page.locator('[data-command="step"]').click();
  assert.deepEqual(await radii(), ["0:6", "2:6", "2:6", "4:6", "4:5", "10:5"]);
  assert.deepEqual(await focused(page), [2, 0]);
  await page.locator('[data-command="step"]').click();
  assert.match(await said(page), /stands twice already/);
  await click(page, 2, 0);
  await type(page, "Alt+Delete");
  assert.deepEqual(await radii(), ["0:6", "2:6", "4:6", "4:5", "10:5"]);
  await click(page, 3, 0);
  await type(page, "Alt+ArrowUp");
  assert.deepEqual(await radii(), ["0:6", "2:6", "4:5", "4:6", "10:5"]);
  assert.deepEqual(await focused(page), [2, 0]);
  await page.locator('[data-command="down"]').click();
  await type(page, "Alt+Shift+ArrowDown");
  assert.equal((await radii())[4], "7:5");
  await click(page, 1, 0);
  await type(page, "Shift+ArrowDown");
  await page.locator('[data-command="delete"]').click();
  assert.deepEqual(await radii(), ["0:6", "4:5", "7:5", "10:5"]);
  await click(page, 4, 0);
  await type(page, "11", "Tab", "4", "Tab");
  assert.deepEqual((await radii()).at(-1), "11:4", "a new station is typed below the last");
});

sheetTest("a pasted table with names, units and decimal commas fills its columns", "tm4760", async (page) => {
  await mine(page);
  await click(page, 0, 0);
  await paste(page, "Mass [g/m]\tradius [m]\tcolour\n6,5\t0\tred\n6,25\t5\tred\n6\t5\tred\n5\t7,5\tred\n5\t10\t\n");
  assert.deepEqual(await table(page, 2), [
    ["0", "6.5"],
    ["5", "6.25"],
    ["5", "6"],
    ["7.5", "5"],
    ["10", "5"],
  ]);
  assert.equal(
    await said(page),
    "5 rows × 3 columns pasted; decimal commas read as points; columns by their names; left out: “colour”; units are not converted: mass is headed [g/m], taken as kg/m; flap stiffness keeps its radii in a sheet of its own.",
  );
  // The stiffness stands where it stood, not at the new radii.
  await page.locator("#stations-sheet").selectOption("flap_stiffness");
  assert.deepEqual(await table(page, 2), [
    ["0", "90000"],
    ["4", "90000"],
    ["4", "40000"],
    ["10", "40000"],
  ]);
  assert.deepEqual(await faults(page), []);
  await page.locator("#stations-sheet").selectOption("");
  await click(page, 0, 0);
  await paste(page, "r\tmass\n0\t7\n5\t\n");
  assert.match(await said(page), /1 empty cell is a fault/);
  await page.locator('.sheet tr[data-row="1"] td[aria-invalid="true"]').first().waitFor();
});

sheetTest("a block that names stiffnesses and no radii is refused, and nothing is mixed", "tm4760", async (page) => {
  const was = await table(page, 8);
  await click(page, 0, 0);
  for (const head of ["EI flap\tEI lag", "span station no\tEI flap", "GJ"]) {
    await paste(page, `${head}\n${was.map(() => head.replace(/[^\t]+/g, "7")).join("\n")}\n`);
    assert.match(await said(page), /^No column of radii: name one r or radius\..*Nothing was pasted\.$/);
    assert.deepEqual(await table(page, 8), was);
  }
  // With radii that are those of the blade nothing is moved.
  await paste(page, `r\tEI flap\n${was.map(([r]) => `${r}\t9e4`).join("\n")}\n`);
  assert.deepEqual(
    await table(page, 2),
    was.map((row) => row.slice(0, 2)),
  );
  assert.equal(await page.locator("#stations-sheet option").count(), 1);
});

sheetTest("a blade begun by pasting does not keep where the last one came from", "tm4760", async (page) => {
  const blade = async () =>
    JSON.parse(
      (
        await downloaded(page, async () => {
          await page.locator("#download summary").click();
          await page.locator("#download-json-blade").click();
        })
      ).bytes.toString(),
    );
  const before = await blade();
  assert.ok(before.source.quality && before.notes);
  await page.locator("#what-if-factors-mass").fill("1");
  const block = "r,mass,EI flap,EI lag,GJ,polar inertia\n0,2,1,3,1,1\n55,2,1,3,1,1\n";
  await page.locator("#stations button", { hasText: "Paste a table" }).click();
  await page.locator("#paste-text").fill(block);
  await page.locator("#paste-use").click();
  const after = await blade();
  assert.deepEqual([after.source, after.notes, after.distribution.mass], [undefined, undefined, [2, 2]]);
  assert.equal(await page.locator("#what-if-factors-mass").inputValue(), "0", "and changes were of the last one");
  await page.locator("#undo").click();
  assert.deepEqual((await blade()).source, before.source);
  // Over every station of the sheet as well; over some of them it is an edit.
  await click(page, 0, 0);
  await paste(page, before.distribution.r ? `r\tmass\n3\t0.5\n` : "");
  assert.deepEqual((await blade()).source, before.source);
  await click(page, 0, 0);
  const rows = (await table(page, 1)).length;
  await paste(page, `r\tmass\n${Array.from({ length: rows }, (_, i) => `${3 + (52 * i) / (rows - 1)}\t0.2`).join("\n")}\n`);
  assert.equal((await blade()).source, undefined);
});

sheetTest("pasting refuses what it would have to guess, and hostile text stays text", "tm4760", async (page) => {
  await mine(page);
  const was = await table(page, 3);
  await click(page, 0, 1);
  for (const [text, words] of [
    ["1.234,5\t2", /thousands/],
    ["1,234\t5", /may be/],
    ["1\t2\t3\t4\t5\t6\t7\t8", /only 7 are left/],
    ["1\t2\t3", /radii of its own/],
    ["", /nothing to paste/],
  ]) {
    await paste(page, text);
    assert.match(await said(page), words);
    assert.deepEqual(await table(page, 3), was);
  }
  await paste(page, "1\t2\t3\n".repeat(100_000));
  assert.match(await said(page), /100000 rows are too many: a blade has at most 2000/);
  assert.deepEqual(await table(page, 3), was);

  const evil = "<script>window.broken=1</script><img src=x onerror=window.broken=1>";
  await paste(page, evil);
  assert.equal(await cell(page, 0, 1).textContent(), evil);
  await page.locator("#stations-faults li", { hasText: "<script>" }).waitFor();
  await paste(page, `__proto__\tconstructor\n${evil}\t"><b>`);
  assert.equal(await page.evaluate(() => window.broken ?? {}.polluted), undefined);
  await paste(page, "\ud800\u0000\u202e");
  assert.equal(await page.locator("#stations script, #stations img, #stations b").count(), 0);
});

sheetTest("faults stand at their cells, in words below, and in a list that leads there", "tm4760", async (page) => {
  await mine(page);
  const chart = await page.locator("#modes tbody tr").count();
  await click(page, 3, 1);
  await type(page, "-5", "Enter");
  await page.locator('.sheet tr[data-row="3"] td[aria-invalid="true"]').waitFor();
  await click(page, 1, 0);
  await type(page, "5", "Enter");
  await page.locator("#stations-faults li").nth(1).waitFor();
  assert.deepEqual(await page.locator("#stations-faults button").evaluateAll((all) => all.map((one) => one.dataset.path)), [
    "distribution.r[2]",
    "distribution.mass[3]",
  ]);
  await page.locator("#stations-faults button").nth(1).click();
  assert.deepEqual(await focused(page), [3, 1]);
  assert.equal(await cell(page, 3, 1).getAttribute("aria-describedby"), "cell-note");
  assert.match(await page.locator("#cell-note").textContent(), /^mass, station 4: -5 kg\/m\. Fault: mass per length at r = 10 m must be at least 0/);
  assert.equal(await page.locator("#last-good").isVisible(), true);
  assert.equal(await page.locator("#modes tbody tr").count(), chart);
  await page.locator('[data-form="twist"]').selectOption("own");
  await page.locator("#stations-sheet").selectOption("twist");
  await click(page, 1, 0);
  await type(page, "x", "Enter");
  await page.locator("#stations-sheet").selectOption("");
  await page.locator("#stations-faults button", { hasText: "of the twist" }).click();
  assert.equal(await page.locator("#stations-sheet").inputValue(), "twist");
  assert.deepEqual(await focused(page), [1, 0]);
});

sheetTest("a property is one number, a list, or on radii of its own", "tm4760", async (page) => {
  await mine(page);
  const before = await frequencies(page);
  assert.equal(await cell(page, -1, 4).textContent(), "80000");
  await solved(page, async () => {
    await click(page, -1, 4);
    await type(page, "90000", "Enter");
  });
  assert.deepEqual(
    (await table(page, 5)).map((row) => row[4]),
    ["90000", "90000", "90000", "90000"],
  );
  await type(page, "Control+z");
  await page.locator('[data-form="mass"]').selectOption("number");
  assert.match(await said(page), /mass is not the same at all radii: it goes from 5 to 6/);
  assert.equal(await page.locator('[data-form="mass"]').inputValue(), "list");
  await page.locator('[data-form="lag_stiffness"]').selectOption("list");
  assert.deepEqual(
    (await table(page, 4)).map((row) => row[3]),
    ["900000", "740000", "740000", "500000"],
  );
  await page.locator('[data-form="mass"]').selectOption("own");
  await page.locator("#stations-sheet").selectOption("mass");
  assert.deepEqual(await table(page, 2), [
    ["0", "6"],
    ["4", "6"],
    ["4", "5"],
    ["10", "5"],
  ]);
  assert.equal(await page.locator(".sheet thead th").count(), 3);
  const after = await frequencies(page);
  for (const [label, value] of Object.entries(before)) assert.ok(Math.abs(after[label] - value) < 1e-6 * value, label);
  await solved(page, async () => {
    await click(page, 3, 1);
    await type(page, "4", "Enter");
  });
  await click(page, 0, 0);
  await paste(page, "r;value\n0;6\n10;5,5");
  assert.deepEqual((await table(page, 2)).slice(0, 2), [
    ["0", "6"],
    ["10", "5.5"],
  ]);
});

sheetTest("a blade without common radii starts with the sheet of a property", "sa330", async (page) => {
  assert.equal(await page.locator("#stations-sheet").inputValue(), "mass");
  assert.deepEqual((await table(page, 2))[0], ["0.269", "58.4"]);
  const before = await frequencies(page);
  const heavy = await solved(page, async () => {
    await click(page, 0, 1);
    await type(page, "80", "Tab");
  });
  assert.notDeepEqual(heavy, before);
  assert.equal(await page.locator("#stations-faults").isVisible(), false);
});

sheetTest("a whole table is pasted into a blade", "uniform", async (page) => {
  assert.deepEqual(await table(page, 2), []);
  const button = page.locator("#stations button", { hasText: "Paste a table" });
  await button.click();
  await page.locator("#paste-text").fill("nonsense");
  assert.equal(await page.locator("#paste-use").isDisabled(), true);
  await page.locator("#paste-text").fill("r,mass,EI flap,EI lag,GJ,polar inertia\n0,2,1,3,1,1\n0.5,2,1,3,1,1\n0.5,1,1,3,1,1\n1,1,1,3,1,1\n");
  assert.equal(
    await page.locator("#paste-words").textContent(),
    "4 rows × 6 columns understood: r, mass, flap stiffness, lag stiffness, torsion stiffness and polar inertia; columns by their names.",
  );
  await solved(page, () => page.locator("#paste-use").click());
  assert.deepEqual(await table(page, 2), [
    ["0", "2"],
    ["0.5", "2"],
    ["0.5", "1"],
    ["1", "1"],
  ]);
  assert.match(await said(page), /^4 rows × 6 columns pasted/);
  await button.click();
  await page.locator("#paste-text").evaluate((area, text) => {
    const data = new DataTransfer();
    data.setData("text/plain", text);
    area.dispatchEvent(new ClipboardEvent("paste", { clipboardData: data, bubbles: true, cancelable: true }));
  }, "1,2\n".repeat(100_000));
  assert.match(await page.locator("#paste-words").textContent(), /100000 rows are too many/);
  await page.keyboard.press("Escape");
  assert.equal(await page.locator("#paste-panel").isVisible(), false);
});

sheetTest("a long blade shows 500 rows at a time, and all of it is kept", "tm4760", async (page) => {
  const n = 800;
  const r = Array.from({ length: n }, (_, i) => (10 * i) / (n - 1));
  r[n - 1] = 10;
  await mine(page, {
    ...BLADE,
    name: "long",
    distribution: { ...BLADE.distribution, r, mass: r.map(() => 6), flap_stiffness: r.map((x) => 9e4 - x) },
  });
  await page.locator("#stations-long", { hasText: "The first 500 of 800 rows are shown" }).waitFor();
  assert.equal((await table(page, 1)).length, 500);
  await click(page, 0, 0);
  await type(page, "Control+a");
  assert.equal((await copy(page)).split("\n").length, 800);
  await click(page, 2, 1);
  await type(page, "7", "Enter");
  await page.locator("#stations-page").selectOption("1");
  assert.equal((await table(page, 1)).length, 300);
  await cell(page, 799, 1).click();
  await type(page, "x", "Enter");
  await page.locator("#stations-page").selectOption("0");
  await page.locator("#stations-faults button", { hasText: "station 800" }).click();
  assert.deepEqual(await focused(page), [799, 1]);
});

sheetTest("two thousand rows are pasted, and none is too many", "tm4760", async (page) => {
  await mine(page, { ...BLADE, name: "bare", distribution: { ...BLADE.distribution, r: undefined, mass: 6, flap_stiffness: 9e4 } });
  const lines = Array.from({ length: 2000 }, (_, i) => `${i / 199.9}\t6\t9e4`);
  await click(page, 0, 0);
  await paste(page, lines.join("\n"));
  assert.match(await said(page), /^2000 rows × 3 columns pasted/);
  await page.locator('[data-command="below"]').click();
  assert.match(await said(page), /at most 2000 rows/);
  await click(page, 1, 1);
  await paste(page, lines.join("\n"));
  assert.match(await said(page), /would have 2001 rows; at most 2000/);
});

sheetTest(
  "a finger chooses a cell, then opens it; a row is chosen by its number",
  "tm4760",
  async (page) => {
    await cell(page, 2, 1).tap();
    assert.deepEqual(await focused(page), [2, 1]);
    await cell(page, 2, 1).tap();
    assert.equal(await page.locator(".sheet td input").inputValue(), "0.1938");
    await page.keyboard.press("Escape");
    await page.locator('.sheet tr[data-row="3"] th').click();
    assert.equal((await copy(page)).split("\t").length, 11);
  },
  { hasTouch: true },
);

sheetTest("plots of the properties have their words, and mark the selected station", "tm4760", async (page) => {
  await mine(page);
  const mass = page.locator('.profiles [data-property="mass"] svg');
  assert.equal(
    await mass.getAttribute("aria-label"),
    "mass along the span: from 6 kg/m at r = 0 m to 5 at 10, between 5 and 6; a step at r = 4; at the selected r = 0: 6",
  );
  await click(page, 3, 1);
  assert.match(await mass.getAttribute("aria-label"), /at the selected r = 10: 5$/);
  assert.equal(await mass.locator(".station").count(), 2);
  assert.equal(await page.locator(".profiles svg").count(), 5);
  assert.equal(await page.locator("#stations [style]").count(), 0);
});

sheetTest("a grid for screen readers: one stop of the tab key, names and places", "tm4760", async (page) => {
  const grid = page.getByRole("grid", { name: "Stations of the blade" });
  assert.equal(await grid.locator('td[tabindex="0"]').count(), 1);
  assert.equal(await grid.getAttribute("aria-colcount"), "12");
  assert.equal(await grid.getAttribute("aria-rowcount"), "33");
  const indices = await grid.locator("tr").evaluateAll((all) => all.map((row) => Number(row.getAttribute("aria-rowindex"))));
  assert.deepEqual(
    indices,
    indices.map((_, i) => i + 1),
  );
  await page
    .getByRole("columnheader", { name: /^mass lb\/in/ })
    .first()
    .waitFor();
  const unnamed = await page.evaluate(() =>
    [...document.querySelectorAll("#stations :is(button, input, select, textarea)")]
      .filter((one) => !one.getAttribute("aria-label") && !one.labels?.length && !one.textContent.trim())
      .map((one) => one.outerHTML),
  );
  assert.deepEqual(unnamed, []);
  await click(page, 0, 1);
  const ring = await cell(page, 0, 1).evaluate((td) => getComputedStyle(td).outlineStyle);
  assert.equal(ring, "solid");
});

for (const [width, height] of [
  [390, 844],
  [1280, 800],
]) {
  for (const colorScheme of ["light", "dark"]) {
    sheetTest(
      `at ${width} px, ${colorScheme}: the sheet scrolls, the page does not`,
      "tm4760",
      async (page) => {
        await click(page, 3, 1);
        await type(page, "-1", "Enter");
        await page.locator('.sheet td[aria-invalid="true"]').waitFor();
        await cell(page, 3, 7).scrollIntoViewIfNeeded();
        assert.equal(await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth), 0);
        if (width === 390) assert.ok(await page.locator(".sheet-scroll").evaluate((host) => host.scrollWidth > host.clientWidth));
        await page.screenshot({ path: `${screenshots}${width}-${colorScheme}-stations.png`, fullPage: true });
      },
      { viewport: { width, height }, colorScheme },
    );
  }
}
