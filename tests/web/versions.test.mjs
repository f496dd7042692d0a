// Versions of the page: with a service worker, without a network, and while an update arrives.

import assert from "node:assert/strict";
import { after, before, beforeEach, test } from "node:test";
import { setTimeout as sleep } from "node:timers/promises";
import { serve } from "../../scripts/serve.mjs";
import { site as build, sources } from "../../scripts/site.mjs";
import { drawn, site } from "./support.mjs";

/** Two versions of the page that can be told apart. */
const first = build();
const changed = sources();
changed.set("app/theme.js", Buffer.concat([changed.get("app/theme.js"), Buffer.from("// another version\n")]));
const second = build(changed);

let served;
let server;
let origin;
/** What was asked of the server. */
let asked;
before(async () => {
  server = await serve(0, (url) => {
    asked.push(url.slice(1));
    return served.files;
  });
  origin = `http://127.0.0.1:${server.address().port}/`;
});
after(() => server.close());
beforeEach(() => {
  served = first;
  asked = [];
});

/** Runs the body in a browser that keeps nothing from other tests. */
async function inBrowser(body) {
  const context = await site.browser.newContext();
  context.setDefaultTimeout(20_000);
  try {
    await body(context);
  } finally {
    await context.close();
  }
}

/** The version of the page and of everything that it runs. */
async function versions(page) {
  await drawn(page);
  return page.evaluate(() => {
    const addresses = [document.querySelector("script[type=module]").src, ...performance.getEntriesByType("resource").map(({ name }) => name)];
    return [...new Set(addresses.map((address) => /\/([0-9a-f]{12})\//.exec(address)?.[1]).filter(Boolean))];
  });
}

async function opened(context) {
  const page = await context.newPage();
  await page.goto(origin);
  await drawn(page);
  return page;
}

/** Waits until the page is kept, with all that it needs. */
const kept = (page, { version }) =>
  until(() =>
    page.evaluate(
      async (name) => (await caches.has(name)) && (await (await caches.open(name)).match("./")) !== undefined,
      `bladefan ${origin} ${version}`,
    ),
  );
/** Waits for something that takes a promise to tell, which `waitForFunction` would take for true. */
async function until(holds) {
  for (const end = Date.now() + 20_000; !(await holds()); await sleep(50)) assert.ok(Date.now() < end, `waited in vain for ${holds}`);
}
const controlled = (page) => page.waitForFunction(() => navigator.serviceWorker.controller !== null);
const cacheNames = (page) => page.evaluate(() => caches.keys());

/** Something that the first view does not need: another worker with the package. */
async function converge(page) {
  await page.locator("#tab-converge").click();
  await page.locator("#chart [data-family]").first().waitFor({ state: "attached" });
}

test("two versions share no file but those at the top", () => {
  assert.notEqual(first.version, second.version);
  const shared = [...first.files.keys()].filter((path) => second.files.has(path));
  assert.deepEqual(shared.sort(), ["icon.svg", "index.html", "sw.js"]);
  const page = first.files.get("index.html").toString();
  for (const [, path] of page.matchAll(/\b(?:src|href)="([^"]+)"/g)) {
    assert.ok(first.files.has(path) || path === "docs/", path);
    assert.ok(path.startsWith(`${first.version}/`) || ["icon.svg", "docs/"].includes(path), path);
  }
  assert.deepEqual(build(sources()).version, first.version, "the same files are the same version");
});

test("once loaded the page works without a network", () =>
  inBrowser(async (context) => {
    const page = await opened(context);
    await controlled(page);
    await kept(page, first);
    await context.setOffline(true);
    await page.reload();
    assert.deepEqual(await versions(page), [first.version]);
    await page.locator("#blade-choice").selectOption("sa330");
    await page.locator('#chart > svg[aria-label*="SA 330"]').waitFor();
    await converge(page); // kept, too
  }));

test("a page that is open while an update arrives goes on in its version, and the next one is new throughout", () =>
  inBrowser(async (context) => {
    const old = await opened(context);
    await controlled(old);
    await kept(old, first);
    await old.evaluate(async () => (await navigator.serviceWorker.getRegistration()).update()); // looked for before, not beside
    served = second; // what is gone from the server is gone
    asked = [];
    const fresh = await opened(context);
    assert.deepEqual(await versions(fresh), [second.version]);
    await converge(fresh);
    assert.deepEqual(await versions(fresh), [second.version]);
    await kept(fresh, second);
    await converge(old);
    assert.deepEqual(await versions(old), [first.version]);
    assert.deepEqual(
      asked.filter((path) => path.startsWith(first.version)),
      [],
      "the old page lives on what is kept",
    );

    // Without a network the newest is shown, though the old page is still open.
    await context.setOffline(true);
    await fresh.reload();
    assert.deepEqual(await versions(fresh), [second.version]);
    await converge(fresh);
    await context.setOffline(false);

    // Once no page needs it, the old version goes.
    await old.close();
    await fresh.close();
    const last = await opened(context);
    await until(async () => !(await cacheNames(last)).some((name) => name.includes(first.version)));
    await context.setOffline(true);
    await last.reload();
    assert.deepEqual(await versions(last), [second.version]);
    await converge(last);
  }));

test("an update that is half in place is not kept", () =>
  inBrowser(async (context) => {
    const page = await opened(context);
    await controlled(page);
    await kept(page, first);
    // The new worker is there already, the page and its files are still the old ones.
    served = { files: new Map([...first.files, ["sw.js", second.files.get("sw.js")]]) };
    const state = await page.evaluate(async () => {
      const registration = await navigator.serviceWorker.getRegistration();
      const found = new Promise((resolve) =>
        registration.addEventListener("updatefound", () => {
          const { installing } = registration;
          installing.addEventListener("statechange", () => resolve(installing.state));
        }),
      );
      await registration.update();
      return found;
    });
    assert.equal(state, "redundant");
    await context.setOffline(true);
    await page.reload();
    assert.deepEqual(await versions(page), [first.version]);
  }));

test("caches of others are neither looked into nor deleted", () =>
  inBrowser(async (context) => {
    const page = await context.newPage();
    await page.goto(`${origin}icon.svg`);
    await page.evaluate(
      async ([origin, version]) => {
        for (const name of ["another page of this host", `bladefan ${origin}elsewhere/ 000000000000`, "bladefan"]) {
          const cache = await caches.open(name);
          for (const path of ["", `${version}/app/main.js`, "docs/"])
            await cache.put(origin + path, new Response("not ours", { headers: { "Content-Type": "text/html" } }));
        }
      },
      [origin, first.version],
    );
    await page.goto(origin);
    await drawn(page);
    await controlled(page);
    await kept(page, first);
    assert.deepEqual((await cacheNames(page)).sort(), [
      "another page of this host",
      `bladefan ${origin} ${first.version}`,
      `bladefan ${origin}elsewhere/ 000000000000`,
    ]);
    await context.setOffline(true);
    assert.equal(
      await page.evaluate(() =>
        fetch("docs/").then(
          () => "answered",
          () => "no network",
        ),
      ),
      "no network",
    );
    await page.reload();
    assert.deepEqual(await versions(page), [first.version]);
  }));

test("storage that fails is no failure of the network", () =>
  inBrowser(async (context) => {
    const page = await opened(context);
    await controlled(page);
    await kept(page, first);
    const [worker] = context.serviceWorkers();
    await worker.evaluate(() => {
      caches.open = caches.keys = () => Promise.reject(new DOMException("no room", "QuotaExceededError"));
    });
    await page.reload();
    assert.deepEqual(await versions(page), [first.version]);
    assert.equal(await page.evaluate(() => fetch("icon.svg").then(({ status }) => status)), 200);
  }));
