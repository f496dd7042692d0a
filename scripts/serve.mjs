// Serves the page on 127.0.0.1 as scripts/site.mjs puts it together. `node scripts/serve.mjs [PORT]`, or
// from a test:
//   const server = await serve(0); … server.address().port … server.close();
import { createServer } from "node:http";
import { readFile } from "node:fs/promises";
import { extname, normalize } from "node:path";
import { fileURLToPath } from "node:url";
import { site, web } from "./site.mjs";

// A browser compiles wasm while it streams in, and runs modules at all, only under these types.
const types = {
  ".css": "text/css; charset=utf-8",
  ".csv": "text/csv; charset=utf-8",
  ".html": "text/html; charset=utf-8",
  ".js": "text/javascript; charset=utf-8",
  ".json": "application/json",
  ".mjs": "text/javascript; charset=utf-8",
  ".png": "image/png",
  ".svg": "image/svg+xml",
  ".toml": "text/plain; charset=utf-8",
  ".txt": "text/plain; charset=utf-8",
  ".wasm": "application/wasm",
  ".webmanifest": "application/manifest+json",
  ".woff2": "font/woff2",
};

/** The path that a request names, or null where it names none. */
function pathOf(url) {
  try {
    const path = decodeURIComponent(url.split(/[?#]/, 1)[0]).slice(1);
    return path === "" || path.endsWith("/") ? `${path}index.html` : path;
  } catch {
    return null; // a malformed escape
  }
}

/** The documentation is read as it is asked for: it is built beside the page. */
async function documentation(path) {
  const inside = normalize(path).startsWith("docs/") && !path.includes("\0");
  return inside ? readFile(web + path).catch(() => undefined) : undefined;
}

async function answer(request, response, files) {
  const end = (status, body, type = "text/plain; charset=utf-8") => {
    response.writeHead(status, { "Content-Type": type, "Cache-Control": "no-cache" });
    response.end(request.method === "HEAD" ? undefined : body);
  };
  if (request.method !== "GET" && request.method !== "HEAD") return end(405, "not allowed\n");
  const path = pathOf(request.url);
  const body = path === null ? undefined : (files.get(path) ?? (await documentation(path)));
  if (body === undefined) return end(404, "not found\n");
  end(200, body, types[extname(path)] ?? "application/octet-stream");
}

/** The page of now: put together anew for every visit, so that a change is there after a reload. */
function current() {
  let made = site();
  return (path) => {
    if (path === "/") made = site();
    return made.files;
  };
}

/** Starts the server; port 0 is any free one. `filesFor(url)` gives all files, by path. */
export function serve(port, filesFor = current()) {
  return new Promise((resolve, reject) => {
    const server = createServer((request, response) => answer(request, response, filesFor(request.url)));
    server.once("error", reject);
    server.listen(port, "127.0.0.1", () => resolve(server));
  });
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const asked = process.argv[2];
  try {
    const server = await (asked === undefined ? serve(8000).catch(() => serve(0)) : serve(Number(asked)));
    console.log(`http://127.0.0.1:${server.address().port}/`);
  } catch (error) {
    console.error(`cannot serve on port ${asked}: ${error.message}`);
    process.exitCode = 1;
  }
}
