// What axe-core finds on the page: nothing, in every tab, light and dark, wide and narrow.

import assert from "node:assert/strict";
import { test } from "node:test";
import { findings, open, paste } from "./support.mjs";

for (const [width, height, colorScheme] of [
  [1280, 800, "light"],
  [1280, 800, "dark"],
  [390, 844, "light"],
  [390, 844, "dark"],
]) {
  test(`nothing to find at ${width} px, ${colorScheme}`, async () => {
    // The page's own policy would stop a script from elsewhere; bypassed for axe alone.
    const { page, close } = await open({ viewport: { width, height }, colorScheme, bypassCSP: true });
    try {
      for (const tab of ["fan", "shapes", "converge", "stations", "text"]) {
        await page.locator(`#tab-${tab}`).click();
        await page.locator(`#chart > svg[aria-label^="${{ shapes: "Mode", converge: "Conv" }[tab] ?? "Fan"}"]`).waitFor();
        assert.deepEqual(await findings(page), [], tab);
      }
      await paste(page, "radius = -1");
      await page.locator("#faults li").first().waitFor();
      await page.locator("#tab-fan").click();
      await page.locator('[data-path="rotor.radius"]').fill("-1");
      await page.locator('[data-fault-of="rotor.radius"]').waitFor();
      await page.locator("#download summary").click();
      assert.deepEqual(await findings(page), [], "with faults and an open menu");
    } finally {
      await close();
    }
  });
}
