// The page in Chromium, as its users drive it.

import assert from "node:assert/strict";
import { test } from "node:test";
import { call, downloaded, drawn, frequencies, open, pageTest, paste, rows, screenshots, site } from "./support.mjs";

const label = (page) => page.locator("#chart > svg:not(.overlay)").getAttribute("aria-label");
/** The table, once it stands at this speed. */
async function tableAt(page, speed) {
  await page.locator("#numbers-title").filter({ hasText: speed }).waitFor();
  return frequencies(page);
}
async function built(page, name) {
  const { value } = await call(page, "built_in_blades");
  return value.find((blade) => blade.name === name).toml;
}
/** Sets the slider as dragging would. */
function slide(page, value) {
  return page.locator("#speed-slider").evaluate((slider, value) => {
    slider.value = value;
    slider.dispatchEvent(new Event("input", { bubbles: true }));
  }, value);
}

pageTest("the first visit shows the TM 4760 blade and says what to try", {}, async (page) => {
  assert.equal(await page.locator("#blade-choice").inputValue(), "tm4760");
  assert.match(await page.locator("#hint").textContent(), /TM 4760.*[Dd]rag/);
  const table = await tableAt(page, "660 rpm, nominal");
  const { value } = await call(page, "modes", (await call(page, "parse_blade", await built(page, "tm4760"))).value);
  assert.deepEqual(table, Object.fromEntries(value.modes.map((mode) => [mode.label, mode.frequency_rad_s])));
  assert.match(await page.locator("#closest").textContent(), /^1F is 0\.05\/rev above 1P at 660 rpm/);
  assert.match(await page.locator("#model").textContent(), /; coupled, in vacuum, pitch 0°/);
});

pageTest("every built-in blade draws all three charts", {}, async (page) => {
  const { value } = await call(page, "built_in_blades");
  assert.ok(value.length >= 5, `${value.length} blades`);
  for (const blade of value) {
    await page.locator("#blade-choice").selectOption(blade.name);
    for (const [tab, kind] of [
      ["fan", "Fan chart"],
      ["shapes", "Mode shapes"],
      ["converge", "Convergence"],
    ]) {
      await page.locator(`#tab-${tab}`).click();
      await page.locator(`#chart > svg[aria-label="${kind} of ${blade.title}"]`).waitFor();
      assert.ok((await page.locator("#chart [data-label]").count()) >= 3, `${blade.name} ${tab}`);
    }
    assert.equal(await page.locator("#faults li, #solve-faults li").count(), 0);
  }
});

pageTest("a pasted blade is solved", {}, async (page) => {
  await paste(page, (await built(page, "uniform")).replace(/name = ".*"/, 'name = "pasted blade"'));
  await page.locator('#chart > svg[aria-label="Fan chart of pasted blade"]').waitFor();
  assert.equal(await page.locator("#blade-choice").inputValue(), "");
  assert.equal(await page.title(), "pasted blade – bladefan");
});

pageTest("a pasted JSON blade is solved", {}, async (page) => {
  const { value } = await call(page, "parse_blade", await built(page, "sa330"));
  await paste(page, JSON.stringify({ ...value, name: "from JSON" }, null, 2));
  await page.locator('#chart > svg[aria-label="Fan chart of from JSON"]').waitFor();
});

pageTest("a file is opened, and one dropped on the page", {}, async (page) => {
  const text = await built(page, "uniform");
  const named = (name) => text.replace(/name = ".*"/, `name = "${name}"`);
  await page.locator("#file-input").setInputFiles({ name: "mine.toml", mimeType: "", buffer: Buffer.from(named("opened")) });
  await page.locator('#chart > svg[aria-label="Fan chart of opened"]').waitFor();
  const dropped = await page.evaluateHandle((text) => {
    const data = new DataTransfer();
    data.items.add(new File([text], "mine.toml"));
    return data;
  }, named("dropped"));
  await page.dispatchEvent("body", "drop", { dataTransfer: dropped });
  await page.locator('#chart > svg[aria-label="Fan chart of dropped"]').waitFor();
});

pageTest("a bad file shows its faults at their lines, and the last good chart stays", {}, async (page) => {
  const good = await built(page, "tm4760");
  const bad = good.replace(/radius = .*/, "radius = -1.0").replace(/root = "hinged"/, 'root = "hinge"');
  await page.locator("#tab-text").click();
  const lineOf = (text) => bad.split("\n").findIndex((line) => line.startsWith(text)) + 1;
  const expected = (await call(page, "parse_blade", bad)).faults;
  assert.deepEqual(
    expected.map((fault) => fault.line),
    [lineOf("radius = -1.0"), lineOf('root = "hinge"')],
  );

  await paste(page, bad);
  await page.locator("#faults li").first().waitFor();
  assert.deepEqual(
    await page.locator("#faults li").allTextContents(),
    expected.map((fault) => `line ${fault.line}: ${fault.path}: ${fault.message}`),
  );
  assert.deepEqual(
    await page.locator(".gutter .fault").allTextContents(),
    expected.map((fault) => String(fault.line)),
  );
  assert.equal(await page.locator("#editor .mark").count(), 2);
  assert.match(await page.locator("#fault-summary").textContent(), /^2 faults/);
  assert.equal(await page.locator("#blade-text").getAttribute("aria-invalid"), "true");
  assert.equal(await page.locator("#last-good").isVisible(), true);
  assert.equal(await label(page), "Fan chart of TM 4760 research blade");

  // A click leads to the place.
  await page.locator("#faults button").nth(1).click();
  const selected = await page.locator("#blade-text").evaluate((text) => ({
    focused: document.activeElement === text,
    before: text.value.slice(0, text.selectionStart).split("\n").length,
    words: text.value.slice(text.selectionStart, text.selectionEnd),
  }));
  assert.equal(selected.focused, true);
  assert.equal(selected.before, expected[1].line);
  assert.match(selected.words, /hinge/);

  await paste(page, good);
  await page.locator("#last-good").waitFor({ state: "hidden" });
  assert.equal(await page.locator("#faults li, #editor .mark").count(), 0);
});

pageTest("text that is no blade at all shows its faults", {}, async (page) => {
  for (const text of ["", "radius =", "{", "[[[[", "\u0000\u{1F4A9} = 1"]) {
    await paste(page, text);
    await page.locator("#faults li").first().waitFor();
    await paste(page, await built(page, "uniform"));
    await page.locator("#faults").waitFor({ state: "hidden" });
  }
});

pageTest("the slider moves the table, the line and the margins", { model: "uncoupled" }, async (page) => {
  const nominal = await tableAt(page, "660 rpm");
  const line = page.locator(".overlay line");
  const x = Number(await line.getAttribute("x1"));
  await slide(page, 330);
  const half = await tableAt(page, "Frequencies at 330 rpm");
  assert.ok(half["1F"] < 0.6 * nominal["1F"], "1F follows the rotor");
  assert.equal(half["1F"] === nominal["1F"], false);
  assert.ok(Number(await line.getAttribute("x1")) < x);
  const { value: blade } = await call(page, "parse_blade", await built(page, "tm4760"));
  const { value } = await call(page, "margins", blade, { speed: "330rpm", model: "uncoupled" });
  const words = Object.fromEntries((await rows(page)).map((row) => [row[0], row[6]]));
  for (const margin of value) assert.match(words[margin.label], new RegExp(`(above|below|on) ${margin.nearest_harmonic}P$`));

  await page.locator("#nominal").click();
  assert.deepEqual(await tableAt(page, "660 rpm, nominal"), nominal);
  await slide(page, 0);
  const rest = await tableAt(page, "Frequencies at 0 rpm");
  assert.equal(rest["1F"], 0);
  assert.deepEqual((await rows(page))[0], ["1F", "0", "0", "–", "exact", "0 %", "–"]);
});

pageTest("the speed is dragged on the chart, typed, and shown in other units", {}, async (page) => {
  const line = await page.locator(".overlay line").boundingBox();
  await page.mouse.move(line.x, line.y + line.height / 2);
  await page.mouse.down();
  await page.mouse.move(line.x - 100, line.y + line.height / 2, { steps: 5 });
  await page.mouse.up();
  const dragged = Number(await page.locator("#speed-number").inputValue());
  assert.ok(dragged > 300 && dragged < 640, `${dragged} rpm`);
  await tableAt(page, `Frequencies at ${dragged} rpm`);

  await page.locator("#speed-number").fill("600");
  await tableAt(page, "Frequencies at 600 rpm");
  await page.locator("#speed-unit").selectOption("Hz");
  await tableAt(page, "Frequencies at 10 Hz");
  await page.locator("#chart svg text", { hasText: "rotor speed [Hz]" }).waitFor();
  await page.locator("#frequency-unit").selectOption("Hz");
  await page.locator("#chart svg text", { hasText: "frequency [Hz]" }).waitFor();
});

pageTest("options reach the solver and their faults stand where they were made", { model: "uncoupled" }, async (page) => {
  assert.equal(await page.locator("#paper-column").textContent(), "paper N=15");
  await page.locator("#option-modes").fill("2");
  await page.waitForFunction(() => document.querySelectorAll("#modes tbody tr").length === 6);
  await page.locator("#option-functions").fill("0");
  await page.locator("#solve-faults li", { hasText: "functions" }).first().waitFor();
  assert.equal(await page.locator("#option-functions").getAttribute("aria-invalid"), "true");
  await page.locator("#option-functions").fill("20");
  await page.locator("#paper-column", { hasText: "N=20" }).waitFor();
  await page.locator("#solve-faults").waitFor({ state: "hidden" });
});

pageTest("downloads arrive and hold what the page shows", {}, async (page) => {
  const download = (what) =>
    downloaded(page, async () => {
      await page.locator("#download summary").click();
      await page.locator(`#download-${what}`).click();
    });
  const { value: blade } = await call(page, "parse_blade", await built(page, "tm4760"));

  const svg = await download("svg");
  assert.equal(svg.name, "tm-4760-research-blade-fan.svg");
  const text = svg.bytes.toString();
  const width = Number(/viewBox="0 0 (\d+)/.exec(text)[1]);
  const drawing = await call(page, "chart_svg", "fan", blade, { theme: "light", width, speed_unit: "rpm", frequency_unit: "rad/s" });
  assert.equal(text, drawing.value.svg);

  const csv = await download("csv");
  assert.equal(csv.name, "tm-4760-research-blade-fan.csv");
  const [header, ...lines] = csv.bytes
    .toString()
    .trimEnd()
    .split("\n")
    .map((line) => line.split(","));
  const { value: fan } = await call(page, "fan", blade);
  assert.deepEqual(header, ["rotor speed [rad/s]", ...fan.branches.map((branch) => `${branch.label} [rad/s]`)]);
  assert.deepEqual(
    lines.map((line) => Number(line[0])),
    fan.speeds_rad_s,
  );
  fan.branches.forEach((branch, i) =>
    assert.deepEqual(
      lines.map((line) => Number(line[i + 1])),
      branch.frequency_rad_s,
    ),
  );

  const json = await download("json");
  assert.deepEqual(JSON.parse(json.bytes), fan);

  const png = await download("png");
  assert.equal(png.bytes.subarray(1, 4).toString(), "PNG");
  assert.equal(png.bytes.readUInt32BE(16), 1920);

  const file = await download("toml");
  assert.equal(file.name, "tm-4760-research-blade.toml");
  assert.equal(file.bytes.toString(), await built(page, "tm4760"));

  await page.locator("#tab-shapes").click();
  await page.locator('#chart > svg[aria-label^="Mode shapes"]').waitFor();
  const shapes = await download("csv");
  assert.match(shapes.bytes.toString().split("\n")[0], /^r \[m\],1F flap,1F flap slope \[1\/m\],1F flap moment \[N·m\]/);
  assert.equal(shapes.bytes.toString().trimEnd().split("\n").length, 102);
});

pageTest("light and dark: the system's choice, the button's, and the chart's colours", { colorScheme: "dark" }, async (page) => {
  const dark = () => page.evaluate(() => getComputedStyle(document.body).colorScheme === "dark" || document.documentElement.dataset.theme === "dark");
  const background = () => page.locator("#chart > svg:not(.overlay)").evaluate((svg) => svg.querySelector("rect, polygon").getAttribute("fill"));
  assert.equal(await dark(), true);
  const before = await background();
  await page.locator("#theme").click();
  assert.equal(await dark(), false);
  await page.waitForFunction((old) => document.querySelector("#chart > svg").querySelector("rect, polygon").getAttribute("fill") !== old, before);
  await page.reload();
  await drawn(page);
  assert.equal(await dark(), false, "the choice is remembered");
});

pageTest("everything works from the keyboard", {}, async (page) => {
  const focused = () => page.evaluate(() => document.activeElement.id || document.activeElement.textContent.trim());
  const seen = new Set();
  for (let i = 0; i < 200; i++) {
    await page.keyboard.press("Tab");
    const here = await focused();
    if (i > 10 && here === "blade-choice") break;
    seen.add(here);
  }
  const ids = [
    "blade-choice",
    "open-file",
    "units",
    "share",
    "Save",
    "theme",
    "tab-fan",
    "show-flap",
    "frequency-unit",
    "speed-slider",
    "speed-number",
    "speed-unit",
  ];
  for (const id of [
    ...ids,
    "what-if-factors-flap_stiffness",
    "field-name",
    "field-rotor.radius",
    "field-flap.root",
    "option-modes",
    "option-harmonics",
  ]) {
    assert.ok(seen.has(id), `${id} is reached by Tab: ${[...seen].join(", ")}`);
  }
  await page.locator("#tab-fan").focus();
  await page.keyboard.press("ArrowRight");
  assert.equal(await focused(), "tab-shapes");
  await page.locator('#chart > svg[aria-label^="Mode shapes"]').waitFor();
  await page.locator("#speed-slider").focus();
  await page.keyboard.press("ArrowLeft");
  await page.locator("#numbers-title").filter({ hasNotText: "nominal" }).waitFor();
  await page.locator("#download summary").focus();
  await page.keyboard.press("Enter");
  await page.keyboard.press("Tab");
  assert.equal(await focused(), "download-toml");
  await page.keyboard.press("Escape");
  assert.equal(await page.locator("#download-svg").isVisible(), false);
});

pageTest("every control has a name", {}, async (page) => {
  const unnamed = await page.evaluate(() =>
    [...document.querySelectorAll("button, input, select, textarea")]
      .filter((control) => !control.getAttribute("aria-label") && !control.labels?.length && !control.textContent.trim())
      .map((control) => control.outerHTML),
  );
  assert.deepEqual(unnamed, []);
});

pageTest("markup in a blade's texts stays text", {}, async (page) => {
  await page.evaluate(() => (window.broken = false));
  const evil = "<script>window.broken=true</script><img src=x onerror=window.broken=true>&amp;\\\"'";
  const text = (await built(page, "uniform")).replace(/name = ".*"/, `name = "${evil}"`).replace("[rotor]", `[rotor]\n"<b onclick=x>" = 1`);
  await paste(page, text);
  await page.locator("#faults li", { hasText: "<b onclick=x>" }).waitFor();
  await paste(page, text.replace('\n"<b onclick=x>" = 1', ""));
  await page.locator('#chart > svg[aria-label*="<script>"]').waitFor();
  assert.equal(await page.evaluate(() => window.broken), false);
  assert.equal(await page.locator("main script, main img, main b").count(), 0);
  assert.match(await page.locator("#chart > svg:not(.overlay)").textContent(), /<script>/);
});

test("the page's policy stops scripts in markup and requests to other hosts", async () => {
  const { page, close } = await open();
  try {
    const stopped = await page.evaluate(async () => {
      const stopped = [];
      addEventListener("securitypolicyviolation", (event) => stopped.push(event.effectiveDirective));
      const script = document.createElement("script");
      script.append("window.inline = true");
      document.body.append(script);
      // A drawing with a script in it, by the page's own way for drawings.
      const { src } = document.querySelector("script[type=module]");
      const { parsedSvg } = await import(new URL("../lib/trusted.js", src));
      const drawing = document.adoptNode(parsedSvg('<svg xmlns="http://www.w3.org/2000/svg" onclick="window.inline = true"/>').documentElement);
      document.body.append(drawing);
      drawing.dispatchEvent(new Event("click"));
      const refused = [];
      for (const [name, sink] of Object.entries({
        markup: () => (document.createElement("p").innerHTML = "<b>"),
        drawing: () => new DOMParser().parseFromString("<svg/>", "image/svg+xml"),
        worker: () => new Worker("solver/worker.js"),
        policy: () => trustedTypes.createPolicy("another", {}),
      })) {
        try {
          sink();
        } catch {
          refused.push(name);
        }
      }
      await fetch("http://127.0.0.2:9/").catch(() => {});
      await new Promise((resolve) => setTimeout(resolve, 300)); // violations are told of later
      return { inline: window.inline, refused, stopped: [...new Set(stopped)].sort() };
    });
    assert.deepEqual(stopped, {
      inline: undefined,
      refused: ["markup", "drawing", "worker", "policy"],
      stopped: ["connect-src", "require-trusted-types-for", "script-src-attr", "trusted-types"],
    });
  } finally {
    await close();
  }
});

test("a page whose solver cannot be loaded says so, and another try brings it", async () => {
  const context = await site.browser.newContext();
  try {
    const page = await context.newPage();
    let gone = true;
    await page.route("**/*.wasm", (route) => (gone ? route.abort() : route.continue()));
    await page.goto(site.origin);
    await page.locator("#solve-faults li", { hasText: "the solver could not be loaded" }).waitFor();
    gone = false;
    await page.locator("#solve-faults button", { hasText: "Try again" }).click();
    await drawn(page);
    await page.locator("#solve-faults").waitFor({ state: "hidden" });
  } finally {
    await context.close();
  }
});

test("a solver that breaks off is replaced, and the page goes on", async () => {
  const context = await site.browser.newContext();
  try {
    const page = await context.newPage();
    // The real worker, which once dies in the middle of a call.
    await page.route("**/worker.js", async (route) => {
      const response = await route.fetch();
      const body = `${await response.text()}
        const answer = onmessage;
        onmessage = (event) => {
          if (event.data.args?.[1]?.speed === "123rpm") throw new Error("out of memory");
          return answer(event);
        };`;
      await route.fulfill({ response, body });
    });
    await page.goto(site.origin);
    await drawn(page);
    await page.locator("#speed-number").fill("123");
    await page.locator("#solve-faults li", { hasText: "broke off" }).waitFor();
    await page.locator("#speed-number").fill("600");
    await tableAt(page, "Frequencies at 600 rpm");
    await page.locator("#solve-faults").waitFor({ state: "hidden" });
  } finally {
    await context.close();
  }
});

for (const [width, height] of [
  [360, 740],
  [390, 844],
  [768, 1024],
  [1280, 800],
  [1920, 1080],
]) {
  for (const colorScheme of ["light", "dark"]) {
    pageTest(
      `at ${width} px, ${colorScheme}: no sideways scrolling, the chart above the fold`,
      { viewport: { width, height }, colorScheme },
      async (page) => {
        for (const tab of ["fan", "shapes", "converge", "stations", "text"]) {
          await page.locator(`#tab-${tab}`).click();
          await page.locator(`#chart > svg[aria-label^="${{ shapes: "Mode", converge: "Conv" }[tab] ?? "Fan"}"]`).waitFor();
          const fits = await page.evaluate(() => ({
            sideways: document.documentElement.scrollWidth - document.documentElement.clientWidth,
            chartEnd: document.getElementById("chart").getBoundingClientRect().bottom + scrollY,
          }));
          assert.equal(fits.sideways, 0);
          if (tab === "fan") assert.ok(fits.chartEnd <= height, `the chart ends at ${fits.chartEnd}`);
          await page.screenshot({ path: `${screenshots}${width}-${colorScheme}-${tab}.png`, fullPage: true });
        }
      },
    );
  }
}
