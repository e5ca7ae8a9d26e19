// Save and Open: what is saved opens as the same drawing, the page says what it is called and whether it is saved, and
// what goes wrong leaves the work as it is.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { describe, test } from "node:test";
import { makeFolder, useSession } from "./harness.mjs";
import { assertSame, hex } from "./picture.mjs";

/** @typedef {import("./harness.mjs").Editor} Editor */

/** The longer side of the viewBox of the drawings here. */
const ROOMS = 200;
const APPLE = 72;
const IN_LEFT_ROOM = /** @type {[number, number][]} */ ([[30, 30], [50, 60], [70, 40]]);
const IN_RIGHT_ROOM = /** @type {[number, number][]} */ ([[120, 80], [130, 85]]);

/** The page's title while a drawing is saved, and while it is not. @param {string} name */
const saved = (name) => `${name} – Scumble`;
const unsaved = (/** @type {string} */ name) => `• ${saved(name)}`;

/** @param {Editor} editor @returns {Promise<string>} */
const title = (editor) => editor.tab.evaluate("document.title");

/**
 * Puts dialogs in place of the browser's, which nobody would answer here: they give real files of the browser's own
 * private folder, and count how often they are shown.
 * @param {Editor} editor
 */
const answerDialogs = (editor) =>
  editor.tab.evaluate(`{
    window.asked = 0;
    window.folder = navigator.storage.getDirectory();
    window.showSaveFilePicker = async ({ suggestedName }) => {
      window.asked++;
      return (await window.folder).getFileHandle(suggestedName, { create: true });
    };
    window.showOpenFilePicker = async () => [await (await window.folder).getFileHandle(window.chosen)];
  }`);

/** @param {Editor} editor @param {string} name @returns {Promise<any>} what was saved */
const content = async (editor, name) =>
  JSON.parse(await editor.tab.evaluate(`
    window.folder
      .then((folder) => folder.getFileHandle(${JSON.stringify(name)}))
      .then((handle) => handle.getFile())
      .then((file) => file.text())`));

for (const browser of /** @type {const} */ (["chromium", "firefox"])) {
  describe(`files in ${browser}`, () => {
    const session = useSession(browser);

    const scribbled = async () => {
      const editor = await session.open("cpu");
      await editor.openDrawing("rooms");
      await editor.scribble(IN_LEFT_ROOM, ROOMS);
      return editor;
    };

    test("what was saved opens as it was, and is saved to its own file again", async () => {
      const editor = await scribbled();
      await editor.choose("Blend", "srgb");
      await answerDialogs(editor);
      assert.equal(await title(editor), unsaved("rooms.svg"));
      await editor.until("Saved rooms.scumble", () => editor.click("Save"));
      assert.equal(await title(editor), saved("rooms.scumble"));
      const picture = await editor.picture();

      await editor.scribble(IN_RIGHT_ROOM, ROOMS);
      assert.equal(await title(editor), unsaved("rooms.scumble"));
      await editor.until("Undone", () => editor.click("Undo"));
      assert.equal(await title(editor), saved("rooms.scumble"), "it is as it was saved");

      await editor.openSample("Apple");
      await editor.tab.evaluate(`window.chosen = "rooms.scumble"`);
      await editor.until("Opened rooms.scumble", () => editor.tab.hold("Control", () => editor.tab.press("o")));
      assertSame(await editor.picture(), picture);
      assert.equal(await editor.tab.evaluate(`document.querySelector("[data-setting=blend]").value`), "srgb");
      assert.equal(await title(editor), saved("rooms.scumble"));

      await editor.scribble(IN_RIGHT_ROOM, ROOMS);
      await editor.until("Saved rooms.scumble", () => editor.tab.hold("Control", () => editor.tab.press("s")));
      assert.equal(await editor.tab.evaluate("window.asked"), 1, "it has its place");
      assert.equal((await content(editor, "rooms.scumble")).scribbles.length, 2);
      assert.deepEqual(editor.tab.faults, []);
    });

    test("a file that cannot be written is told of, and the next time another place is asked for", async () => {
      const editor = await scribbled();
      await answerDialogs(editor);
      await editor.until("Saved", () => editor.click("Save"));
      await editor.scribble(IN_RIGHT_ROOM, ROOMS);
      await editor.tab.evaluate(`{
        window.createWritable = FileSystemFileHandle.prototype.createWritable;
        FileSystemFileHandle.prototype.createWritable = () => Promise.reject(new DOMException("", "NotAllowedError"));
      }`);
      await editor.click("Save");
      await editor.tab.waitFor(`!document.getElementById("alert").hidden`);
      assert.match(await editor.message(), /could not be written/);
      assert.equal(await title(editor), unsaved("rooms.scumble"));
      await editor.tab.evaluate(`FileSystemFileHandle.prototype.createWritable = window.createWritable`);
      await editor.until("Saved rooms.scumble", () => editor.click("Save"));
      assert.equal(await editor.tab.evaluate("window.asked"), 2);
      assert.equal(await editor.message(), "");
      assert.equal((await content(editor, "rooms.scumble")).scribbles.length, 2);
      assert.deepEqual(editor.tab.faults, []);
    });

    test("whether a file may be written to again is asked before its content is made, and a refusal is told of", async () => {
      const editor = await scribbled();
      await answerDialogs(editor);
      await editor.until("Saved", () => editor.click("Save"));
      await editor.tab.evaluate(`{
        window.events = [];
        window.answer = "granted";
        FileSystemFileHandle.prototype.requestPermission = async ({ mode }) => {
          window.events.push(mode);
          return window.answer;
        };
        const { postMessage } = Worker.prototype;
        Worker.prototype.postMessage = function (...message) {
          window.events.push("content");
          postMessage.apply(this, message);
        };
      }`);
      await editor.scribble(IN_RIGHT_ROOM, ROOMS);
      await editor.until("Saved rooms.scumble", () => editor.click("Save"));
      assert.deepEqual(await editor.tab.evaluate("window.events"), ["readwrite", "content"]);
      await editor.tab.evaluate(`window.answer = "prompt"`);
      await editor.click("Save");
      await editor.tab.waitFor(`!document.getElementById("alert").hidden`);
      assert.match(await editor.message(), /could not be written/);
      await editor.until("Saved rooms.scumble", () => editor.click("Save"));
      assert.equal(await editor.tab.evaluate("window.asked"), 2, "another place is asked for");
      assert.deepEqual(editor.tab.faults, []);
    });

    test("a drawing that is saved while another comes up is known by its file", async () => {
      const editor = await scribbled();
      await answerDialogs(editor);
      await editor.tab.evaluate(`{
        const { createWritable } = FileSystemFileHandle.prototype;
        FileSystemFileHandle.prototype.createWritable = async function () {
          await new Promise((release) => (window.release = release));
          return createWritable.call(this);
        };
      }`);
      await editor.click("Save");
      await editor.tab.waitFor(`window.release`);
      await editor.openSample("Apple");
      await editor.until("Saved rooms.scumble", () => editor.tab.evaluate(`window.release()`));
      await editor.click("Recent drawings");
      await editor.tab.waitFor(`document.getElementById("recent")?.open`);
      await editor.until("Opened rooms.scumble", () => editor.click("Open rooms.scumble"));
      assert.equal(await title(editor), saved("rooms.scumble"));
      assert.deepEqual(editor.tab.faults, []);
    });

    test("a dialog that is closed changes nothing", async () => {
      const editor = await scribbled();
      await editor.tab.evaluate(`
        window.showSaveFilePicker = window.showOpenFilePicker =
          () => Promise.reject(new DOMException("", "AbortError"))`);
      await editor.click("Save");
      await editor.click("Open");
      await editor.until("Undone", () => editor.click("Undo"));
      assert.equal(await editor.message(), "");
      assert.equal(await title(editor), saved("rooms.svg"));
      assert.deepEqual(editor.tab.faults, []);
    });
  });
}

describe("files without the browser's dialogs", () => {
  const session = useSession("chromium");
  const folder = makeFolder();

  /** @param {string} name @param {string | object} content */
  const file = (name, content) => folder.write(name, typeof content === "string" ? content : JSON.stringify(content));

  test("they are downloaded, and open again", async () => {
    const editor = await session.open("cpu");
    await editor.openSample("Apple");
    await editor.scribble([[30, 40], [40, 45]], APPLE);
    const picture = await editor.picture();
    const path = await editor.tab.download(() => editor.click("Save"));
    const text = await readFile(path, "utf8");
    assert.equal(JSON.parse(text).sample, "1F34E.svg");
    await editor.openSample("Pear");
    const copy = await file("my apple.scumble", text);
    await editor.until("Opened my apple.scumble", () => editor.tab.chooseFiles([copy]));
    // A file's numbers have three digits.
    assertSame(await editor.picture(), picture);
    assert.equal(await title(editor), saved("my apple.scumble"));
    assert.deepEqual(editor.tab.faults, []);
  });

  test("a file's palette is shown, kept, and gone with the next drawing", async () => {
    const editor = await session.open("cpu");
    const palette = ["#3b82f6", "none", "#010203"];
    const path = await file("own.scumble", {
      format: "scumble", version: "1.0", canvas: [0, 0, 100, 100], palette, curves: [{ path: "M 0 0 L 9 9", width: 1 }],
    });
    const swatches = () =>
      editor.tab.evaluate(`[...document.querySelectorAll("#palette .swatch")].map((swatch) => swatch.ariaLabel)`);
    const usual = await swatches();
    await editor.until("Opened own", () => editor.tab.chooseFiles([path]));
    assert.deepEqual(await swatches(), ["Blue", "#010203", "No colour"]);
    await editor.tab.press("2");
    assert.equal(await editor.tab.evaluate(`document.getElementById("color").dataset.color`), "#010203");
    const again = await readFile(await editor.tab.download(() => editor.click("Save")), "utf8");
    assert.deepEqual(JSON.parse(again).palette, palette);
    await editor.openSample("Apple");
    assert.deepEqual(await swatches(), usual);
  });

  /** @type {Record<string, [string, RegExp]>} */
  const BAD_FILES = {
    "of a newer version": ['{"format": "scumble", "version": "2.0"}', /newer Scumble/],
    "of something else": ['{"colour": "red"}', /not a Scumble file/],
    "that are cut off": ['{"format": "scumble", "version": "1.0",\n"canvas": [0, 0, 1', /line 2/],
  };
  for (const [name, [content, message]] of Object.entries(BAD_FILES)) {
    test(`files ${name} say so and leave the work as it is`, async () => {
      const editor = await session.open("cpu");
      await editor.openDrawing("rooms");
      await editor.click("Red");
      await editor.scribble(IN_LEFT_ROOM, ROOMS);
      await editor.tab.chooseFiles([await file("bad.scumble", content)]);
      await editor.tab.waitFor(`!document.getElementById("alert").hidden`);
      assert.match(await editor.message(), message);
      const [[x, y]] = await editor.place([[60, 80]], ROOMS);
      await editor.toggle("Show scribbles");
      assert.equal(hex((await editor.picture()).at(x, y)), "#e5484d");
      assert.equal(await title(editor), unsaved("rooms.svg"));
      assert.deepEqual(editor.tab.faults, []);
    });
  }
});
