// Toolbars are one stop of Tab each, and the whole screen is to be had.
import assert from "node:assert/strict";
import { describe, test } from "node:test";
import { useSession } from "./harness.mjs";

/** @typedef {import("./harness.mjs").Editor} Editor */

/** @param {Editor} editor @returns {Promise<string>} what has the focus */
const focused = (editor) => editor.tab.evaluate("document.activeElement.ariaLabel");

/** @param {Editor} editor @param {string[]} keys @returns {Promise<string[]>} what has the focus after each */
const afterEach = async (editor, keys) => {
  const names = [];
  for (const key of keys) {
    await editor.tab.press(key);
    names.push(await focused(editor));
  }
  return names;
};

/** @param {Editor} editor @param {string} name of the control that is given the focus */
const focus = (editor, name) =>
  editor.tab.evaluate(`[...document.querySelectorAll("button, input")].find((control) => control.ariaLabel === "${name}").focus()`);

for (const browser of /** @type {const} */ (["chromium", "firefox"])) {
  describe(`toolbars in ${browser}`, () => {
    const session = useSession(browser);

    test("the bar is one stop of Tab, and the arrow keys, Home and End go through it", async () => {
      const editor = await session.open("cpu");
      const stops = await editor.tab.evaluate(`
        [...document.querySelectorAll("#bar :is(button, input)")].filter((c) => c.checkVisibility() && c.tabIndex === 0).map((c) => c.ariaLabel)`);
      assert.deepEqual(stops, ["Open"]);
      await focus(editor, "Open");
      assert.deepEqual(await afterEach(editor, ["ArrowRight", "ArrowRight", "ArrowLeft"]), ["Save", "Recent drawings", "Save"]);
      assert.deepEqual(await afterEach(editor, ["End", "ArrowRight", "ArrowLeft", "Home"]), ["Help", "Open", "Help", "Open"]);
      // What is disabled is passed over.
      await focus(editor, "Share");
      assert.deepEqual(await afterEach(editor, ["ArrowRight", "ArrowRight", "Tab"]), ["History", "Show lines", "Scribble"]);
      await editor.tab.hold("Shift", () => editor.tab.press("Tab"));
      assert.equal(await focused(editor), "Show lines");
      await editor.tab.press(" ");
      assert.equal(await editor.tab.evaluate(`document.querySelector('[data-setting="lines"]').checked`), false);
      assert.deepEqual(editor.tab.faults, []);
    });

    test("a stop that is disabled, or hidden in a narrower window, leaves the bar within reach", async () => {
      const editor = await session.open("cpu");
      await editor.openSample("Goldfish");
      await editor.scribble([[175, 192], [245, 187]], 400);
      await focus(editor, "Undo");
      await editor.until("Undone", () => editor.tab.press("Enter"));
      const stop = () => editor.tab.evaluate(`
        [...document.querySelectorAll("#bar :is(button, input)")].filter((c) => c.checkVisibility() && !c.disabled && c.tabIndex === 0).length`);
      await editor.tab.waitFor(`document.querySelector('[data-action="redo"]').disabled === false`);
      assert.equal(await stop(), 1);
      await focus(editor, "Open");
      await editor.tab.resize(360, 640);
      assert.equal(await stop(), 1);
    });

    test("on a phone the menu is a stop of its own while it is open", async () => {
      const editor = await session.open("cpu");
      await editor.tab.resize(360, 640);
      await focus(editor, "File");
      await editor.tab.press("Enter");
      assert.deepEqual(await afterEach(editor, ["Tab", "ArrowDown", "End", "ArrowDown"]), ["Open", "Save", "Share", "Open"]);
      await editor.tab.press("Escape");
      assert.equal(await focused(editor), "File");
      await focus(editor, "View");
      await editor.tab.press("Enter");
      assert.deepEqual(await afterEach(editor, ["Tab", "End", "ArrowLeft"]), ["Show lines", "Mirror", "Rotate right"]);
    });

    test("the tools are one stop, with Home and End too", async () => {
      const editor = await session.open("cpu");
      await focus(editor, "Scribble");
      assert.deepEqual(await afterEach(editor, ["End", "Home", "ArrowDown"]), ["Hand", "Scribble", "Erase"]);
      assert.equal(await editor.tab.evaluate(`document.querySelector('input[name="tool"]:checked').value`), "erase");
    });

    test("F and the button give the page the whole screen, and take it back", async () => {
      const editor = await session.open("cpu");
      const isFull = () => editor.tab.evaluate(`[document.fullscreenElement !== null, document.querySelector('[data-action="full-screen"]').ariaPressed]`);
      assert.deepEqual(await isFull(), [false, "false"]);
      await editor.until("Full screen", () => editor.click("Full screen"));
      assert.deepEqual(await isFull(), [true, "true"]);
      await editor.until("No longer", () => editor.tab.press("f"));
      assert.deepEqual(await isFull(), [false, "false"]);
      assert.deepEqual(editor.tab.faults, []);
    });
  });
}
