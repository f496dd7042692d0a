// Serves the folder web/ on 127.0.0.1. `node scripts/serve.mjs [PORT]`, or from a test:
//   const server = await serve(0); … server.address().port … server.close();
import { createServer } from "node:http";
import { readFile } from "node:fs/promises";
import { extname, join, normalize, sep } from "node:path";
import { fileURLToPath } from "node:url";

const root = fileURLToPath(new URL("../web", import.meta.url));

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

/** The file that a request's path names, or null where it names none inside the folder. */
function fileOf(url) {
  try {
    const path = decodeURIComponent(url.split(/[?#]/, 1)[0]);
    const file = normalize(join(root, path.endsWith("/") ? `${path}index.html` : path));
    return file.startsWith(root + sep) && !file.includes("\0") ? file : null;
  } catch {
    return null; // a malformed escape
  }
}

async function answer(request, response) {
  const end = (status, body, type = "text/plain; charset=utf-8") => {
    response.writeHead(status, { "Content-Type": type, "Cache-Control": "no-cache" });
    response.end(request.method === "HEAD" ? undefined : body);
  };
  if (request.method !== "GET" && request.method !== "HEAD") return end(405, "not allowed\n");
  const file = fileOf(request.url);
  if (file === null) return end(403, "outside the page's folder\n");
  try {
    end(200, await readFile(file), types[extname(file)] ?? "application/octet-stream");
  } catch {
    end(404, "not found\n");
  }
}

/** Starts the server; port 0 is any free one. */
export function serve(port) {
  return new Promise((resolve, reject) => {
    const server = createServer(answer);
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
