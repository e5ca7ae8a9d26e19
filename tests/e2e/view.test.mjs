// Moving the view: the drawing stays under the pointer, and nothing is drawn by it.
import assert from "node:assert/strict";
import { before, describe, test } from "node:test";
import { useSession } from "./harness.mjs";

/** @typedef {[number, number]} Point */

/** The longer side of the viewBox of `drawings/rooms.svg`, and two places in it. */
const ROOMS = 200;
const PLACES = /** @type {Point[]} */ ([[50, 50], [150, 50]]);

describe("the view", () => {
  const session = useSession("chromium");
  /** @type {import("./harness.mjs").Editor} */
  let editor;
  before(async () => {
    editor = await session.open("cpu");
    await editor.openDrawing("rooms");
  });

  /**
   * How far two places of the drawing move on the canvas by an act, in CSS pixels.
   * @param {() => Promise<unknown>} act
   */
  const moved = async (act) => {
    const before = await editor.place(PLACES, ROOMS);
    await act();
    await editor.picture();
    const after = await editor.place(PLACES, ROOMS);
    // The sum makes 0 of -0.
    return after.map(([x, y], i) => [Math.round(x - before[i][0]) + 0, Math.round(y - before[i][1]) + 0]);
  };

  /** @param {Point} place */
  const pointAt = async (place) => {
    const { x, y } = await editor.box();
    const [[px, py]] = await editor.place([place], ROOMS);
    await editor.tab.mouse.move(x + px, y + py);
  };

  test("the wheel moves it", async () => {
    await pointAt(PLACES[0]);
    assert.deepEqual(await moved(() => editor.tab.wheel(30, -20)), [[-30, 20], [-30, 20]]);
  });

  test("Space and drag moves it, without a scribble", async () => {
    const drag = () => editor.tab.hold("Space", () => editor.drag([[200, 200], [230, 190], [260, 180]]));
    assert.deepEqual(await moved(drag), [[60, -20], [60, -20]]);
    assert.match(await editor.status(), /Opened/);
  });

  test("Ctrl and wheel zooms about the pointer", async () => {
    await pointAt(PLACES[0]);
    const [fixed, [dx, dy]] = await moved(() => editor.tab.hold("Control", () => editor.tab.wheel(0, -20)));
    // The pointer stands on a whole pixel, up to half of one beside the place.
    assert.ok(fixed.every((pixels) => Math.abs(pixels) <= 1), `${fixed} pixels`);
    assert.ok(dx > 20, `${dx} pixels`);
    assert.ok(Math.abs(dy) <= 1, `${dy} pixels`);
  });

  test("Fit shows the whole page again", async () => {
    await editor.click("Fit");
    await editor.picture();
    const { width, height } = await editor.box();
    const [[left, top], [right, bottom]] = await editor.place([[0, 0], [200, 100]], ROOMS);
    assert.ok(left >= 0 && top >= 0 && right <= width && bottom <= height);
    assert.ok(Math.max((right - left) / width, (bottom - top) / height) > 0.8);
  });
});
