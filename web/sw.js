// Keeps the page working without a network. All that the page runs lies in one folder named after its
// contents, so what is kept of that folder is right for ever, and the page itself, which names the folder,
// comes from the network first. A page that is open keeps its version: a newer one is kept beside it, and
// the older ones go once no page is open that needs them.

// scripts/site.mjs fills in both: the version is the folder's name.
const VERSION = "";
const FILES = [];

/** Where this page stands: another page of the same host may be a bladefan, too. */
const scope = registration.scope;
const OWN = `bladefan ${scope} `;
const CACHE = OWN + VERSION;
/** What the page kept before its caches had versions. */
const UNVERSIONED = "bladefan";

const isVersioned = ({ href }) => /^[0-9a-f]{12}\//.test(href.slice(scope.length));
const isPage = ({ origin, pathname }) => [scope, `${scope}index.html`].includes(origin + pathname);

async function fill() {
  const page = await fetch(scope, { cache: "no-cache" });
  // While an update is being put in place, worker and page may be of two versions for a moment.
  if (!page.ok || !(await page.clone().text()).includes(`"${VERSION}/`)) throw new Error("the page is of another version");
  const cache = await caches.open(CACHE);
  await cache.addAll(FILES.map((path) => new Request(path, { cache: "no-cache" })));
  await cache.put(scope, page); // last: where the page is kept, all that it needs is
}

async function clear() {
  const old = (await caches.keys()).filter((name) => (name.startsWith(OWN) && name !== CACHE) || name === UNVERSIONED);
  await Promise.all(old.map((name) => caches.delete(name)));
}

/** What is kept of a request in the page's own caches, the newest first; none where storage fails. */
async function kept(request) {
  try {
    const own = (await caches.keys()).filter((name) => name.startsWith(OWN)).reverse();
    for (const name of own) {
      const found = await (await caches.open(name)).match(request, { ignoreSearch: true });
      if (found) return found;
    }
  } catch {
    // Storage is switched off or broken; the network may still answer.
  }
  return undefined;
}

/** Keeps an answer where there is room for it: storage that fails is no failure of the network. */
async function keep(request, response) {
  try {
    await (await caches.open(CACHE)).put(request, response);
  } catch {
    // it is asked for again next time
  }
}

async function networkFirst(event, key) {
  let response;
  try {
    response = await fetch(event.request);
  } catch (error) {
    const found = await kept(key);
    if (found) return found;
    throw error;
  }
  // The page is kept by `fill`, with all that it needs.
  if (response.ok && key !== scope) event.waitUntil(keep(key, response.clone()));
  return response;
}

addEventListener("install", (event) => event.waitUntil(fill()));
addEventListener("activate", (event) => event.waitUntil(Promise.all([clear(), clients.claim()])));
addEventListener("fetch", (event) => {
  const { request } = event;
  const url = new URL(request.url);
  if (request.method !== "GET" || !url.href.startsWith(scope)) return;
  if (isVersioned(url)) event.respondWith(kept(request).then((found) => found ?? fetch(request)));
  else event.respondWith(networkFirst(event, isPage(url) ? scope : request));
});
