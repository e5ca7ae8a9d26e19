// The guide of the first visit: three steps that go on as they are done, in nobody's way, and never twice.
import assert from "node:assert/strict";
import { describe, test } from "node:test";
import { Editor, useSession } from "./harness.mjs";

/** The longer side of the goldfish's viewBox, and ways in it. */
const GOLDFISH = 400;
const IN_BODY = /** @type {[number, number][]} */ ([[175, 192], [245, 187]]);
const IN_WATER = /** @type {[number, number][]} */ ([[20, 15], [200, 12], [380, 20]]);

/** @param {Editor} editor @returns {Promise<number>} which step is shown, from 1; 0 where there is none */
const step = (editor) =>
  editor.tab.evaluate(`document.getElementById("steps").checkVisibility()
    ? [...document.querySelectorAll("#steps li")].findIndex((item) => item.ariaCurrent === "step") + 1 : 0`);

/** @param {Editor} editor @returns {Promise<string>} what those hear who do not see it */
const heard = (editor) => editor.tab.evaluate(`document.querySelector("#steps [role=status]").textContent`);

for (const browser of /** @type {const} */ (["chromium", "firefox"])) {
  describe(`the first visit in ${browser}`, () => {
    const session = useSession(browser);

    const visit = async (more = "") => Editor.open(await session.newTab({ isFirst: true }), `${session.url}?renderer=cpu${more}`, "cpu");

    test("each step goes on when it is done, and the last one ends it", async () => {
      const editor = await visit();
      assert.equal(await step(editor), 1);
      assert.equal(await heard(editor), "Step 1 of 3: Pick a colour");
      await editor.click("Blue");
      assert.equal(await step(editor), 2);
      await editor.scribble(IN_BODY, GOLDFISH);
      assert.equal(await step(editor), 3);
      assert.match(await heard(editor), /Step 3 of 3: .*Undo/);
      await editor.until("That is how to colour", () => editor.click("Undo"));
      assert.equal(await step(editor), 0);
      await editor.scribble(IN_BODY, GOLDFISH);
      assert.deepEqual(editor.tab.faults, []);
    });

    test("who just scribbles has done the steps before", async () => {
      const editor = await visit();
      await editor.scribble(IN_BODY, GOLDFISH);
      assert.equal(await step(editor), 3);
      const inBody = async () => {
        await editor.screenshot();
        const [[[x, y]], box] = [await editor.place([[210, 190]], GOLDFISH), await editor.box()];
        return [box.x + x, box.y + y].map(Math.round);
      };
      const before = await inBody();
      await editor.until("That is how to colour", async () => editor.drag(await editor.place(IN_WATER, GOLDFISH)));
      assert.equal(await step(editor), 0);
      const now = await inBody();
      assert.ok(Math.hypot(now[0] - before[0], now[1] - before[1]) <= 1, `the drawing went from ${before} to ${now} as the guide did`);
    });

    test("it covers nothing of the canvas, and does not come again", async () => {
      const editor = await visit();
      for (const [width, height] of /** @type {const} */ ([[1200, 800], [360, 640], [320, 568], [640, 360]])) {
        await editor.tab.resize(width, height);
        const [steps, canvas, text] = /** @type {DOMRect[]} */ (await editor.tab.evaluate(`
          ["#steps", "#canvas", "#steps li[aria-current]"].map((part) => document.querySelector(part).getBoundingClientRect().toJSON())`));
        assert.ok(steps.bottom <= canvas.top, `${width} by ${height}`);
        assert.ok(canvas.height >= 0.5 * height, `${width} by ${height}: the canvas is ${canvas.height} high`);
        assert.ok(text.width > 0 && text.right <= width, `${width} by ${height}`);
        assert.equal(await editor.tab.evaluate("document.documentElement.scrollWidth"), width);
      }
      const again = await Editor.open(editor.tab, `${session.url}?renderer=cpu`, "cpu");
      assert.equal(await step(again), 0);
    });

    test("Escape and Skip put it away, Help shows it again, all from the keyboard", async () => {
      const editor = await visit();
      await editor.tab.press("Escape");
      assert.equal(await step(editor), 0);
      await editor.tab.press("?");
      await editor.tab.waitFor(`document.getElementById("help")?.open`);
      await editor.tab.evaluate(`document.querySelector('[data-action="first-steps"]').focus()`);
      await editor.tab.press("Enter");
      await editor.tab.waitFor(`!document.getElementById("help").open`);
      assert.equal(await step(editor), 1);
      await editor.tab.evaluate(`document.querySelector("#canvas").focus()`);
      await editor.tab.hold("Shift", () => editor.tab.press("Tab"));
      assert.equal(await editor.tab.evaluate("document.activeElement.textContent"), "Skip");
      await editor.tab.press("Enter");
      assert.equal(await step(editor), 0);
      assert.equal(await editor.tab.evaluate("document.activeElement.id"), "canvas");
    });

    test("those who come by a link are not shown it", async () => {
      const editor = await visit();
      await editor.click("Share");
      await editor.tab.waitFor(`document.getElementById("share")?.open`);
      const link = String(await editor.tab.evaluate(`document.getElementById("link").value`));
      const linked = await visit(link.slice(link.indexOf("#")));
      assert.equal(await linked.name(), "Shared drawing");
      assert.equal(await step(linked), 0);
    });
  });
}
