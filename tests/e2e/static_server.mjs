/**
 * Serves a folder on this machine as a static web host would: files by their path, with their MIME types, nothing else.
 *
 *     node tests/e2e/static_server.mjs FOLDER [PORT]
 */
import { createReadStream } from "node:fs";
import { stat } from "node:fs/promises";
import { createServer } from "node:http";
import { extname, join, normalize } from "node:path";
import { pathToFileURL } from "node:url";

/** @type {Record<string, string>} */
const MIME_TYPES = {
  ".css": "text/css; charset=utf-8",
  ".html": "text/html; charset=utf-8",
  ".ico": "image/x-icon",
  ".js": "text/javascript; charset=utf-8",
  ".json": "application/json",
  ".png": "image/png",
  ".svg": "image/svg+xml",
  ".txt": "text/plain; charset=utf-8",
  ".wasm": "application/wasm",
  ".webmanifest": "application/manifest+json",
};

const DEFAULT_PORT = 8017;

/**
 * In place of the page's service worker: one that takes itself, and what was there before it, away. Who works on the page
 * wants to see what was built last.
 */
const NO_WORKER = `
  addEventListener("install", () => skipWaiting());
  addEventListener("activate", (event) => event.waitUntil(registration.unregister()));
`;

/**
 * Starts a server; it ends with `server.close()`.
 *
 * @param {string} folder what to serve
 * @param {{port?: number, base?: string, headers?: Record<string, string>, isKept?: boolean}} [options] `port` 0 is any free
 *   one; `base` is the path that the folder stands for, beginning and ending with a slash; `headers` go with each file;
 *   `isKept` is whether browsers keep the page, by its worker
 * @returns {Promise<{server: import("node:http").Server, url: string}>}
 */
export async function serve(folder, { port = 0, base = "/", headers = {}, isKept = false } = {}) {
  const server = createServer((request, response) => {
    const { url = "/" } = request;
    if (!isKept && url === `${base}worker.js`) return void response.writeHead(200, { "content-type": MIME_TYPES[".js"] }).end(NO_WORKER);
    answer(fileOf(folder, base, url), headers, response).catch(() => response.destroy());
  });
  await new Promise((resolve, reject) => {
    server.once("error", reject);
    server.listen(port, "127.0.0.1", () => resolve(undefined));
  });
  const address = server.address();
  if (address === null || typeof address === "string") throw new Error("the server has no port");
  return { server, url: `http://127.0.0.1:${address.port}${base}` };
}

/**
 * @param {string | undefined} file
 * @param {Record<string, string>} headers
 * @param {import("node:http").ServerResponse} response
 */
async function answer(file, headers, response) {
  const found = file !== undefined && (await stat(file).catch(() => undefined))?.isFile();
  if (!found) {
    response.writeHead(404, { "content-type": "text/plain" }).end("not found\n");
    return;
  }
  const type = MIME_TYPES[extname(file)] ?? "application/octet-stream";
  response.writeHead(200, { "content-type": type, "cache-control": "no-cache", ...headers });
  createReadStream(file).pipe(response);
}

/**
 * The file that a URL stands for; no URL leads out of the folder.
 *
 * @param {string} folder
 * @param {string} base
 * @param {string} url
 */
function fileOf(folder, base, url) {
  const path = decodedPath(url);
  if (path === undefined || !path.startsWith(base) || path.includes("\0")) return undefined;
  const inside = normalize(`/${path.slice(base.length)}`);
  return join(folder, inside.endsWith("/") ? `${inside}index.html` : inside);
}

/** @param {string} url */
function decodedPath(url) {
  try {
    return decodeURIComponent(url.split(/[?#]/)[0]);
  } catch {
    return undefined;
  }
}

/**
 * @param {string} folder
 * @param {string} [port] without it, the usual one or, where that is taken, any
 */
async function main(folder, port) {
  try {
    const usual = serve(folder, { port: Number(port ?? DEFAULT_PORT) });
    const { url } = await (port === undefined ? usual.catch(() => serve(folder)) : usual);
    console.log(`Scumble is at ${url} (stop with Ctrl+C)`);
  } catch (error) {
    console.error(`Port ${port} cannot be used (${error}); name another, or none for any that is free.`);
    process.exitCode = 1;
  }
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
  await main(process.argv[2], process.argv[3]);
}
