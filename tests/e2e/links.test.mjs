// Share links: what is shared opens as it was in either browser, beside what is there; a bad link leaves that alone.
import assert from "node:assert/strict";
import { describe, test } from "node:test";
import { Editor, makeFolder, useSession } from "./harness.mjs";
import { assertSame } from "./picture.mjs";

/** The longer sides of the viewBoxes of the drawings here. */
const ROOMS = 200;
const APPLE = 72;

/** @typedef {[number, number]} Point */
const IN_APPLE = /** @type {Point[]} */ ([[30, 40], [40, 45]]);
const IN_LEFT_ROOM = /** @type {Point[]} */ ([[30, 30], [50, 60], [70, 40]]);

const BLUE = "Blue";

/** @param {Editor} editor @param {string} id @returns {Promise<string>} */
const text = (editor, id) => editor.tab.evaluate(`document.getElementById(${JSON.stringify(id)}).textContent`);

/** @param {Editor} editor @param {string} id @returns {Promise<boolean>} */
const isShown = (editor, id) => editor.tab.evaluate(`document.getElementById(${JSON.stringify(id)}).checkVisibility()`);

/** @param {Editor} editor @returns {Promise<string>} the link that the dialog shows */
const shared = async (editor) => {
  await editor.click("Share");
  await editor.tab.waitFor(`document.getElementById("share")?.open`);
  return editor.tab.evaluate(`document.getElementById("link").value`);
};

/** @param {Editor} editor */
const warned = (editor) => editor.tab.waitFor(`!document.getElementById("alert").hidden`);

for (const browser of /** @type {const} */ (["chromium", "firefox"])) {
  describe(`links in ${browser}`, () => {
    const session = useSession(browser);

    /** Opens a link in a tab of its own, with the renderer of the tests. @param {string} link */
    const opened = async (link) => {
      const [page, fragment] = link.split("#");
      return Editor.open(await session.newTab(), `${page}?renderer=cpu#${fragment}`, "cpu");
    };

    test("a coloured sample goes by its name, and comes back with its lines", async () => {
      const editor = await session.open("cpu");
      await editor.openSample("Apple");
      await editor.click(BLUE);
      await editor.scribble(IN_APPLE, APPLE);
      const link = await shared(editor);
      assert.ok(link.startsWith(`${session.url}#1.`), link);
      assert.ok(link.length < session.url.length + 100, "no lines are in it");
      await editor.click("Close");

      const other = await opened(link);
      assertSame(await other.picture(), await editor.picture());
      assert.equal(await other.status(), "Opened Shared drawing");
      assert.equal(await other.tab.evaluate("location.hash"), "", "the address is the page's own");
      assert.deepEqual([...editor.tab.faults, ...other.tab.faults], []);
    });

    test("a drawing of one's own goes with its lines", async () => {
      const editor = await session.open("cpu");
      await editor.openDrawing("rooms");
      await editor.scribble(IN_LEFT_ROOM, ROOMS);
      const link = await shared(editor);
      await editor.click("Close");
      assertSame(await (await opened(link)).picture(), await editor.picture());
      assert.deepEqual(editor.tab.faults, []);
    });

    test("a link opens beside the work that is there, and says so", async () => {
      const editor = await session.open("cpu");
      await editor.openSample("Apple");
      const link = await shared(editor);
      await editor.click("Close");
      await editor.openDrawing("rooms");
      await editor.scribble(IN_LEFT_ROOM, ROOMS);
      const work = await editor.picture();
      await editor.until("Undo goes back to rooms.svg", () =>
        editor.tab.evaluate(`location.hash = ${JSON.stringify(link.slice(link.indexOf("#")))}`));
      assert.ok(!(await editor.picture()).equals(work));
      await editor.until("Undone", () => editor.click("Undo"));
      assert.ok((await editor.picture()).equals(work));
      assert.deepEqual(editor.tab.faults, []);
    });

    test("a damaged link says so and leaves the work as it is", async () => {
      const editor = await session.open("cpu");
      await editor.openDrawing("rooms");
      await editor.scribble(IN_LEFT_ROOM, ROOMS);
      const link = await shared(editor);
      await editor.click("Close");
      const work = await editor.picture();
      const middle = Math.floor((link.length + link.indexOf("#")) / 2);
      const other = link[middle] === "A" ? "B" : "A";
      for (const bad of [`${link.slice(0, middle)}${other}${link.slice(middle + 1)}`, link.slice(0, -1), "#1.", "#1.é"]) {
        await editor.tab.evaluate(`location.hash = ${JSON.stringify(bad.slice(bad.indexOf("#")))}`);
        await warned(editor);
        assert.match(await editor.message(), /damaged/);
        await editor.click("Dismiss");
        assert.ok((await editor.picture()).equals(work));
      }
      for (const other of ["#1", "#1,AAAA", "#s=..garbage", "#start"]) {
        await editor.tab.evaluate(`location.hash = ${JSON.stringify(other)}`);
        await warned(editor);
        assert.match(await editor.message(), /This is no link to a drawing/, other);
        assert.equal(await editor.tab.evaluate("location.hash"), "");
        await editor.tab.press("Escape");
        await editor.tab.waitFor(`document.getElementById("alert").hidden`);
        assert.ok((await editor.picture()).equals(work));
      }
      await editor.tab.evaluate(`location.hash = "#2.AAAA"`);
      await warned(editor);
      assert.match(await editor.message(), /newer Scumble/);
      assert.equal(await editor.tab.evaluate("location.hash"), "#2.AAAA", "a reload may bring that Scumble");
      assert.deepEqual(editor.tab.faults, []);
    });

    for (const [link, words] of /** @type {const} */ ([["#1.AAAA", /damaged/], ["#1", /no link/]])) {
      test(`a page that is opened with ${link} says what is wrong beside the first sample`, async () => {
        const tab = await session.newTab();
        await tab.goto(`${session.url}?renderer=cpu${link}`);
        const editor = new Editor(tab);
        await tab.waitFor(`document.getElementById("drawing").textContent === "Goldfish"`);
        await warned(editor);
        assert.match(await editor.message(), words);
        assert.deepEqual(tab.faults, []);
      });
    }
  });
}

describe("the dialog of links", () => {
  const session = useSession("chromium");
  const folder = makeFolder();

  /**
   * An editor with a drawing that has a palette of so many colours: each takes some four characters of a link.
   * @param {number} count
   */
  const colorful = async (count) => {
    const color = (/** @type {number} */ i) => `#${((i * 2_654_435_761) % 0xffffff).toString(16).padStart(6, "0")}`;
    const palette = Array.from({ length: count }, (_, i) => color(i));
    const work = { format: "scumble", version: "1.0", canvas: [0, 0, 100, 100], palette };
    const path = await folder.write(`${count}.scumble`, JSON.stringify(work));
    const editor = await session.open("cpu");
    await editor.until(`Opened ${count}`, () => editor.tab.chooseFiles([path]));
    return editor;
  };

  test("it tells how far a link of its length gets, with a code for short ones", async () => {
    for (const [count, words, hasCode] of /** @type {const} */ ([
      [100, "nearly everywhere", true],
      [1000, "some programs", false],
      [4000, "many programs", false],
    ])) {
      const editor = await colorful(count);
      const link = await shared(editor);
      assert.ok((await text(editor, "length-text")).startsWith(`${link.length.toLocaleString("en")} characters`));
      assert.ok((await text(editor, "length-text")).includes(words), `${link.length} characters`);
      assert.equal(await editor.tab.evaluate(`document.getElementById("length").value`), link.length);
      if (hasCode) await editor.tab.waitFor(`document.getElementById("code").checkVisibility()`);
      else assert.equal(await isShown(editor, "code"), false);
      assert.deepEqual(editor.tab.faults, []);
    }
  });

  test("what is too long for a link is offered as a file", async () => {
    for (const count of [10_000, 30_000]) {
      const editor = await colorful(count);
      await shared(editor);
      assert.equal(await isShown(editor, "link"), false);
      assert.match(await text(editor, "length-text"), /save it as a file/);
      assert.ok(await editor.tab.download(() => editor.click("Save as a file")));
      assert.deepEqual(editor.tab.faults, []);
    }
  });

  test("Copy copies, or says how to", async () => {
    const editor = await colorful(10);
    const link = await shared(editor);
    await editor.tab.evaluate(`navigator.clipboard.writeText = async (text) => void (window.copied = text)`);
    await editor.click("Copy");
    await editor.tab.waitFor(`document.getElementById("share-status").textContent === "Copied"`);
    assert.equal(await editor.tab.evaluate("window.copied"), link);
    await editor.tab.evaluate(`navigator.clipboard.writeText = () => Promise.reject(new Error("no"))`);
    await editor.click("Copy");
    await editor.tab.waitFor(`document.getElementById("share-status").textContent.includes("Ctrl+C")`);
    assert.equal(await editor.tab.evaluate("getSelection().toString()"), link);
    assert.deepEqual(editor.tab.faults, []);
  });
});
