// Measures the page in a browser, and prints the numbers: npm --prefix tests/web run measure.
// The lines stand in docs/VALIDATION.md by scripts/reproduce-paper --times. Nothing is asserted here: a
// time is of the machine and of what else runs there.

import { drawn, open, site, start, watched } from "./browser.mjs";

/** Steps of a slider that are timed. */
const STEPS = 90;
const ROWS = 100_000;

/** From the page being asked for to its first chart, nothing kept from before. */
async function firstChart() {
  const { page, close } = await watched();
  await page.addInitScript(() => {
    new MutationObserver(() => {
      window.firstChart ??= document.querySelector("#chart > svg") && performance.now();
    }).observe(document, { childList: true, subtree: true });
  });
  await page.goto(site.origin);
  const time = await (await page.waitForFunction(() => window.firstChart)).jsonValue();
  await close();
  console.log(`first chart ${Math.round(time)} ms after the page was asked for, nothing kept from before`);
}

/** A what-if step redraws the converged chart: from the input to the layout, and what of it is what. */
async function frameTime() {
  const { page, close } = await open({ reducedMotion: "no-preference" });
  // The real worker, which also tells when it began and ended.
  await page.route("**/worker.js", async (route) => {
    const response = await route.fetch();
    const body = `${await response.text()}
      const answer = onmessage;
      onmessage = async (event) => {
        const began = performance.now();
        await answer(event);
        postMessage({ name: event.data.name, began, ended: performance.now() });
      };`;
    await route.fulfill({ response, body });
  });
  await page.addInitScript(() => {
    window.timings = [];
    const Real = window.Worker;
    window.Worker = class extends Real {
      constructor(...args) {
        super(...args);
        this.addEventListener("message", ({ data }) => {
          if (data.name === "chart_svg") window.timings.push(data);
          if (data.result?.value?.svg) window.received = performance.now();
        });
      }
    };
  });
  await page.reload();
  await drawn(page);
  await page.waitForTimeout(500);
  const steps = await page.evaluate(async (count) => {
    const slider = document.getElementById("what-if-factors-flap_stiffness");
    const host = document.getElementById("chart");
    const chart = () => host.querySelector("svg:not(.overlay)");
    const now = () => performance.now();
    const steps = [];
    for (let i = 0; i < count; i++) {
      await new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve, 30))); // one step, all its work, then the next
      const arrived = new Promise((resolve) => {
        const watcher = new MutationObserver((changes) => {
          if (!changes.some(({ target }) => target === host || chart().contains(target))) return;
          watcher.disconnect();
          const drawn = now();
          host.getBoundingClientRect();
          chart().querySelector("text").getBBox(); // laid out
          resolve({ drawn, laidOut: now() });
        });
        watcher.observe(host, { subtree: true, attributes: true, characterData: true, childList: true });
      });
      slider.value = -1 + i * 0.02;
      const begin = now();
      slider.dispatchEvent(new Event("input", { bubbles: true }));
      const handled = now();
      const end = await arrived;
      while (window.timings.length === 0) await new Promise((resolve) => setTimeout(resolve)); // told after the answer
      const { began, ended } = window.timings.pop();
      window.timings.length = 0;
      steps.push({
        total: end.laidOut - begin,
        input: handled - begin,
        solve: ended - began,
        draw: end.drawn - window.received,
        layout: end.laidOut - end.drawn,
      });
    }
    return steps;
  }, STEPS);
  await close();
  const part = (key, share) => {
    const sorted = steps.map((step) => step[key]).sort((a, b) => a - b);
    return sorted[Math.floor(share * steps.length)].toFixed(1);
  };
  const split = (share) =>
    Object.keys(steps[0])
      .map((key) => `${key} ${part(key, share)}`)
      .join(", ");
  console.log(`frame time of ${steps.length} what-if steps, medians [ms]: ${split(0.5)}`);
  console.log(`fastest tenth [ms], each part by itself: ${split(0.1)}`);
}

/** The sheet of stations with much in it. */
async function sheet() {
  const { page, close } = await open();
  await page.locator("#tab-stations").click();
  await page.locator(".sheet td").first().waitFor();
  const took = async (words, text) => {
    const time = await page.evaluate((text) => {
      document.querySelector(".sheet td").focus();
      const data = new DataTransfer();
      data.setData("text/plain", text);
      const start = performance.now();
      document.activeElement.dispatchEvent(new ClipboardEvent("paste", { clipboardData: data, bubbles: true, cancelable: true }));
      document.body.getBoundingClientRect();
      return performance.now() - start;
    }, text);
    console.log(`${words}: ${Math.round(time)} ms until the sheet stands`);
  };
  await took(`${ROWS} rows refused`, "1\t2\t3\n".repeat(ROWS));
  await took("2000 rows pasted", Array.from({ length: 2000 }, (_, i) => `${(i * 55) / 1999}\t0.2`).join("\n"));
  await close();
}

const stop = await start();
try {
  await firstChart();
  await frameTime();
  await sheet();
} finally {
  await stop();
}
