// The history: what was done to the drawing as a list, in which one goes back and forth.
import assert from "node:assert/strict";
import { describe, test } from "node:test";
import { useSession } from "./harness.mjs";
import { hex, PAPER } from "./picture.mjs";

/** @typedef {[number, number]} Point */
/** @typedef {import("./harness.mjs").Editor} Editor */

/** The longer side of the viewBox of `drawings/rooms.svg`. */
const SIDE = 200;
const IN_LEFT_ROOM = /** @type {Point[]} */ ([[30, 30], [50, 60], [70, 40]]);
const IN_PILLAR = /** @type {Point[]} */ ([[140, 50], [150, 50]]);
const LEFT_ROOM = /** @type {Point} */ ([20, 80]);

const RED = "#e5484d";
const WHITE = hex(PAPER);

for (const browser of /** @type {const} */ (["chromium", "firefox"])) {
  describe(`the history in ${browser}`, () => {
    const session = useSession(browser);

    /** A red room; a pillar that became blue. */
    const open = async () => {
      const editor = await session.open("cpu");
      await editor.openDrawing("rooms");
      await editor.click("Red");
      await editor.scribble(IN_LEFT_ROOM, SIDE);
      await editor.scribble(IN_PILLAR, SIDE);
      await editor.until("selected", () => editor.tab.press("n"));
      await editor.until("recoloured", () => editor.click("Blue"));
      return editor;
    };

    /** @param {Editor} editor */
    const show = async (editor) => {
      await editor.tab.hold("Shift", () => editor.tab.press("h"));
      await editor.tab.waitFor(`document.activeElement.closest("#history-panel") !== null`);
    };

    /** @param {Editor} editor @returns {Promise<string[]>} the names of the steps, with a star where the drawing is */
    const steps = (editor) =>
      editor.tab.evaluate(`[...document.querySelectorAll("#history-panel [role=option]")].map((step) => (step.ariaSelected === "true" ? "* " : "") + step.ariaLabel)`);

    /** @param {Editor} editor */
    const color = async (editor) => {
      const [[x, y]] = await editor.place([LEFT_ROOM], SIDE);
      return hex((await editor.picture()).at(x, y));
    };

    test("it names each step, and Enter goes to one", async () => {
      const editor = await open();
      await editor.until("selected", () => editor.tab.hold("Control", () => editor.tab.press("a")));
      await show(editor);
      assert.deepEqual(await steps(editor), ["As opened", "Scribble added, Red", "Scribble added, Red", "* Recoloured, Blue"]);
      await editor.tab.press("Home");
      await editor.until("At: As opened", () => editor.tab.press("Enter"));
      assert.deepEqual(await steps(editor), ["* As opened", "Scribble added, Red, undone", "Scribble added, Red, undone", "Recoloured, Blue, undone"]);
      await editor.tab.press("ArrowDown");
      await editor.until("At: Scribble added", () => editor.tab.press(" "));
      await editor.until("Redone", () => editor.tab.hold("Control", () => editor.tab.press("y")));
      assert.deepEqual(await steps(editor), ["As opened", "Scribble added, Red", "* Scribble added, Red", "Recoloured, Blue, undone"]);
      await editor.tab.press("Escape");
      assert.equal(await editor.tab.evaluate("document.activeElement.id"), "canvas");
      assert.equal(await color(editor), RED);
      assert.deepEqual(editor.tab.faults, []);
    });

    test("arrow keys that are pressed one after the other are one step, until something else is done or nothing is", async () => {
      const editor = await open();
      await show(editor);
      // At once, so that no pause of the machine parts them.
      const pressed = (/** @type {string[]} */ keys) => `
        for (const key of ${JSON.stringify(keys)}) {
          for (const kind of ["keydown", "keyup"]) document.body.dispatchEvent(new KeyboardEvent(kind, { key, bubbles: true }));
        }`;
      const nudge = (/** @type {string[]} */ keys) => editor.until("moved", () => editor.tab.evaluate(pressed(keys)));
      const count = (/** @type {number} */ steps) => editor.tab.waitFor(`document.querySelectorAll("#history-panel [role=option]").length === ${steps}`);
      await nudge(["ArrowRight", "ArrowRight", "ArrowDown"]);
      await editor.until("selected", () => editor.tab.press("n"));
      assert.deepEqual((await steps(editor)).slice(3), ["Recoloured, Blue", "* Moved"]);
      await nudge(["ArrowLeft", "ArrowLeft"]);
      await count(6);
      await nudge(["ArrowUp", "ArrowUp"]);
      await count(7);
      assert.deepEqual((await steps(editor)).slice(3), ["Recoloured, Blue", "Moved", "Moved", "* Moved"]);
      // Those who speak their commands click without a pointer.
      const undo = `document.querySelector("[data-action=undo]").click()`;
      await editor.until("Undone", () => editor.tab.evaluate(pressed(["ArrowRight"]) + undo));
      await count(8);
      assert.equal((await steps(editor))[6], "* Moved");
      assert.deepEqual(editor.tab.faults, []);
    });

    test("a click goes to a step, and what is done from there takes the place of the later ones", async () => {
      const editor = await open();
      await editor.tab.click("button", "History");
      await editor.tab.waitFor(`document.querySelectorAll("#history-panel [role=option]").length === 4`);
      await editor.until("At: As opened", () => editor.tab.click("option", "As opened"));
      await editor.tab.press("Escape");
      assert.equal(await color(editor), WHITE);
      await editor.tab.click("radio", "Scribble");
      await editor.scribble(IN_PILLAR, SIDE);
      await show(editor);
      assert.deepEqual(await steps(editor), ["As opened", "* Scribble added, Blue"]);
    });

    test("a thousand steps are a list like any other", async () => {
      const editor = await open();
      await editor.tab.evaluate(`for (let i = 0; i < 1000; i++) document.querySelector('[data-setting="spread"]').click()`);
      await show(editor);
      assert.equal((await steps(editor)).length, 1004);
      await editor.tab.press("Home");
      await editor.tab.press("PageDown");
      await editor.until("At: Spread", () => editor.tab.press("Enter"));
      assert.equal((await steps(editor)).indexOf("* Spread"), 10);
      assert.equal(await editor.tab.evaluate(`document.querySelector('[data-setting="spread"]').checked`), true);
      await editor.tab.press("End");
      await editor.until("At: Spread", () => editor.tab.press("Enter"));
      assert.equal((await steps(editor)).indexOf("* Spread"), 1003);
      assert.deepEqual(editor.tab.faults, []);
    });
  });
}
