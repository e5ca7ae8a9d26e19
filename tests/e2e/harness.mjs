/**
 * The editor as its user has it: opened in a browser from a static server, found by role and name, drawn on with the
 * pointer, and judged by screenshots of its canvas.
 */
import assert from "node:assert/strict";
import { mkdtemp, readdir, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before } from "node:test";
import { setTimeout } from "node:timers/promises";
import { fileURLToPath } from "node:url";
import { Picture } from "./picture.mjs";
import { launch, PAINTED } from "./browsers.mjs";
import { serve } from "./static_server.mjs";

/** @typedef {import("./browsers.mjs").Tab} Tab */
/** @typedef {import("./browsers.mjs").Graphics} Graphics */
/** @typedef {{browser: "chromium" | "firefox", renderer: "webgpu" | "webgl" | "cpu"}} Target */

/** Each renderer in each browser that has it. @type {Target[]} */
export const TARGETS = [
  { browser: "chromium", renderer: "webgpu" },
  { browser: "chromium", renderer: "webgl" },
  { browser: "chromium", renderer: "cpu" },
  { browser: "firefox", renderer: "webgpu" },
];

export const DIST = fileURLToPath(new URL("../../dist", import.meta.url));

/** The folder of the version that was built, below `DIST`. */
export async function version() {
  return String((await readdir(DIST)).find((name) => name.startsWith("v-")));
}

/** Longer side of any page in drawing units. */
const PAGE_DU = 1024;

/** How wide Chromium draws the thumb of a slider. */
const THUMB_PX = 16;

/** @param {string} file */
export const drawing = (file) => fileURLToPath(new URL(`drawings/${file}`, import.meta.url));

/** A folder for the files of the tests of one `describe`, in which this is to be called. */
export function makeFolder() {
  const folder = {
    path: "",
    /**
     * Writes a file.
     * @param {string} name
     * @param {string | Uint8Array} content
     * @returns its path
     */
    write: async (name, content) => {
      const path = join(folder.path, name);
      await writeFile(path, content);
      return path;
    },
  };
  before(async () => {
    folder.path = await mkdtemp(join(tmpdir(), "scumble-"));
  });
  // A browser that is ending may write into its history still.
  after(() => rm(folder.path, { recursive: true, force: true, maxRetries: 20, retryDelay: 100 }));
  return folder;
}

/**
 * A browser and a server. The page is served from a path of its own, as on a host that serves more than one.
 *
 * @param {Target["browser"]} name
 * @param {Graphics} [graphics]
 */
export async function start(name, graphics) {
  // A server that is left behind where no browser comes up would keep the tests from ending.
  const browser = await launch(name, graphics);
  const { server, url } = await serve(DIST, { base: "/some/where/" });
  return {
    url,
    newTab: browser.open,
    /** The page in a tab, as it comes up again. @param {Tab} tab */
    reopen: (tab) => Editor.open(tab, `${url}?renderer=cpu`, "cpu"),
    /**
     * @param {Target["renderer"]} renderer
     * @param {string} [more] of the address
     */
    open: async (renderer, more = "") =>
      Editor.open(await browser.open(), `${url}?renderer=${renderer}${more}`, renderer),
    close: async () => {
      await browser.close();
      server.close();
    },
  };
}

/**
 * A browser and a server for the tests of one `describe` or file, in which this is to be called.
 * @param {Target["browser"]} name
 * @param {Graphics} [graphics] needed for what does not draw with the CPU
 */
export function useSession(name, graphics) {
  const session = /** @type {Awaited<ReturnType<typeof start>>} */ ({});
  before(async () => void Object.assign(session, await start(name, graphics)));
  after(() => session.close());
  return session;
}

export class Editor {
  /** @param {Tab} tab */
  constructor(tab) {
    this.tab = tab;
  }

  /**
   * @param {Tab} tab
   * @param {string} url
   * @param {Target["renderer"]} renderer the one that must come up
   */
  static async open(tab, url, renderer) {
    await tab.goto(url);
    await tab.waitFor(`
      document.getElementById("status").textContent !== "" || !document.getElementById("alert").hidden`);
    const editor = new Editor(tab);
    assert.equal(await editor.message(), "");
    assert.equal(await tab.evaluate(`document.getElementById("canvas").dataset.renderer`), renderer);
    return editor;
  }

  /** What the page warns of; empty where it does not. @returns {Promise<string>} */
  message() {
    return this.tab.evaluate(`
      document.getElementById("alert").hidden ? "" : document.querySelector("#alert p").textContent`);
  }

  /** What just happened, in the page's words. @returns {Promise<string>} */
  status() {
    return this.tab.evaluate(`document.getElementById("status").textContent`);
  }

  /**
   * Acts, and waits until the page has said something that contains the words.
   * @param {string} words
   * @param {() => Promise<unknown>} act
   */
  async until(words, act) {
    // What was said before must not be taken for the answer.
    await this.tab.evaluate(`document.getElementById("status").textContent = ""`);
    await act();
    await this.tab.waitFor(`document.getElementById("status").textContent.includes(${JSON.stringify(words)})`);
  }

  /** Waits until the browser keeps the drawing as it is. */
  kept() {
    return this.tab.waitFor(`document.getElementById("drawing").dataset.kept === "true"`);
  }

  /** Whether the page may be left without a question. @returns {Promise<boolean>} */
  leaves() {
    return this.tab.evaluate(`window.dispatchEvent(new Event("beforeunload", { cancelable: true }))`);
  }

  /** What the drawing is called. @returns {Promise<string>} */
  name() {
    return this.tab.evaluate(`document.getElementById("drawing").textContent`);
  }

  /** @param {string} name */
  click(name) {
    return this.#reach(name, () => this.tab.click("button", name));
  }

  /** Checks or unchecks a box. @param {string} name */
  toggle(name) {
    return this.#reach(name, () => this.tab.click("checkbox", name));
  }

  /**
   * Uses a control. Where it lies in a panel that is closed, its button opens that before, and Escape closes it after
   * if it is still open.
   * @param {string} name of the control, or its id
   * @param {() => Promise<unknown>} act
   */
  async #reach(name, act) {
    const opener = await this.tab.evaluate(`{
      const wanted = ${JSON.stringify(name)};
      const isIt = (control) => control.id === wanted || (control.ariaLabel ?? control.labels?.[0]?.textContent ?? control.textContent) === wanted;
      const panels = [...document.querySelectorAll("[popover]")].filter((panel) => !panel.checkVisibility());
      const panel = panels.find((panel) => [...panel.querySelectorAll("button, input, select")].some(isIt));
      panel && document.querySelector('[popovertarget="' + panel.id + '"]').ariaLabel;
    }`);
    if (opener) await this.tab.click("button", opener);
    await act();
    if (opener && (await this.tab.evaluate(`document.querySelector(":popover-open:not(#alert)") !== null`))) {
      await this.tab.press("Escape");
    }
  }

  /**
   * Picks an option of a list.
   * @param {string} name of the list
   * @param {string} option its value
   */
  choose(name, option) {
    return this.#reach(name, () => this.tab.choose(name, option));
  }

  /**
   * Drags a slider whose range is 0 to 100 from where it is to a percentage.
   * @param {string} id
   * @param {number} percent
   * @param {() => Promise<unknown>} [look] while it is held there
   */
  slide(id, percent, look = async () => {}) {
    return this.#reach(id, () => this.#slide(id, percent, look));
  }

  /**
   * @param {string} id
   * @param {number} percent
   * @param {() => Promise<unknown>} look
   */
  async #slide(id, percent, look) {
    /** @type {{x: number, y: number, width: number, height: number, value: number}} */
    const { x, y, width, height, value } = await this.tab.evaluate(`{
      const slider = document.getElementById(${JSON.stringify(id)});
      ({ ...slider.getBoundingClientRect().toJSON(), value: slider.valueAsNumber });
    }`);
    const at = (/** @type {number} */ p) => x + THUMB_PX / 2 + ((width - THUMB_PX) * p) / 100;
    await this.tab.mouse.move(at(value), y + height / 2);
    await this.tab.mouse.down();
    for (const step of [0.3, 0.7, 1]) await this.tab.mouse.move(at(value + step * (percent - value)), y + height / 2);
    await look();
    await this.tab.mouse.up();
  }

  /** Opens a drawing of the tests through "Open". @param {string} name of the file, without `.svg` */
  openDrawing(name) {
    const choose = () => this.tab.chooseFiles([drawing(`${name}.svg`)]);
    return this.until(`Opened ${name}`, () => this.#reach("Open", choose));
  }

  /** Drops files on the page, all of one content. @param {string} svg @param {string[]} names */
  drop(svg, ...names) {
    return this.tab.evaluate(`{
      const data = new DataTransfer();
      for (const name of ${JSON.stringify(names)}) data.items.add(new File([${JSON.stringify(svg)}], name, { type: "image/svg+xml" }));
      document.getElementById("canvas").dispatchEvent(new DragEvent("drop", { dataTransfer: data, bubbles: true }));
    }`);
  }

  /**
   * Opens the lines of a sample.
   * @param {string} name
   */
  openSample(name) {
    return this.#openSample(name, `${name}: lines only`);
  }

  /**
   * Opens a sample with its scribbles.
   * @param {string} name
   */
  openColored(name) {
    return this.#openSample(name, name);
  }

  /**
   * @param {string} name
   * @param {string} button
   */
  async #openSample(name, button) {
    await this.click("Samples");
    await this.tab.waitFor(`document.getElementById("samples")?.open`);
    await this.until(`Opened ${name}`, () => this.tab.click("button", button));
  }

  /**
   * Waits until the picture comes from a source: "mesh" or "gpu", or "without-gpu", which is the mesh solver in place of
   * the other.
   * @param {string} source
   */
  shows(source) {
    return this.tab.waitFor(`document.getElementById("canvas").dataset.solver === ${JSON.stringify(source)}`);
  }

  /** The corner and the size of the canvas in the window. @returns {Promise<DOMRect>} */
  box() {
    return this.tab.evaluate(`document.getElementById("canvas").getBoundingClientRect().toJSON()`);
  }

  /**
   * Where points of a drawing lie on the canvas, in CSS pixels.
   * @param {[number, number][]} points in units of the drawing's viewBox, which begins at 0, 0
   * @param {number} longer_side of the viewBox
   * @returns {Promise<[number, number][]>}
   */
  async place(points, longer_side) {
    /** @type {string} */
    const view = await this.tab.evaluate(`document.getElementById("canvas").dataset.view`);
    const [a, b, c, d, e, f] = view.split(" ").map(Number);
    const du = PAGE_DU / longer_side;
    return points.map(([x, y]) => [du * (a * x + c * y) + e, du * (b * x + d * y) + f]);
  }

  /**
   * Drags the pointer over the canvas with the button down.
   * @param {[number, number][]} points in CSS pixels of the canvas
   */
  async drag(points) {
    const { x, y } = await this.box();
    const [[startX, startY], ...rest] = points;
    await this.tab.mouse.move(x + startX, y + startY);
    await this.tab.mouse.down();
    for (const [px, py] of rest) await this.tab.mouse.move(x + px, y + py);
    await this.tab.mouse.up();
  }

  /**
   * The same at a number of moves each second, whether or not the page keeps up.
   * @param {[number, number][]} points in CSS pixels of the canvas
   * @param {number} rate_hz
   */
  async trace([[startX, startY], ...rest], rate_hz) {
    const { x, y } = await this.box();
    await this.tab.mouse.move(x + startX, y + startY);
    await this.tab.mouse.down();
    const begin_ms = performance.now();
    const moves = rest.map(async ([px, py], i) => {
      await setTimeout(begin_ms + ((i + 1) * 1000) / rate_hz - performance.now());
      await this.tab.mouse.move(x + px, y + py);
    });
    await Promise.all(moves);
    await this.tab.mouse.up();
  }

  /**
   * Scribbles through points of a drawing, and waits until the scribble is there.
   * @param {[number, number][]} points in units of the drawing's viewBox
   * @param {number} longer_side of the viewBox
   */
  async scribble(points, longer_side) {
    const way = await this.place(points, longer_side);
    await this.until("added, ", () => this.drag(way));
  }

  /** What the canvas shows once it has come to rest: twice the same in a row. */
  async picture() {
    let [before, after] = [await this.screenshot(), await this.screenshot()];
    while (!after.equals(before)) [before, after] = [after, await this.screenshot()];
    return Picture.decode(after);
  }

  async screenshot() {
    await this.tab.evaluate(PAINTED);
    const { x, y, width, height } = await this.box();
    return Buffer.from(await this.tab.screenshot({ x, y, width, height }));
  }
}
