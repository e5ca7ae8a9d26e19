// The samples: drawings of each kind, each to be opened as its colouring, which is made of scribbles, or as bare lines.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { join } from "node:path";
import { before, describe, test } from "node:test";
import { DIST, useSession, version } from "./harness.mjs";
import { distance } from "./picture.mjs";

/** @typedef {import("./harness.mjs").Editor} Editor */

const KINDS = ["fruit", "animal", "object", "portrait", "scene"];
const OPENMOJI = "OpenMoji, CC BY-SA 4.0";

/** The longer side of the apple's viewBox, and a place in it. */
const APPLE = 72;
const IN_APPLE = /** @type {[number, number]} */ ([36, 42]);
/** The longer side of the viewBox of the drawing that is there at first. */
const GOLDFISH = 400;
const PAPER = /** @type {[number, number, number]} */ ([255, 255, 255]);

describe("the gallery of samples", () => {
  const session = useSession("chromium");
  /** @type {{kind: string, file: string, name: string, credit: string}[]} */
  let samples;
  before(async () => {
    samples = JSON.parse(await readFile(join(DIST, await version(), "samples/index.json"), "utf8"));
  });

  test("has each kind, and shows whose each drawing is", async () => {
    assert.deepEqual([...new Set(samples.map(({ kind }) => kind))], KINDS);
    assert.equal(samples.filter(({ credit }) => credit === OPENMOJI).length, 12);
    const editor = await opened();
    const shelves = await editor.tab.evaluate(`
      [...document.querySelectorAll("#samples ul")].map((shelf) => [shelf.ariaLabel, shelf.children.length])`);
    const sizes = KINDS.map((kind) => samples.filter((sample) => sample.kind === kind).length);
    const titles = ["Fruit and flowers", "Animals", "Objects", "Portraits", "Scenes"];
    assert.deepEqual(shelves, titles.map((title, i) => [title, sizes[i]]));
    const cards = await editor.tab.evaluate(`
      [...document.querySelectorAll("#samples li")].map((card) => card.querySelector("small").textContent)`);
    assert.deepEqual(cards, samples.map(({ credit }) => credit));
    const notice = await editor.tab.evaluate(`document.querySelector("#samples .credit").textContent`);
    assert.match(notice, /openmoji\.org, licence CC BY-SA 4\.0/);
  });

  test("shows pictures, and fetches them only when it is opened", async () => {
    const tab = await session.newTab();
    /** @type {string[]} */
    const urls = [];
    tab.onRequest((url) => urls.push(url));
    await tab.goto(`${session.url}?renderer=cpu`);
    await tab.waitFor(`document.getElementById("status").textContent !== ""`);
    const inGallery = () => urls.filter((url) => /samples\/.*(png|json)$/.test(url));
    assert.deepEqual(inGallery(), []);
    await tab.click("button", "Samples");
    await tab.waitFor(`document.querySelector("#samples img")?.naturalWidth > 200`);
    assert.ok(inGallery().some((url) => url.endsWith("pear.png")));
  });

  test("opens each sample with its scribbles, and without", async () => {
    const editor = await session.open("cpu");
    for (const { name } of samples) {
      await editor.openColored(name);
      assert.ok((await scribbles(editor)) >= 5, name);
      await editor.openSample(name);
      assert.equal(await scribbles(editor), 0, name);
    }
    assert.deepEqual(editor.tab.faults, []);
  });

  test("scribbles of a colouring are erased, and undo brings them back, and the drawing before", async () => {
    const editor = await session.open("cpu");
    await editor.scribble([[200, 172], [220, 176]], GOLDFISH);
    await editor.openColored("Apple");
    const count = await scribbles(editor);
    const before = await editor.picture();
    const [place] = await editor.place([IN_APPLE], APPLE);
    assert.ok(distance(before.at(...place), PAPER) > 100);

    await editor.tab.press("e");
    // Over all of them.
    const rows = Array.from({ length: 13 }, (_, i) => 4 + 5 * i);
    const way = rows.flatMap((y) => /** @type {[number, number][]} */ ([[3, y], [69, y], [69, y + 2.5], [3, y + 2.5]]));
    const places = await editor.place(way, APPLE);
    await editor.until("erased", () => editor.drag(places));
    assert.equal(await scribbles(editor), 0);
    assert.ok(distance((await editor.picture()).at(...place), PAPER) < 2);

    await editor.until("Undone", () => editor.tab.press("Control+z"));
    assert.equal(await scribbles(editor), count);
    assert.ok((await editor.picture()).equals(before));
    await editor.until("Undone", () => editor.tab.press("Control+z"));
    assert.equal(await editor.name(), "Goldfish");
    assert.deepEqual(editor.tab.faults, []);
  });

  test("speaks the language of the page", async () => {
    const editor = await opened();
    await editor.tab.press("Escape");
    await editor.choose("Language", "de");
    await editor.tab.waitFor(`document.documentElement.lang === "de"`);
    await editor.click("Beispiele");
    await editor.until("Bergsee", () => editor.tab.click("button", "Bergsee: nur Linien"));
  });

  /** A page with the gallery open. */
  async function opened() {
    const editor = await session.open("cpu");
    await editor.click("Samples");
    await editor.tab.waitFor(`document.getElementById("samples")?.open`);
    return editor;
  }
});

/** How many scribbles there are. @param {Editor} editor */
async function scribbles(editor) {
  await editor.tab.press("v");
  await editor.tab.press("Escape");
  await editor.tab.press("Control+a");
  const count = await editor.tab.evaluate(`{
    const count = document.getElementById("selected-count");
    count.checkVisibility() ? Number.parseInt(count.textContent) : 0;
  }`);
  await editor.tab.press("Escape");
  return Number(count);
}
