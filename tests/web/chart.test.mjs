// The chart in Chromium: what lies over the drawing, what is read off it, and how fast it follows.

import assert from "node:assert/strict";
import { test } from "node:test";
import { call, drawn, open, pageTest } from "./support.mjs";

async function bladeOf(page, name) {
  const { value } = await call(page, "built_in_blades");
  return (await call(page, "parse_blade", value.find((blade) => blade.name === name).toml)).value;
}

/** The drawing of the page as the package makes it, with a branch's place on the screen at a speed. */
async function reference(page, more = {}) {
  const blade = await bladeOf(page, "tm4760");
  const width = await page.locator("#chart > svg:not(.overlay)").evaluate((svg) => svg.viewBox.baseVal.width);
  const { value } = await call(page, "chart_svg", "fan", blade, { width, speed_unit: "rpm", frequency_unit: "rad/s", ...more });
  const box = await page.locator("#chart").boundingBox();
  const { x, y, left, top, width: across, height: down } = value.plots[0];
  const scale = box.width / value.width;
  const place = (speed, frequency) => ({
    x: box.x + scale * (left + ((speed - x.from) / (x.to - x.from)) * across),
    y: box.y + scale * (top + down - ((frequency - y.from) / (y.to - y.from)) * down),
  });
  return { blade, value, place, scale };
}

const readout = (page) => page.locator(".readout > div").allTextContents();
/** What the page's state draws now: both axes as the frame's labels say. */
const labels = (page) =>
  page
    .locator("#chart > svg:not(.overlay) .axes text")
    .allTextContents()
    .then((all) => all.map((text) => text.trim()));

pageTest("hovering reads the branch under the pointer, never off its curve", {}, async (page) => {
  const { blade, place } = await reference(page);
  for (const rpm of [37, 333, 612.5]) {
    const { value } = await call(page, "modes", blade, { speed: `${rpm}rpm` });
    const mode = value.modes.find(({ label }) => label === "4F");
    const at = place(rpm, mode.frequency_rad_s);
    await page.mouse.move(at.x, at.y + 3);
    // The numbers come from the solver's worker.
    await page.waitForFunction((rpm) => {
      const shown = document.querySelector(".readout:not([hidden]) > div")?.textContent;
      return shown?.startsWith("4F at ") && Math.abs(Number(shown.split(" ")[2]) - rpm) < 1;
    }, rpm);
    const [title, numbers, margin] = await readout(page);
    const [, label, speed] = /^(\w+) at ([\d.]+) rpm$/.exec(title);
    assert.equal(label, "4F");
    assert.ok(Math.abs(speed - rpm) < 1, title);
    const [, rad, hz, ratio] = /^([\d.]+) rad\/s, ([\d.]+) Hz, ([\d.]+)\/rev$/.exec(numbers);
    assert.ok(Math.abs(rad / mode.frequency_rad_s - 1) < 2e-3, numbers);
    assert.ok(Math.abs(hz / mode.frequency_hz - 1) < 2e-3, numbers);
    assert.ok(Math.abs(ratio / mode.per_rev - 1) < 0.05, numbers);
    assert.match(margin, /^(\d\.\d+\/rev (above|below)|on) \d+P$/);
    const dot = await page.locator(".hover circle").boundingBox();
    assert.ok(Math.abs(dot.y + dot.height / 2 - at.y) < 1.5, "the dot lies on the curve");
  }
  await page.mouse.move(5, 5);
  await page.locator(".readout").waitFor({ state: "hidden" });
});

test("between the report's speeds a branch is read to a millionth", async () => {
  const { page, close } = await open();
  try {
    const blade = await bladeOf(page, "tm4760");
    const { value: fan } = await call(page, "fan", blade, { model: "uncoupled" });
    for (const [i, part] of [
      [1, 0.4],
      [30, 0.5],
      [77, 0.9],
      [99, 0.5],
    ]) {
      const speed = fan.speeds_rad_s[i] + part * (fan.speeds_rad_s[i + 1] - fan.speeds_rad_s[i]);
      const { value } = await call(page, "modes", blade, { speed, model: "uncoupled" });
      const { value: readings } = await call(page, "at_speed", fan, speed);
      for (const mode of value.modes) {
        const read = readings.find(({ label }) => label === mode.label).frequency_rad_s;
        assert.ok(Math.abs(read / mode.frequency_rad_s - 1) < 1e-6, `${mode.label} at ${speed}: ${read}, ${mode.frequency_rad_s}`);
      }
    }
  } finally {
    await close();
  }
});

pageTest("the keys go along a branch and from branch to branch, and say so", { model: "uncoupled" }, async (page) => {
  await page.locator("#chart").focus();
  assert.match(
    await page.locator("#chart").getAttribute("aria-label"),
    /^Fan chart of TM 4760.*: 15 branches; at nominal speed 1F is closest to a harmonic, 0\.05\/rev above 1P\./,
  );
  const said = page.locator("#chart-said");
  /** What is said after a key, once the solver has told the numbers. */
  async function after(key) {
    const before = await said.textContent();
    await page.keyboard.press(key);
    await page.waitForFunction((before) => document.getElementById("chart-said").textContent !== before, before);
    return said.textContent();
  }
  const begun = await after("ArrowRight");
  const first = /^(\w+) at ([\d.]+) rpm, [\d.]+ rad\/s, /.exec(begun);
  assert.ok(first, begun);
  const second = /^(\w+) at ([\d.]+) rpm/.exec(await after("ArrowRight"));
  assert.equal(second[1], first[1]);
  assert.ok(Number(second[2]) > Number(first[2]));
  const third = /^(\w+) at ([\d.]+) rpm/.exec(await after("ArrowUp"));
  assert.notEqual(third[1], second[1]);
  assert.equal(third[2], second[2]);
  assert.match(await after("Home"), /at 0 rpm, /);
  await page.keyboard.press("End");
  await page.keyboard.press("Enter");
  assert.equal(await page.locator("#speed-number").inputValue(), "792");
  await page.keyboard.press("Escape");
  assert.equal(await page.locator(".readout").isVisible(), false);
});

pageTest("the line of the rotor speed is dragged and moved by keys, and its dots stay on the curves", {}, async (page) => {
  const { place } = await reference(page);
  const from = place(660, 500);
  const to = place(300, 500);
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(to.x, to.y, { steps: 6 });
  await page.mouse.up();
  const dragged = Number(await page.locator("#speed-number").inputValue());
  assert.ok(Math.abs(dragged - 300) < 4, `${dragged}`);
  const handle = page.locator(".speed-handle");
  assert.equal(await handle.getAttribute("role"), "slider");
  const before = Number(await handle.getAttribute("aria-valuenow"));
  await handle.focus();
  await page.keyboard.press("ArrowRight");
  const after = Number(await handle.getAttribute("aria-valuenow"));
  assert.ok(after > before && after < before + 10, `${before} ${after}`);
  assert.equal(await handle.getAttribute("aria-valuetext"), `${after} rpm`);
  const x = Number(await page.locator(".overlay line").getAttribute("x1"));
  for (const cx of await page.locator(".mark circle").evaluateAll((all) => all.map((dot) => Number(dot.getAttribute("cx"))))) assert.equal(cx, x);
  await page.keyboard.press("Home");
  assert.equal(await page.locator("#speed-number").inputValue(), "0");
});

pageTest("degrees of freedom, harmonics and units change what is drawn", {}, async (page) => {
  await page.locator("#show-lag").uncheck();
  await page.waitForFunction(() => document.querySelectorAll('#chart [data-label="1L"]').length === 0);
  assert.ok((await page.locator('#chart [data-label="1F"]').count()) > 0);
  await page.locator("#option-harmonics").fill("4");
  await page.waitForFunction(() => !document.querySelector("#chart > svg").textContent.includes("10P"));
  const units = await page.locator("#frequency-unit option").allTextContents();
  const { value: about } = await call(page, "about");
  assert.equal(units.length, about.frequency_units.length);
  for (const unit of units) {
    await page.locator("#frequency-unit").selectOption({ label: unit });
    await page.locator("#chart svg text", { hasText: `frequency [${unit}]` }).waitFor();
    assert.ok((await page.locator(".mark circle").count()) > 0, `dots in ${unit}`);
  }
});

pageTest("a window is zoomed by box, wheel, keys and buttons, and reset", {}, async (page) => {
  const { place } = await reference(page);
  const whole = await labels(page);
  const drag = async (a, b) => {
    await page.mouse.move(a.x, a.y);
    await page.mouse.down();
    await page.mouse.move(b.x, b.y, { steps: 4 });
    await page.mouse.up();
  };
  const changed = (from) =>
    page.waitForFunction(
      (old) => [...document.querySelectorAll("#chart > svg:not(.overlay) .axes text")].map((text) => text.textContent.trim()).join() !== old,
      from.join(),
    );
  const same = (to) =>
    page.waitForFunction(
      (old) => [...document.querySelectorAll("#chart > svg:not(.overlay) .axes text")].map((text) => text.textContent.trim()).join() === old,
      to.join(),
    );

  await page.locator("#zoom-box").click();
  await drag(place(400, 300), place(700, 700));
  await changed(whole);
  const speeds = (await labels(page)).map(Number).filter(Number.isFinite);
  assert.ok(speeds.includes(500) && !speeds.includes(100), speeds.join());
  assert.equal(await page.locator("#speed-number").inputValue(), "660", "the box leaves the speed alone");
  assert.equal(await page.locator("#zoom-box").getAttribute("aria-pressed"), "false");

  // The window keeps its place in another unit.
  await page.locator("#frequency-unit").selectOption("Hz");
  await page.locator("#chart svg text", { hasText: "frequency [Hz]" }).waitFor();
  const hertz = (await labels(page)).map(Number).filter(Number.isFinite);
  assert.ok(Math.max(...hertz.filter((value) => value < 300)) <= 700 / (2 * Math.PI) + 1, hertz.join());
  await page.locator("#frequency-unit").selectOption("rad/s");
  await page.locator("#chart svg text", { hasText: "frequency [rad/s]" }).waitFor();

  const middle = place(400, 400);
  await page.mouse.dblclick(middle.x, middle.y);
  await same(whole);
  assert.equal(await page.locator("#zoom-reset").isDisabled(), true);
  assert.equal(await page.locator("#speed-number").inputValue(), "660", "a double click leaves the speed as it was");

  for (const zoom of [
    async () => {
      await page.keyboard.down("Control");
      await page.mouse.wheel(0, -240);
      await page.keyboard.up("Control");
    },
    () => page.locator("#zoom-in").click(),
    async () => {
      await page.keyboard.down("Shift");
      await drag(place(200, 200), place(500, 600));
      await page.keyboard.up("Shift");
    },
    async () => {
      await page.locator("#chart").focus();
      await page.keyboard.press("+");
    },
  ]) {
    await zoom();
    await changed(whole);
    await page.locator("#zoom-reset").click();
    await same(whole);
  }
  // Beyond the whole: the branches above come into view.
  await page.locator("#zoom-out").click();
  await changed(whole);
  assert.equal(await page.locator("#solve-faults li").count(), 0);
});

pageTest("two fingers zoom", { hasTouch: true, viewport: { width: 390, height: 844 } }, async (page) => {
  const whole = await labels(page);
  const { place } = await reference(page);
  const middle = place(400, 500);
  const session = await page.context().newCDPSession(page);
  const touch = (type, apart) =>
    session.send("Input.dispatchTouchEvent", {
      type,
      touchPoints:
        apart === null
          ? []
          : [
              { x: middle.x - apart, y: middle.y, id: 1 },
              { x: middle.x + apart, y: middle.y, id: 2 },
            ],
    });
  await touch("touchStart", 30);
  for (const apart of [40, 50, 60, 70]) await touch("touchMove", apart);
  await touch("touchEnd", null);
  await page.waitForFunction(
    (old) => [...document.querySelectorAll("#chart > svg:not(.overlay) .axes text")].map((text) => text.textContent.trim()).join() !== old,
    whole.join(),
  );
  assert.equal(await page.locator("#zoom-reset").isDisabled(), false);
});

pageTest("the band's edges are dragged and moved by keys, and its crossings stand in words", {}, async (page) => {
  const note = page.locator("#band-note");
  const { value } = await reference(page);
  const { report } = value;
  const nominal = report.nominal.speed_rad_s;
  const inside = report.crossings.filter(({ speed_rad_s: speed }) => speed >= 0.9 * nominal && speed <= 1.1 * nominal);
  const text = await note.textContent();
  assert.match(text, /^Band of 594 to 726 rpm: /);
  assert.ok(inside.length > 0);
  for (const { label, harmonic, speed_rad_s: speed } of inside) {
    const rpm = Number(((speed * 30) / Math.PI).toPrecision(4));
    assert.ok(text.includes(`${label} × ${harmonic}P at ${rpm} rpm`), `${label} × ${harmonic}P in ${text}`);
  }
  const lower = page.locator(".band-handle.from");
  await lower.focus();
  await page.keyboard.press("ArrowLeft");
  assert.equal(await lower.getAttribute("aria-valuenow"), "0.89");
  assert.equal(await lower.getAttribute("aria-valuetext"), "0.89 of nominal, 587.4 rpm");
  await note.filter({ hasText: "Band of 587.4 to 726 rpm" }).waitFor();
  const box = await lower.boundingBox();
  assert.ok(box.width >= 32 && box.height >= 32);
  await page.mouse.move(box.x + 16, box.y + 8);
  await page.mouse.down();
  await page.mouse.move(box.x - 84, box.y + 8, { steps: 5 });
  assert.equal(await lower.locator(".value").isVisible(), true, "numbers are shown while dragging");
  await page.mouse.up();
  assert.ok(Number(await lower.getAttribute("aria-valuenow")) < 0.75);
  assert.equal(await page.locator("#speed-number").inputValue(), "660", "the line stays");
  await page
    .locator("#chart svg text", { hasText: /0\.\d+ to 1\.1 of nominal/ })
    .first()
    .waitFor();
});

/** Sets a slider as dragging would. */
const slide = (page, id, value) =>
  page.locator(`#${id}`).evaluate((slider, value) => {
    slider.value = value;
    slider.dispatchEvent(new Event("input", { bubbles: true }));
  }, value);

pageTest("the blade as it is stays in sight behind the changed one", {}, async (page) => {
  assert.equal(await page.locator(".before path").count(), 0);
  await slide(page, "what-if-factors-flap_stiffness", 1);
  await page.locator('.before path[data-label="3F"]').waitFor({ state: "attached" });
  await page.locator(".before-note").waitFor();
  /** Where a path ends in the drawing, in its own pixels. */
  const end = () =>
    page
      .locator('.before path[data-label="2F"]')
      .evaluate((path) => path.getPointAtLength(path.getTotalLength()).matrixTransform(path.parentNode.transform.baseVal.consolidate().matrix).y);
  const expected = async (unit) => {
    const blade = await bladeOf(page, "tm4760");
    const { value: fan } = await call(page, "fan", blade);
    const frequency = fan.branches.find(({ label }) => label === "2F").frequency_rad_s.at(-1) / (unit === "Hz" ? 2 * Math.PI : 1);
    // From the axis as it is drawn: the ticks' texts and places.
    const ticks = await page
      .locator("#chart > svg:not(.overlay) .axes text[text-anchor='end']")
      .evaluateAll((all) => all.map((tick) => ({ value: Number(tick.textContent), y: Number(tick.getAttribute("y")) / 10 })));
    const [a, b] = [ticks[0], ticks.at(-1)];
    return a.y + ((frequency - a.value) / (b.value - a.value)) * (b.y - a.y);
  };
  const grid = async (unit) => Math.abs((await end()) - (await expected(unit)));
  assert.ok((await grid("rad/s")) < 5, "at its place in rad/s");
  await page.locator("#frequency-unit").selectOption("Hz");
  await page.locator("#chart svg text", { hasText: "frequency [Hz]" }).waitFor();
  assert.ok((await grid("Hz")) < 5, "and in Hz");
  await page.locator("#show-flap").uncheck();
  await page.waitForFunction(() => document.querySelectorAll('.before path[data-dof="flap"]').length === 0);
  await page.locator("#what-if-reset").click();
  await page.waitForFunction(() => document.querySelectorAll(".before path").length === 0);
});

pageTest("measured points are drawn and compared, faults have lines, and texts stay texts", {}, async (page) => {
  await page.locator("#measured-details summary").click();
  await page.locator("#measured-example").click();
  await page.locator("#measured-table tbody tr").first().waitFor();
  const rows = await page.locator("#measured-table tbody tr").evaluateAll((all) => all.map((row) => [...row.cells].map((cell) => cell.textContent)));
  const csv = await page.locator("#measured-text").inputValue();
  const { value } = await call(page, "compare", await bladeOf(page, "tm4760"), csv, {});
  assert.equal(rows.length, value.length);
  rows.forEach((row, i) => {
    assert.equal(row[0], value[i].label);
    const shown = Number(row[4].replace("−", "-").replace(/[+ %]/g, ""));
    assert.ok(Math.abs(shown - value[i].error_percent) < 0.06, `${row[4]} ${value[i].error_percent}`);
  });
  await page
    .locator("#chart svg text", { hasText: /measured|made up/ })
    .first()
    .waitFor();

  await page.locator("#measured-text").fill("label,speed [rpm],frequency [Hz],source\n1F,660,11.5,a\n1F,-3,x,b");
  await page.locator("#measured-faults li", { hasText: "line 3" }).first().waitFor();
  assert.equal(await page.locator("#solve-faults li").count(), 0, "the chart stays as it was");
  assert.ok((await page.locator("#measured-table tbody tr").count()) > 0);

  await page.evaluate(() => (window.broken = false));
  await page
    .locator("#measured-text")
    .fill('label,speed [rpm],frequency [Hz],source\n1F,660,11.5,"<img src=x onerror=window.broken=true><script>window.broken=true</script>"');
  await page.locator("#measured-table td", { hasText: "<img src=x" }).waitFor();
  assert.equal(await page.locator("main img, main script").count(), 0);
  assert.equal(await page.evaluate(() => window.broken), false);

  await page.locator("#measured-text").fill("x".repeat(200_001));
  await page.locator("#measured-faults li", { hasText: "at most 200 kB" }).waitFor();
  const dropped = await page.evaluateHandle(() => {
    const data = new DataTransfer();
    data.items.add(new File(["label,speed [rpm],frequency [Hz],source\n2F,660,30,dropped here"], "points.csv"));
    return data;
  });
  await page.dispatchEvent("#measured-details", "drop", { dataTransfer: dropped });
  await page.locator("#measured-table td", { hasText: "dropped here" }).waitFor();
  assert.equal(await page.locator("#blade-choice").inputValue(), "tm4760", "the blade stays");
  await page.locator("#measured-clear").click();
  await page.locator("#measured-table").waitFor({ state: "hidden" });
});

pageTest("every chart is also a table", { model: "uncoupled" }, async (page) => {
  await page.locator("#chart-data summary").click();
  const tables = page.locator("#chart-data table");
  await tables.nth(2).waitFor();
  const { value } = await reference(page, { model: "uncoupled" });
  const first = await tables.nth(2).locator("tbody tr").nth(50).locator("td").first().textContent();
  assert.ok(Math.abs(Number(first) / value.report.branches[0].frequency_rad_s[50] - 1) < 1e-3);
  assert.equal(await tables.nth(2).locator("tbody tr").count(), 101);
  assert.equal(await tables.nth(1).locator("tbody tr").count(), value.report.crossings.length + value.report.coincident.length);
  await page.locator("#frequency-unit").selectOption("Hz");
  await tables.nth(2).locator("caption", { hasText: "Frequencies [Hz]" }).waitFor();
  for (const [tab, caption] of [
    ["shapes", "Displacement along the span"],
    ["converge", "Converged frequency"],
  ]) {
    await page.locator(`#tab-${tab}`).click();
    await tables.first().locator("caption", { hasText: caption }).waitFor();
    assert.ok((await tables.first().locator("tbody tr").count()) >= 3);
    assert.match(await page.locator("#chart").getAttribute("aria-label"), /modes/);
  }
});

for (const [width, height] of [
  [1280, 800],
  [390, 844],
]) {
  for (const colorScheme of ["light", "dark"]) {
    pageTest(
      `at ${width} px, ${colorScheme}: what is pressed is large enough and nothing scrolls sideways`,
      { viewport: { width, height }, colorScheme, reducedMotion: "reduce" },
      async (page) => {
        await page.locator("#measured-details summary").click();
        await page.locator("#measured-example").click();
        await page.locator("#measured-table tbody tr").first().waitFor();
        await page.locator("#chart-data summary").click();
        await page.locator("#chart-data table").first().waitFor();
        const small = await page
          .locator("#chart-tools :is(button, select, label.toggle, input[type=number]), .handle, #measured :is(button, summary)")
          .evaluateAll((all) =>
            all
              .filter((item) => item.checkVisibility())
              .map((item) => [item.id || item.className || item.textContent, item.getBoundingClientRect().height])
              .filter(([, height]) => height < 31.5),
          );
        assert.deepEqual(small, []);
        assert.equal(await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth), 0);
      },
    );
  }
}

pageTest("a drawing changed in place is the drawing made anew, and nothing else is changed in place", {}, async (page) => {
  const blade = await bladeOf(page, "tm4760");
  const draw = (changed, looks = {}) => call(page, "chart_svg", "fan", changed, { width: 900, ...looks }).then(({ value }) => value.svg);
  const soften = async (factor) => (await call(page, "change_blade", blade, [{ what: "distribution.flap_stiffness", scale: factor }])).value.blade;
  const become = (from, to) =>
    page.evaluate(
      async ([from, to]) => {
        const { Drawing } = await import(new URL("../chart/patch.js", document.querySelector("script[type=module]").src));
        const drawing = new Drawing(from);
        const became = drawing.become(to);
        return { became, right: drawing.root.outerHTML === new Drawing(became ? to : from).root.outerHTML };
      },
      [from, to],
    );
  const plain = await draw(blade);
  // Most steps of a slider keep the elements of the drawing; at others a crossing or a label comes or goes.
  for (const factor of [1.001, 1.003, 1.01])
    assert.deepEqual(await become(plain, await draw(await soften(factor))), { became: true, right: true }, `${factor}`);
  assert.deepEqual(await become(plain, plain.replace("nominal 660 rpm", "nominal 661 rpm")), { became: true, right: true });
  const others = {
    "fewer modes": await draw(blade, { modes: 2 }),
    "a name to decode": await draw({ ...blade, name: "R&D" }),
    "a text that is a tag now": plain.replace("\nnominal 660 rpm\n", "\n<tspan/>\n"),
    "another element": plain.replace("<circle ", "<ellipse "),
    "another attribute": plain.replace("<polyline fill=", "<polyline clip-path="),
  };
  for (const [name, other] of Object.entries(others)) {
    assert.notEqual(other, plain, name);
    assert.deepEqual(await become(plain, other), { became: false, right: true }, name);
  }
});

pageTest("of steps that come faster than anything is solved most are not asked for, and the last one stands there", {}, async (page) => {
  await page.addInitScript(() => {
    window.asked = 0;
    const Real = window.Worker;
    window.Worker = class extends Real {
      postMessage(message, ...rest) {
        if (message.name === "chart_svg") window.asked++;
        super.postMessage(message, ...rest);
      }
    };
  });
  await page.reload();
  await drawn(page);
  const factor = await page.evaluate(() => {
    const slider = document.getElementById("what-if-factors-flap_stiffness");
    window.asked = 0;
    for (let i = 0; i < 30; i++) {
      slider.value = 1 - i * 0.02;
      slider.dispatchEvent(new Event("input", { bubbles: true }));
    }
    return Number((2 ** slider.valueAsNumber).toPrecision(4));
  });
  const { value: soft } = await call(page, "change_blade", await bladeOf(page, "tm4760"), [{ what: "distribution.flap_stiffness", scale: factor }]);
  const { value } = await call(page, "modes", soft.blade);
  await page.waitForFunction(
    (last) => Number(document.querySelector("#modes tbody td[data-full]").dataset.full) === last,
    value.modes[0].frequency_rad_s,
  );
  const asked = await page.evaluate(() => window.asked);
  assert.ok(asked >= 1 && asked < 10, `${asked} of 30 steps were solved`);
});
