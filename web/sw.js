// Keeps the page working without a network: what was loaded once is kept, the network comes first.

const CACHE = "bladefan";
/** All that the page is made of, beside the package. tests/web/share.test.mjs holds it to the folder. */
const FILES = [
  "./", "icon.svg", "blade.css", "chart.css", "motion.css", "print.css", "stations.css", "style.css", "band.js",
  "before.js", "blade.js", "chart-data.js", "chart-tools.js", "chart.js", "client.js", "close-tools.js",
  "columns.js", "document.js", "dom.js", "drawing.js", "download.js", "editor.js", "form.js", "format.js", "frame.js", "hover.js",
  "lesson.js", "main.js", "measured.js", "motion.js", "nearness.js", "pack.js", "paste-panel.js", "paste.js",
  "plate.js", "profile.js", "report.js", "save.js", "scale.js", "sensitivity.js", "session.js", "shape.js",
  "share.js", "sheet-editor.js", "sheet-keys.js", "sheet.js", "solve.js", "solver.js", "span-forms.js", "span.js", "speed.js",
  "state.js", "stations-faults.js", "stations-parts.js", "stations.js", "table.js", "theme.js", "units.js",
  "view.js", "what-if.js", "worker.js", "zoom.js",
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
