// Fingers on the canvas: taps of several, and what they do once there is a pen.
import assert from "node:assert/strict";
import { describe, test } from "node:test";
import { useSession } from "./harness.mjs";

/** @typedef {[number, number]} Point */
/** @typedef {import("./harness.mjs").Editor} Editor */

/** The longer side of the viewBox of the drawing here. */
const SIDE = 200;
const IN_LEFT_ROOM = /** @type {Point[]} */ ([[30, 30], [50, 60], [70, 40]]);
const IN_RIGHT_ROOM = /** @type {Point[]} */ ([[170, 30], [180, 60], [170, 80]]);

/**
 * Places of the drawing in the window.
 * @param {Editor} editor
 * @param {Point[]} points
 */
async function placed(editor, points) {
  const [{ x, y }, places] = [await editor.box(), await editor.place(points, SIDE)];
  return places.map(([px, py]) => /** @type {Point} */ ([x + px, y + py]));
}

/** @param {Editor} editor @returns {Promise<string>} how the page lies on the canvas */
const view = (editor) => editor.tab.evaluate(`document.getElementById("canvas").dataset.view`);

for (const browser of /** @type {const} */ (["chromium", "firefox"])) {
  describe(`fingers in ${browser}`, () => {
    const session = useSession(browser);

    test("a tap of two undoes, one of three redoes, and neither draws or moves anything", async () => {
      const editor = await session.open("cpu");
      await editor.openDrawing("rooms");
      await editor.scribble(IN_LEFT_ROOM, SIDE);
      await editor.scribble(IN_RIGHT_ROOM, SIDE);
      const [colored, before] = [await editor.picture(), await view(editor)];
      const fingers = await placed(editor, [[60, 30], [80, 30], [100, 45]]);
      const trembling = fingers.slice(0, 2).map(([x, y]) => /** @type {Point} */ ([x + 3, y - 2]));
      await editor.until("Undone", () => editor.tab.pinch([fingers.slice(0, 2), trembling]));
      assert.ok(!(await editor.picture()).equals(colored));
      await editor.until("Redone", () => editor.tab.pinch([fingers]));
      assert.ok((await editor.picture()).equals(colored));
      assert.equal(await view(editor), before);
      assert.deepEqual(editor.tab.faults, []);
    });

    test("what the first of several fingers began is taken back without a word", async () => {
      const editor = await session.open("cpu");
      await editor.openDrawing("rooms");
      await editor.scribble(IN_LEFT_ROOM, SIDE);
      await editor.tab.evaluate(`{
        const status = document.getElementById("status");
        window.said = [];
        new MutationObserver(() => window.said.push(status.textContent)).observe(status, { childList: true });
      }`);
      const [before, [a, b]] = [await view(editor), await placed(editor, [[60, 30], [80, 30]])];
      await editor.tab.pinch([[a, b], [[a[0] - 40, a[1]], [b[0] + 40, b[1]]]]);
      await editor.tab.waitFor(`document.getElementById("canvas").dataset.view !== ${JSON.stringify(before)}`);
      await editor.tab.pinch([[a, b]]);
      await editor.tab.waitFor(`window.said.includes("Undone")`);
      assert.deepEqual(await editor.tab.evaluate("window.said"), ["Undone"]);
      assert.deepEqual(editor.tab.faults, []);
    });

    test("two fingers that go further, or a single one, are no tap", async () => {
      const editor = await session.open("cpu");
      await editor.openDrawing("rooms");
      await editor.scribble(IN_LEFT_ROOM, SIDE);
      const [before, [a, b]] = [await view(editor), await placed(editor, [[60, 30], [80, 30]])];
      const apart = /** @type {Point[]} */ ([[a[0] - 40, a[1]], [b[0] + 40, b[1]]]);
      await editor.tab.pinch([[a, b], apart]);
      await editor.tab.waitFor(`document.getElementById("canvas").dataset.view !== ${JSON.stringify(before)}`);
      await editor.until("Scribble added, 2", () => editor.tab.swipe([a, b]));
      assert.deepEqual(editor.tab.faults, []);
    });
  });
}

describe("fingers beside a pen", () => {
  const session = useSession("chromium");

  /** @param {Editor} editor @param {Point[]} points */
  const write = async (editor, points) => {
    const [first, ...rest] = await placed(editor, points);
    await editor.tab.pen("down", first);
    for (const place of rest) await editor.tab.pen("move", place);
    await editor.tab.pen("up", /** @type {Point} */ (rest.at(-1)));
  };

  test("once a pen has drawn, fingers move the picture, until they are to draw again", async () => {
    const editor = await session.open("cpu");
    await editor.openDrawing("rooms");
    assert.equal(await editor.tab.evaluate(`document.querySelector('[data-action="fingers"]').checkVisibility()`), false);
    await editor.until("Scribble added, 1", () => write(editor, IN_LEFT_ROOM));
    const before = await view(editor);
    await editor.tab.swipe(await placed(editor, [[170, 30], [180, 60]]));
    await editor.tab.waitFor(`document.getElementById("canvas").dataset.view !== ${JSON.stringify(before)}`);
    await editor.until("Fingers draw too", () => editor.click("Fingers draw"));
    await editor.until("Scribble added, 2", async () => editor.tab.swipe(await placed(editor, IN_RIGHT_ROOM)));
    await editor.until("Only the pen draws", () => editor.click("Fingers draw"));
    assert.deepEqual(editor.tab.faults, []);
  });

  test("a hand that comes down before the pen, or while it draws, does nothing", async () => {
    const editor = await session.open("cpu");
    await editor.openDrawing("rooms");
    const [palm] = await placed(editor, [[170, 80]]);
    const before = await view(editor);
    // At first nobody knows that there is a pen.
    await editor.tab.palm(palm);
    await editor.until("Scribble added, 1", () => write(editor, IN_LEFT_ROOM));
    await editor.tab.palm();
    const [first, ...rest] = await placed(editor, IN_RIGHT_ROOM);
    await editor.tab.pen("down", first);
    await editor.tab.pinch([[palm], [[palm[0] + 30, palm[1]]]]);
    for (const place of rest) await editor.tab.pen("move", place);
    await editor.until("Scribble added, 2", () => editor.tab.pen("up", /** @type {Point} */ (rest.at(-1))));
    assert.equal(await view(editor), before);
    assert.deepEqual(editor.tab.faults, []);
  });
});
