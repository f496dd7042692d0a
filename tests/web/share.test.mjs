// Blades that leave the page and come back: link, memory, files, no network.

import assert from "node:assert/strict";
import { test } from "node:test";
import { checked, contentOf, pack, unpack } from "../../web/app/pack.js";
import { isBladeShaped } from "../../web/blade/shape.js";
import { NEUTRAL } from "../../web/lib/what-if.js";
import { drawn, frequencies, open, pageTest, paste, site } from "./support.mjs";

const state = {
  doc: { schema: "bladefan-blade/1", rotor: { radius: 2 } },
  text: null,
  choice: "",
  tab: "shapes",
  speed: { value: 300, unit: "rpm" },
  speedUnit: "rpm",
  frequencyUnit: "Hz",
  dofs: ["flap"],
  closeDofs: ["lag"],
  band: [0.8, 1.2],
  window: null,
  chosen: "2F",
  model: "uncoupled",
  options: { modes: "4" },
  measured: "a,b",
  whatIf: NEUTRAL,
};
const UNIFORM = `schema = "bladefan-blade/1"
name = "uniform, sent"
rotor = { radius = 1, nominal_speed = 1 }
flap = { root = "hingeless" }
lag = { root = "hingeless" }
torsion = { root = "rigid" }
distribution = { mass = 1, flap_stiffness = 1, lag_stiffness = 1, torsion_stiffness = 1, polar_inertia = 1 }
`;
const words = async (packed) =>
  unpack(packed).then(
    () => "read",
    (error) => error.message,
  );

test("what is packed is unpacked", async () => {
  const { blade, choice, view } = await unpack(await pack(state));
  assert.deepEqual(blade, state.doc);
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
  const odd = {
    tab: "nowhere",
    closeDofs: ["flap", "flap"],
    speed: { value: -1, unit: "rpm" },
    dofs: [],
    band: "wide",
    options: { modes: 4 },
    whatIf: { factors: { mass: -2 } },
    window: { speeds: ["a"] },
  };
  const { view } = await unpack(await pack({ ...state, ...odd }));
  assert.deepEqual(Object.keys(view).sort(), ["chosen", "frequencyUnit", "measured", "model", "speedUnit"]);
});

test("a view is held to what a page may be asked for", async () => {
  const ask = async (count, modes) => {
    const { refused, view } = await unpack(await pack({ ...state, window: { speeds: [0, 60, count] }, options: { modes } }));
    return [refused, view.window];
  };
  assert.deepEqual(await ask(101, "50"), [null, { speeds: [0, 60, 101] }]);
  assert.deepEqual(await ask(2001, "20"), [null, { speeds: [0, 60, 2001] }]);
  assert.deepEqual(await ask(2002, "1"), [
    "It asks for 2002 rotor speeds with 1 modes each; at most 2001 are taken. The whole chart is shown instead.",
    null,
  ]);
  assert.deepEqual(await ask(2001, "21"), [
    "It asks for 2001 rotor speeds with 21 modes each; at most 1905 are taken. The whole chart is shown instead.",
    null,
  ]);
  assert.deepEqual((await ask(100_000, "50"))[1], null);
});

test("what is beside an unfinished blade is kept with it", () => {
  const unfinished = { ...state, faults: [{ path: "rotor.radius" }], good: { name: "good" }, draft: "radius =" };
  const { good, draft, refused } = checked(JSON.parse(JSON.stringify(contentOf(unfinished))));
  assert.deepEqual([good, draft, refused], [{ name: "good" }, "radius =", null]);
  assert.deepEqual(Object.keys(contentOf({ ...unfinished, faults: [], draft: null })), ["blade", "choice", "view"]);
  assert.deepEqual([checked({ blade: {}, good: 7, draft: [] }).good, checked({ blade: {}, draft: [] }).draft], [null, null]);
  assert.throws(() => checked({ blade: 7 }), /holds no blade/);
});

test("what has the form of a blade may be shown with its faults, and nothing else", () => {
  const root = { root: "hinged", offset: "x" };
  for (const good of [
    {},
    { rotor: { radius: -1 }, flap: root },
    { distribution: { r: [0, null, "x"], mass: "a lot", twist: { r: [], values: [1] } } },
    { rotor: { pitch: 8, spring_angle: "pitch" }, point_mass: [{ r: 2, mass: "heavy" }, {}] },
  ])
    assert.ok(isBladeShaped(good), JSON.stringify(good));
  for (const bad of [
    null,
    [],
    7,
    { rotor: 7 },
    { flap: { root: {} } },
    { distribution: [] },
    { distribution: { r: 7 } },
    { distribution: { mass: { r: 7, values: [] } } },
    { distribution: { mass: [[1]] } },
    { name: {} },
    { point_mass: { r: 2, mass: 1 } },
    { point_mass: [7] },
    { point_mass: [{ r: [2] }] },
  ]) {
    assert.ok(!isBladeShaped(bad), JSON.stringify(bad));
  }
});

test("a link carries blade and view to another browser", async () => {
  const first = await open({ model: "uncoupled" });
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

/** Opens the page again, as it would be after whatever stands in storage. */
async function again(page) {
  await page.reload();
  await drawn(page);
}

pageTest("a kept blade that is broken does no harm, and is set aside", {}, async (page) => {
  const entry = (more) => JSON.stringify([{ id: "a", packed: "1.x", name: "b", time: 1, ...more }]);
  const broken = [
    "{",
    "7",
    entry({}),
    '[{"id":1}]',
    entry({ time: 1e300 }),
    entry({ time: null }),
    entry({ packed: undefined, content: 7 }),
    entry({ packed: undefined, content: { blade: { rotor: [] } } }),
  ];
  for (const text of broken) {
    await page.evaluate((text) => localStorage.setItem("bladefan-blades", text), text);
    await again(page);
    if (!text.includes("rotor")) {
      assert.equal(await page.locator("#blade-choice").inputValue(), "tm4760", text);
      await page.locator("#message", { hasText: "set aside" }).waitFor();
      assert.equal(await page.evaluate(() => localStorage.getItem("bladefan-blades")), null, text);
    }
    assert.equal(await page.locator("#solve-faults li").count(), 0, text);
  }
  assert.ok(await page.evaluate(() => localStorage.getItem("bladefan-blades-unread").includes("1e+300")));
  // A good one beside a broken one is still there.
  await page.waitForTimeout(800);
  const good = { id: "g", name: "good one", time: 5, content: { blade: UNIFORM, choice: "", view: {} } };
  await page.evaluate((list) => localStorage.setItem("bladefan-blades", list), JSON.stringify([{ ...good, id: "bad", time: 1e300 }, good]));
  await again(page);
  await page.locator("#message", { hasText: /set aside.*Your blade is back/ }).waitFor();
  assert.match(await page.title(), /^uniform, sent/);
  // What another page put there meanwhile is not lost with the next edit.
  await page.evaluate(() => localStorage.setItem("bladefan-blades", "of another time"));
  await page.locator('[data-path="name"]').fill("edited");
  await page.waitForFunction(() => localStorage.getItem("bladefan-blades").includes("edited"));
  assert.ok(await page.evaluate(() => localStorage.getItem("bladefan-blades-unread").includes("of another time")));
  await page.locator("#download summary").click();
  await page.locator("#forget").click();
  assert.equal(await page.evaluate(() => localStorage.length), 0);
});

test("a storage that is full is said to be, and nothing else fails", async () => {
  const { page, complaints, close } = await open();
  try {
    await page.evaluate(() => {
      Storage.prototype.setItem = () => {
        throw new DOMException("full", "QuotaExceededError");
      };
    });
    await page.locator('[data-path="name"]').fill("mine");
    await page.locator("#message", { hasText: "This browser keeps no blades" }).waitFor();
    assert.equal(await page.locator("#solve-faults li").count(), 0);
    assert.deepEqual(complaints, []);
  } finally {
    await close();
  }
});

test("a browser without storage starts the page as ever", async () => {
  const context = await site.browser.newContext({ serviceWorkers: "block" });
  try {
    const page = await context.newPage();
    await page.addInitScript(() =>
      Object.defineProperty(window, "localStorage", {
        get: () => {
          throw new DOMException("denied", "SecurityError");
        },
      }),
    );
    await page.goto(site.origin);
    await drawn(page);
    assert.equal(await page.locator("#blade-choice").inputValue(), "tm4760");
    assert.equal(await page.locator("#solve-faults li").count(), 0);
  } finally {
    await context.close();
  }
});

pageTest("an unfinished blade comes back as it was, with its faults and the last chart", {}, async (page) => {
  await page.locator('[data-path="rotor.nominal_speed"]').fill("700");
  await page.locator("#numbers-title", { hasText: "700 rpm" }).waitFor();
  await page.locator('[data-path="rotor.radius"]').fill("-1");
  await page.locator('[data-fault-of="rotor.radius"]').waitFor();
  await again(page);
  await page.locator('[data-fault-of="rotor.radius"]').waitFor();
  await page.locator("#numbers-title", { hasText: "700 rpm" }).waitFor();
  assert.equal(await page.locator('[data-path="rotor.radius"]').inputValue(), "-1");
  assert.equal(await page.locator("#last-good").isVisible(), true);
  await page.locator("#tab-stations").click();
  assert.ok((await page.locator(".sheet tbody tr").count()) > 20);
  await page.locator("#undo").click();
  await page.locator('[data-fault-of="rotor.radius"]').waitFor({ state: "hidden" });
  assert.equal(await page.locator('[data-path="rotor.radius"]').inputValue(), "55");
  await page.locator("#redo").click();
  await page.locator('[data-fault-of="rotor.radius"]').waitFor();
});

pageTest("a text that is no blade yet comes back as it was typed", {}, async (page) => {
  const text = "# half a blade\n[rotor]\nradius = \n";
  await paste(page, text);
  await page.locator("#faults li").first().waitFor();
  const faults = await page.locator("#faults li").allTextContents();
  await page.waitForTimeout(600);
  await again(page);
  await page.locator("#faults li").first().waitFor();
  assert.equal(await page.locator("#blade-text").inputValue(), text);
  assert.deepEqual(await page.locator("#faults li").allTextContents(), faults);
  assert.equal(await page.locator("#tab-text").getAttribute("aria-selected"), "true");
  assert.match(await page.locator("#chart > svg").first().getAttribute("aria-label"), /^Fan chart of TM 4760/);
});

pageTest("after a link is shared a reload shows what was edited since, to the last letter", {}, async (page) => {
  await page.locator("#share").click();
  await page.locator("#message", { hasText: "link" }).waitFor();
  assert.ok(page.url().includes("#1."));
  await page.locator('[data-path="rotor.nominal_speed"]').fill("600");
  await page.locator("#numbers-title", { hasText: "600 rpm" }).waitFor();
  assert.ok(!page.url().includes("#"), "the address no longer holds it");
  await page.locator('[data-path="rotor.nominal_speed"]').fill("700");
  await again(page); // within the time that keeping waits
  await page.locator("#numbers-title", { hasText: "700 rpm" }).waitFor();
  // Typed, and gone before it was even read.
  await page.locator("#tab-text").click();
  await page.waitForFunction(() => document.getElementById("blade-text").value.includes("nominal_speed = 700"));
  const text = (await page.locator("#blade-text").inputValue()).replace("nominal_speed = 700", "nominal_speed = 800");
  await page.locator("#blade-text").fill(text);
  await again(page);
  await page.locator("#numbers-title", { hasText: "800 rpm" }).waitFor();
});

const asks = await pack({
  ...state,
  doc: null,
  text: UNIFORM,
  measured: "",
  chosen: "1F",
  tab: "fan",
  window: { speeds: [0, 1, 100_000] },
  options: { modes: "50" },
});
pageTest("a link that asks for more than a page should do says so and shows the whole chart", { fragment: `#${asks}` }, async (page) => {
  await page.locator("#message", { hasText: "It asks for 100000 rotor speeds with 50 modes each; at most 800 are taken" }).waitFor();
  assert.equal(await page.locator("#zoom-reset").isDisabled(), true);
  await page.waitForFunction(() => document.querySelectorAll("#modes tbody tr").length > 100);
});

const refused = await pack({ ...state, doc: null, text: UNIFORM, measured: "", tab: "fan", options: { modes: "51" }, speed: null });
test("what the solver refuses of a link is said by the page, which goes on", async () => {
  const page = await (await site.browser.newContext({ serviceWorkers: "block" })).newPage();
  try {
    await page.goto(`${site.origin}/#${refused}`);
    await page.locator("#solve-faults li", { hasText: "modes: must be from 1 to 50" }).waitFor();
    await page.locator("#option-modes").fill("3");
    await drawn(page);
  } finally {
    await page.context().close();
  }
});

pageTest("a file of 10 MB is refused, and nothing is lost", {}, async (page) => {
  const before = await frequencies(page);
  await page.locator("#file-input").setInputFiles({ name: "huge.toml", mimeType: "", buffer: Buffer.alloc(10_000_000, "#") });
  await page.locator("#message", { hasText: "huge.toml has 10 MB" }).waitFor();
  assert.deepEqual(await frequencies(page), before);
});
