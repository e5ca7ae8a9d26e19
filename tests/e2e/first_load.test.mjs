// What the first visit costs: every file that the page asks for until it can be used, each as `gzip -9` packs it.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { homedir } from "node:os";
import { before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { Editor, useSession, version } from "./harness.mjs";

/** Of which the grid solver takes 29,000, so that it is there when a picture is wanted at once. */
const LIMIT_BYTES = 419_000;

const session = useSession("chromium", { hasGpu: true });
/** @type {string} */
let folder;
before(async () => {
  folder = await version();
});

test("the first load takes at most 419 KB, all from the page's own folder, with one wasm build", async (t) => {
  const tab = await session.newTab({ isFirst: true });
  /** @type {Set<string>} */
  const urls = new Set();
  tab.onRequest((url) => urls.add(url));
  await Editor.open(tab, session.url, "webgpu");
  assert.deepEqual([...urls].filter((url) => !url.startsWith(session.url)), []);

  const sizes = [...urls].map(gzippedSize);
  for (const { path, bytes } of sizes) t.diagnostic(`${bytes} bytes: ${path}`);
  const total = sizes.reduce((sum, { bytes }) => sum + bytes, 0);
  t.diagnostic(`${total} bytes gzipped in all; the limit is ${LIMIT_BYTES}`);
  const wasm = sizes.map(({ path }) => path).filter((path) => path.endsWith(".wasm"));
  assert.deepEqual(wasm, [`${folder}/pkg/webgpu/scumble_web_bg.wasm`]);
  assert.ok(total <= LIMIT_BYTES, `${total} bytes`);
});

test("samples open without what only files need", async () => {
  const tab = await session.newTab();
  /** @type {string[]} */
  const urls = [];
  tab.onRequest((url) => urls.push(url.slice(session.url.length)));
  const editor = await Editor.open(tab, session.url, "webgpu");
  await editor.openSample("Apple");
  await editor.scribble([[30, 40], [40, 45]], 72);
  assert.deepEqual(urls.filter((path) => path.startsWith(`${folder}/pkg/files/`)), []);
  await editor.openDrawing("rooms");
  assert.ok(urls.some((path) => path.startsWith(`${folder}/pkg/files/scumble_files_bg.wasm`)));
});

test("no module names a path of the machine that built it", () => {
  for (const module of ["webgpu/scumble_web", "webgl/scumble_web", "files/scumble_files"]) {
    const bytes = readFileSync(new URL(`../../dist/${folder}/pkg/${module}_bg.wasm`, import.meta.url));
    for (const path of [homedir(), "registry/src"]) assert.ok(!bytes.includes(path), `${module} names ${path}`);
  }
});

/** @param {string} url */
function gzippedSize(url) {
  const path = url.slice(session.url.length) || "index.html";
  const file = fileURLToPath(new URL(`../../dist/${path}`, import.meta.url));
  return { path, bytes: execFileSync("gzip", ["-9cn", file], { maxBuffer: 1 << 24 }).length };
}
