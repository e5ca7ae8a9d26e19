// Help: what it lists is what there is, as each shortcut does something; those of a single key can be turned off.
import assert from "node:assert/strict";
import { describe, test } from "node:test";
import { Editor, useSession } from "./harness.mjs";

/** @typedef {[number, number]} Point */

/** The longer side of the viewBox of `drawings/rooms.svg`, a way in its left room, and one on bare paper. */
const ROOMS = 200;
const IN_LEFT_ROOM = /** @type {Point[]} */ ([[30, 30], [50, 60], [70, 40]]);
const ON_PAPER = /** @type {Point[]} */ ([[150, 70], [160, 80]]);

/** What the user sees of the page's state, and the files that it asked for or gave. */
const SEEN = `JSON.stringify({
  said: document.getElementById("status").textContent,
  view: document.getElementById("canvas").dataset.view,
  chosen: [...document.querySelectorAll(":is(body > header, aside, #settings) :checked")].map((control) => control.ariaLabel ?? control.value),
  color: document.getElementById("color").dataset.color,
  brush: document.getElementById("brush-size").value,
  dialogs: [...document.querySelectorAll("dialog[open], :popover-open")].map((dialog) => dialog.id),
  files: window.files,
})`;

const DROP = "Drop the stroke, or deselect";

/** What is done with what is selected. */
const ARRANGINGS = ["Delete", "Duplicate", "Bring forward", "Send backward"];

/** Keys by the signs that Help has for them. @type {Record<string, string>} */
const KEYS = { "←": "ArrowLeft", "→": "ArrowRight", "↑": "ArrowUp", "↓": "ArrowDown", Space: " " };

/**
 * @param {Editor} editor
 * @param {string} chord as Help writes it
 * @param {() => Promise<void>} [during] what is done while it is held
 */
async function press(editor, chord, during) {
  const [, ctrl, shift, key] = /** @type {string[]} */ (/^(Ctrl\+)?(Shift\+)?(.+)$/.exec(chord));
  const name = KEYS[key] ?? key;
  let act = () => (during ? editor.tab.hold(name, during) : editor.tab.press(name));
  for (const modifier of [shift && "Shift", ctrl && "Control"]) {
    const inner = act;
    if (modifier) act = () => editor.tab.hold(modifier, inner);
  }
  await act();
}

/** Whether what is seen becomes another within some time. @param {Editor} editor @param {string} before */
async function changes(editor, before) {
  for (let tries = 0; tries < 200; tries++) {
    if ((await editor.tab.evaluate(SEEN)) !== before) return true;
    await new Promise((wake) => setTimeout(wake, 25));
  }
  return false;
}

for (const browser of /** @type {const} */ (["chromium", "firefox"])) {
  describe(`help in ${browser}`, () => {
    const session = useSession(browser);

    const open = async () => {
      const editor = await session.open("cpu");
      await editor.openDrawing("rooms");
      await editor.scribble(IN_LEFT_ROOM, ROOMS);
      return editor;
    };

    /** @param {Editor} editor @returns {Promise<[string, string[]][]>} actions with their chords, in the page's words */
    const listed = async (editor) => {
      await editor.click("Help");
      await editor.tab.waitFor(`document.getElementById("help")?.open`);
      const rows = await editor.tab.evaluate(`
        [...document.querySelectorAll("#shortcuts dl div")].map((row) =>
          [row.querySelector("dt").textContent, [...row.querySelectorAll("kbd")].map((key) => key.textContent)])`);
      await editor.click("Close");
      return /** @type {[string, string[]][]} */ (rows);
    };

    /**
     * A state that every shortcut changes: another tool, colour and brush than it asks for, a view that is moved,
     * something to undo and to redo.
     * @param {Editor} editor
     * @param {string} action
     */
    const prepare = async (editor, action) => {
      if (["Undo", "Redo"].includes(action)) {
        await editor.tab.click("radio", "Scribble");
        for (let i = 0; i < 2; i++) await editor.scribble(ON_PAPER, ROOMS);
        await editor.until("Undone", () => editor.click("Undo"));
      }
      const tool = action === "Erase" ? "hand" : action === DROP ? "scribble" : "erase";
      await editor.tab.evaluate(`
        for (const selector of ['[data-action="fit"]', '[data-action="zoom-in"]']) document.querySelector(selector).click();
        document.querySelector('#palette [data-color="#f3c9a5"]').click();
        document.getElementById("brush-size").value = "40";
        document.getElementById("brush-size").dispatchEvent(new Event("input"));
        document.querySelector('[value="${tool}"]').click();
        document.getElementById("canvas").focus();
        document.getElementById("status").textContent = "";`);
      if (ARRANGINGS.includes(action)) {
        await editor.tab.click("radio", "Scribble");
        await editor.scribble(ON_PAPER, ROOMS);
        await editor.until("selected", () => editor.tab.press("n"));
      }
    };

    test("each shortcut that it lists does something", async () => {
      const editor = await open();
      await editor.tab.evaluate(`
        window.files = 0;
        for (const { prototype } of [HTMLInputElement, HTMLAnchorElement]) {
          const click = prototype.click;
          prototype.click = function () { this.type === "file" || this.download ? window.files++ : click.call(this) };
        }`);
      const rows = await listed(editor);
      assert.ok(rows.length >= 25, `${rows.length} rows`);
      for (const [action, chords] of rows) {
        assert.ok(chords.length > 0, action);
        for (const chord of chords) {
          await prepare(editor, action);
          const way = await editor.place(ON_PAPER, ROOMS);
          const { x, y } = await editor.box();
          if (action === DROP) {
            await editor.tab.mouse.move(x + way[0][0], y + way[0][1]);
            await editor.tab.mouse.down();
          }
          const before = /** @type {string} */ (await editor.tab.evaluate(SEEN));
          let isSeen = false;
          const whileHeld = async () => {
            await editor.drag(way);
            isSeen = await changes(editor, before);
          };
          await press(editor, chord, action.includes("while held") ? whileHeld : undefined);
          assert.ok(isSeen || (await changes(editor, before)), `${chord} (${action}) does nothing`);
          await editor.tab.mouse.up();
          if (await editor.tab.evaluate(`document.querySelector("dialog[open], :popover-open") !== null`)) await editor.tab.press("Escape");
        }
      }
      assert.deepEqual(editor.tab.faults, []);
    });

    test("shortcuts of a single key can be turned off, and stay off", async () => {
      const editor = await open();
      const tool = () => editor.tab.evaluate(`document.querySelector('input[name="tool"]:checked').value`);
      const tooltip = () => editor.tab.evaluate(`document.querySelector('[value="erase"]').title`);
      const swatch = () => editor.tab.evaluate(`document.querySelector("#palette button").title`);
      assert.deepEqual([await tooltip(), await swatch()], ["Erase (E)", "Red (1)"]);
      await editor.tab.press("?");
      await editor.tab.waitFor(`document.getElementById("help")?.open`);
      await editor.tab.click("checkbox", "Shortcuts of a single key");
      await editor.click("Close");
      /** @param {Editor} page */
      const areOff = async (page) => {
        for (const key of ["e", "s", "3", "[", "?"]) await page.tab.press(key);
        await page.tab.hold("Shift", () => page.tab.press("L"));
        assert.equal(await tool(), "scribble");
        assert.deepEqual([await tooltip(), await swatch()], ["Erase", "Red"]);
        assert.equal(await page.tab.evaluate(`document.querySelector('[data-setting="lines"]').checked`), true);
        assert.equal(await page.tab.evaluate(`document.querySelector("dialog[open]")`), null);
        assert.equal(await page.tab.evaluate(`document.getElementById("guide").textContent`), "Wheel or Space-drag moves, Ctrl+wheel zooms");
      };
      await areOff(editor);
      await editor.until("Undone", () => editor.tab.hold("Control", () => editor.tab.press("z")));
      const again = await Editor.open(editor.tab, `${session.url}?renderer=cpu`, "cpu");
      await areOff(again);
      await again.click("Help");
      await again.tab.waitFor(`document.getElementById("help")?.open`);
      await again.tab.click("checkbox", "Shortcuts of a single key");
      await again.click("Close");
      await again.tab.press("e");
      assert.equal(await tool(), "erase");
      assert.deepEqual([await tooltip(), await swatch()], ["Erase (E)", "Red (1)"]);
      assert.deepEqual(again.tab.faults, []);
    });

    test("it tells how to begin, in three steps, and closes by Escape", async () => {
      const editor = await open();
      await editor.tab.press("?");
      await editor.tab.waitFor(`document.getElementById("help")?.open`);
      const steps = /** @type {string[]} */ (await editor.tab.evaluate(`
        [...document.querySelectorAll("#help .guide li")].filter((step) => step.checkVisibility()).map((step) => step.innerText)`));
      assert.equal(steps.length, 3);
      assert.match(steps[0], /scribble/);
      await editor.tab.press("Escape");
      await editor.tab.waitFor(`!document.getElementById("help").open`);
    });
  });
}
