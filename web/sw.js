// Keeps the page working without a network: what was loaded once is kept, the network comes first.

const CACHE = "bladefan";
/** All that the page is made of, beside the package. tests/web/share.test.mjs holds it to the folder. */
const FILES = [
  "./", "icon.svg",
  "app/main.js", "app/pack.js", "app/session.js", "app/share.js", "app/state.js", "app/storage.js",
  "app/theme.js", "app/view.js",
  "blade/document.js", "blade/form.js", "blade/open.js", "blade/shape.js", "blade/text.js",
  "blade/units.js", "blade/what-if.js",
  "chart/band.js", "chart/chart.js", "chart/frame.js", "chart/hover.js", "chart/measured.js",
  "chart/numbers.js", "chart/patch.js", "chart/speed.js", "chart/tools.js", "chart/unchanged.js",
  "chart/zoom.js",
  "lib/dof-toggles.js", "lib/dom.js", "lib/faults.js", "lib/format.js", "lib/speed-words.js",
  "lib/unit-words.js", "lib/what-if.js",
  "modes/lesson.js", "modes/motion.js", "modes/movers.js", "modes/nearness.js", "modes/plate.js",
  "modes/shape.js", "modes/table.js",
  "out/download.js", "out/report.js", "out/save.js",
  "solver/changed.js", "solver/client.js", "solver/keep-up.js", "solver/lanes.js", "solver/worker.js",
  "stations/columns.js", "stations/faults.js", "stations/forms.js", "stations/parts.js",
  "stations/paste/block.js", "stations/paste/panel.js", "stations/profiles.js", "stations/sheet/editor.js",
  "stations/sheet/grid.js", "stations/sheet/keys.js", "stations/span.js", "stations/tab.js",
  "styles/blade.css", "styles/chart.css", "styles/motion.css", "styles/page.css", "styles/print.css",
  "styles/stations.css",
];
const MODULES = ["bladefan_first", "bladefan_wasm"];

const LIBRARY = "pkg/library.js";
/** The folder of the package's version, as the library names it. */
const folderOf = async (response) => /"\.\/([0-9a-f]+)\/library\.js"/.exec(await response.text())?.[1];

/** The package's own files: its entries name the folder of this version. */
function packageFiles(folder) {
  const scripts = [...MODULES, "library"].flatMap((name) => [`pkg/${name}.js`, `pkg/${folder}/${name}.js`]);
  return [...scripts, ...MODULES.map((name) => `pkg/${folder}/${name}_bg.wasm`)];
}

async function fill() {
  const cache = await caches.open(CACHE);
  const folder = await folderOf(await fetch(LIBRARY, { cache: "no-cache" }));
  await cache.addAll([...FILES, ...packageFiles(folder)].map((path) => new Request(path, { cache: "no-cache" })));
  const old = (await cache.keys()).filter(({ url }) => /\/pkg\/[0-9a-f]+\//.test(url) && !url.includes(`/pkg/${folder}/`));
  await Promise.all(old.map((request) => cache.delete(request)));
}

/** Another version of the package is kept as a whole, with what the page has not asked for yet. */
async function renew(response) {
  const kept = await (await caches.open(CACHE)).match(LIBRARY);
  if (kept && (await folderOf(kept)) !== (await folderOf(response))) await fill();
}

async function answer(event) {
  const { request } = event;
  try {
    const response = await fetch(request);
    if (request.url.endsWith(LIBRARY) && response.ok) event.waitUntil(renew(response.clone()).catch(() => {}));
    else if (response.ok) (await caches.open(CACHE)).put(request, response.clone());
    return response;
  } catch (error) {
    const kept = await caches.match(request, { ignoreSearch: true });
    if (kept) return kept;
    throw error;
  }
}

addEventListener("install", (event) => event.waitUntil(fill()));
addEventListener("activate", (event) => event.waitUntil(clients.claim()));
addEventListener("fetch", (event) => {
  if (event.request.method === "GET" && new URL(event.request.url).origin === location.origin) event.respondWith(answer(event));
});
