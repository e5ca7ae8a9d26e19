/**
 * What `cargo xtask bench --web` prints: the tables of `scumble bench`, compiled to wasm, in Chromium; how long the page
 * takes to come up, and to open a drawing of 100,000 pieces; and, for the drawings of a set, how long the pen waits in it.
 *
 *     node tests/e2e/bench.mjs PROGRAM.wasm SET|--made|--memory
 */
import { mkdtemp, readFile, readdir, rm, symlink, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { Editor, start } from "./harness.mjs";
import { launch } from "./browsers.mjs";
import { serve } from "./static_server.mjs";

/** @typedef {{[name: string]: string | Tree}} Tree the files of a folder by name, each with the address that it is had from */

const WASI = fileURLToPath(new URL("../../node_modules/@bjorn3/browser_wasi_shim/dist", import.meta.url));

/** With these a page's clock is as fine as it gets, 5 µs. */
const ISOLATED = { "cross-origin-opener-policy": "same-origin", "cross-origin-embedder-policy": "require-corp" };

const PAGE = `<!doctype html><script type="importmap">
  {"imports": {"@bjorn3/browser_wasi_shim": "./wasi/index.js"}}
</script>`;

/** The pen is taken over every so many-th drawing of a set. */
const PEN_EVERY = 10;

/** So often a pen reports where it is. */
const PEN_HZ = 240;

/** The painter on the CPU is for machines without a GPU. @param {string} renderer */
const startFor = (renderer) => start("chromium", { hasGpu: renderer !== "cpu" });

/** How often the page is opened. */
const VISITS = 9;

/** How often a large drawing is. */
const OPENINGS = 5;

/** Rings in a row, and rows: they have 100,000 pieces. */
const RINGS = 56;

/**
 * Runs a program in the page, and tells what it wrote.
 * @param {string[]} args
 * @param {Tree} tree what it has of files
 */
async function runInPage(args, tree) {
  const { ConsoleStdout, Directory, File, OpenFile, PreopenDirectory, WASI } = await import("@bjorn3/browser_wasi_shim");
  /** @type {(tree: Tree) => Promise<Map<string, import("@bjorn3/browser_wasi_shim").Inode>>} */
  const fetched = async (tree) => {
    const entry = async (/** @type {string | Tree} */ at) =>
      typeof at === "string" ? new File(await (await fetch(at)).arrayBuffer()) : new Directory(await fetched(at));
    const pairs = Object.entries(tree).map(async ([name, at]) => /** @type {const} */ ([name, await entry(at)]));
    return new Map(await Promise.all(pairs));
  };
  /** @type {string[]} */
  const lines = [];
  const write = () => ConsoleStdout.lineBuffered((line) => void lines.push(line));
  const files = [new OpenFile(new File([])), write(), write(), new PreopenDirectory(".", await fetched(tree))];
  const wasi = new WASI(["scumble", ...args], [], files);
  const imports = { wasi_snapshot_preview1: wasi.wasiImport };
  const { instance } = await WebAssembly.instantiateStreaming(fetch("program.wasm"), imports);
  const code = wasi.start(/** @type {any} */ (instance));
  if (code !== 0) throw new Error(lines.join("\n"));
  return lines.join("\n");
}

/**
 * @param {string} folder
 * @param {string} at its address
 * @returns {Promise<Tree>}
 */
async function treeOf(folder, at) {
  const entries = await readdir(folder, { withFileTypes: true });
  const pairs = entries.map(async (entry) => {
    const [path, there] = [join(folder, entry.name), `${at}/${entry.name}`];
    return [entry.name, entry.isDirectory() ? await treeOf(path, there) : there];
  });
  return Object.fromEntries(await Promise.all(pairs));
}

/**
 * The tables of `scumble bench`.
 * @param {string} program
 * @param {string} what of them
 * @param {string | undefined} set
 */
async function tables(program, what, set) {
  const folder = await mkdtemp(join(tmpdir(), "scumble-"));
  const links = [["program.wasm", program], ["wasi", WASI], ...(set ? [["set", set]] : [])];
  await Promise.all(links.map(([name, target]) => symlink(target, join(folder, name))));
  await writeFile(join(folder, "index.html"), PAGE);
  const browser = await launch("chromium");
  const { server, url } = await serve(folder, { headers: ISOLATED });
  try {
    const tab = await browser.open();
    await tab.goto(url);
    const args = ["bench", set ? "set" : what];
    const tree = set ? { set: await treeOf(set, "set") } : {};
    return await tab.evaluate(`(${runInPage})(${JSON.stringify(args)}, ${JSON.stringify(tree)})`);
  } finally {
    await browser.close();
    server.close();
    await rm(folder, { recursive: true });
  }
}

/**
 * Notes, in the page, how many samples a pen's moves brought, and for each frame after such moves how long its work took
 * and how long before its end the first of them was.
 */
function noteFrames() {
  /** @type {number | undefined} */
  let moved_ms;
  /** @type {[number, number][]} */
  const frames_ms = [];
  const noted = { frames_ms, samples: 0 };
  Object.assign(window, { noted });
  const note = (/** @type {PointerEvent} */ event) => {
    if (event.buttons === 0) return;
    moved_ms ??= event.timeStamp;
    noted.samples += event.getCoalescedEvents().length;
  };
  addEventListener("pointermove", note, true);
  const ask = window.requestAnimationFrame.bind(window);
  window.requestAnimationFrame = (act) =>
    ask((now) => {
      const start_ms = performance.now();
      act(now);
      const end_ms = performance.now();
      if (moved_ms !== undefined) frames_ms.push([end_ms - start_ms, end_ms - moved_ms]);
      moved_ms = undefined;
    });
}

/**
 * What the page noted while the scribbles of a set were drawn, and how many samples there were.
 * @param {string} set
 * @param {"webgpu" | "cpu"} renderer
 * @returns {Promise<{frames_ms: [number, number][], samples: number, sent: number}>}
 */
async function penTimes(set, renderer) {
  const session = await startFor(renderer);
  try {
    const tab = await session.newTab();
    await tab.prepare(`(${noteFrames})()`);
    const editor = await Editor.open(tab, `${session.url}?renderer=${renderer}`, renderer);
    /** @type {{id: string}[]} */
    const entries = JSON.parse(await readFile(join(set, "index.json"), "utf8"));
    let sent = 0;
    for (const { id } of entries.filter((_, i) => i % PEN_EVERY === 0)) sent += await scribbleAll(editor, join(set, id));
    return { ...(await tab.evaluate("noted")), sent };
  } finally {
    await session.close();
  }
}

/**
 * Opens a drawing and draws its scribbles, but for dabs.
 * @param {Editor} editor
 * @param {string} folder
 * @returns how many samples these have
 */
async function scribbleAll(editor, folder) {
  await editor.until("Opened", () => editor.tab.chooseFiles([join(folder, "drawing.svg")]));
  const size = /viewBox="0 0 ([\d.]+) ([\d.]+)"/.exec(await readFile(join(folder, "drawing.svg"), "utf8"));
  const longer_side = Math.max(Number(size?.[1]), Number(size?.[2]));
  /** @type {{scribbles: {points: [number, number][]}[]}} */
  const { scribbles } = JSON.parse(await readFile(join(folder, "dense.json"), "utf8"));
  const ways = scribbles.map(({ points }) => points).filter((way) => way.length > 1);
  for (const way of ways) await editor.trace(await editor.place(way, longer_side), PEN_HZ);
  return ways.reduce((sum, way) => sum + way.length - 1, 0);
}

/** What stands over a table of waits. @param {string} name */
const heading = (name) => `\n${name.padEnd(46)} median ms      95 %   largest`;

/**
 * @param {string} name
 * @param {number[]} times_ms
 */
function row(name, times_ms) {
  const sorted = [...times_ms].sort((a, b) => a - b);
  const at = (/** @type {number} */ part) => sorted[Math.max(0, Math.ceil(part * sorted.length) - 1)] ?? 0;
  return name.padEnd(46) + [0.5, 0.95, 1].map((part) => at(part).toFixed(2).padStart(10)).join("");
}

/** Notes, in the page, when its toolbar was painted and when there was a drawing to scribble on, in ms since it was asked for. */
function noteStart() {
  addEventListener("DOMContentLoaded", () => {
    const status = /** @type {HTMLElement} */ (document.getElementById("status"));
    const observer = new MutationObserver(() => {
      const [paint] = performance.getEntriesByName("first-contentful-paint");
      if (status.textContent !== "") Object.assign(window, { start_ms: [paint?.startTime ?? 0, performance.now()] });
    });
    observer.observe(status, { childList: true });
  });
}

/**
 * Times of first visits, each with nothing kept by the browser.
 * @param {"webgpu" | "webgl" | "cpu"} renderer
 * @returns {Promise<[number, number][]>} in ms
 */
async function startTimes(renderer) {
  const session = await startFor(renderer);
  try {
    /** @type {[number, number][]} */
    const times_ms = [];
    for (let visit = 0; visit < VISITS; visit++) {
      const tab = await session.newTab({ isFirst: true });
      await tab.prepare(`(${noteStart})()`);
      await Editor.open(tab, `${session.url}?renderer=${renderer}`, renderer);
      times_ms.push(await tab.evaluate("window.start_ms"));
      await tab.close();
    }
    return times_ms;
  } finally {
    await session.close();
  }
}

async function printStart() {
  console.log(heading("a first visit"));
  for (const renderer of /** @type {const} */ (["webgpu", "webgl", "cpu"])) {
    const times_ms = await startTimes(renderer);
    console.log(row(`${renderer}: until the toolbar is painted`, times_ms.map(([paint_ms]) => paint_ms)));
    console.log(row(`${renderer}: until there is a drawing to colour`, times_ms.map(([, ready_ms]) => ready_ms)));
  }
}

/** Polygons that overlap their neighbours, as SVG. */
function rings() {
  const cell = 1000 / RINGS;
  const middle = (/** @type {number} */ i) => (i + 0.5) * cell;
  const ring = (/** @type {number} */ x, /** @type {number} */ y) => {
    const turns = Array.from({ length: 12 }, (_, k) => ((k + 0.3) * Math.PI) / 6);
    const corners = turns.map((turn) => `${(x + 0.6 * cell * Math.cos(turn)).toFixed(2)} ${(y + 0.6 * cell * Math.sin(turn)).toFixed(2)}`);
    return `<path d="M${corners.join("L")}Z"/>`;
  };
  const all = Array.from({ length: RINGS ** 2 }, (_, i) => ring(middle(i % RINGS), middle(Math.floor(i / RINGS))));
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 1000 1000" fill="none" stroke="black">${all.join("")}</svg>`;
}

/**
 * Drops a drawing on the page. Gives the time until its lines are there, that until its picture is, and that of the longest task
 * meanwhile; 0 where none is as long as browsers report.
 * @param {string} svg
 * @returns {Promise<[number, number, number]>} in ms
 */
function timeOpening(svg) {
  let longest_ms = 0;
  new PerformanceObserver((tasks) => {
    longest_ms = Math.max(longest_ms, ...tasks.getEntries().map(({ duration }) => duration));
  }).observe({ entryTypes: ["longtask"] });
  const [status, bar] = ["status", "busy"].map((id) => /** @type {HTMLElement} */ (document.getElementById(id)));
  status.textContent = "";
  const start_ms = performance.now();
  const dataTransfer = new DataTransfer();
  dataTransfer.items.add(new File([svg], "rings.svg", { type: "image/svg+xml" }));
  document.getElementById("canvas")?.dispatchEvent(new DragEvent("drop", { dataTransfer, bubbles: true }));
  const once = (/** @type {() => boolean} */ isSo) =>
    /** @type {Promise<number>} */ (new Promise((done) => {
      const look = () => (isSo() ? done(performance.now() - start_ms) : requestAnimationFrame(look));
      look();
    }));
  return once(() => status.textContent !== "").then(async (lines_ms) => {
    const made_ms = await once(() => bar.hidden === true);
    // The picture for the list is made, and tasks are reported, a while later.
    await new Promise((wake) => setTimeout(wake, 2000));
    return [lines_ms, made_ms, longest_ms];
  });
}

async function printOpening() {
  console.log(heading("100,000 pieces are opened"));
  for (const renderer of /** @type {const} */ (["webgpu", "webgl", "cpu"])) {
    const session = await startFor(renderer);
    try {
      /** @type {[number, number, number][]} */
      const times_ms = [];
      for (let i = 0; i < OPENINGS; i++) {
        const editor = await session.open(renderer);
        await editor.tab.evaluate(`window.svg = ${JSON.stringify(rings())}`);
        times_ms.push(await editor.tab.evaluate(`(${timeOpening})(window.svg)`));
        await editor.tab.close();
      }
      const names = ["until its lines are there", "until its picture is", "the longest task, or 0 under 50 ms"];
      names.forEach((name, i) => console.log(row(`${renderer}: ${name}`, times_ms.map((each_ms) => each_ms[i]))));
    } finally {
      await session.close();
    }
  }
}

/** @param {string} set */
async function printPen(set) {
  console.log(heading("the pen in the page"));
  for (const renderer of /** @type {const} */ (["webgpu", "cpu"])) {
    const { frames_ms, samples, sent } = await penTimes(set, renderer);
    console.log(row(`${renderer}: a frame's work`, frames_ms.map(([work_ms]) => work_ms)));
    console.log(row(`${renderer}: from a sample to the end of its frame`, frames_ms.map(([, wait_ms]) => wait_ms)));
    console.log(`${renderer}: ${samples} of ${sent} samples at ${PEN_HZ} Hz came`);
  }
}

const [program, what] = process.argv.slice(2);
const set = what.startsWith("--") ? undefined : resolve(what);
console.log(await tables(resolve(program), what, set));
if (what !== "--memory") {
  await printStart();
  await printOpening();
}
if (set) await printPen(set);
