// The page rotated and mirrored on the canvas: everything is done to what is seen, and the drawing stays as it is.
import assert from "node:assert/strict";
import { describe, test } from "node:test";
import { useSession } from "./harness.mjs";
import { hex, PAPER } from "./picture.mjs";

/** @typedef {[number, number]} Point */
/** @typedef {import("./harness.mjs").Editor} Editor */

/** The longer side of the viewBox of `drawings/rooms.svg`, and places in it. */
const SIDE = 200;
const IN_LEFT_ROOM = /** @type {Point[]} */ ([[30, 30], [50, 60], [70, 40]]);
const LEFT_ROOM = /** @type {Point} */ ([20, 80]);
const RIGHT_ROOM = /** @type {Point} */ ([180, 80]);
const CORNERS = /** @type {Point[]} */ ([[0, 0], [200, 0], [200, 100], [0, 100]]);

const RED = "#e5484d";

/** How far a page of the tests may lie beside where it belongs: half a device pixel each way, and what rounding does. */
const NEAR_PX = 0.8;

/** @param {Point} a @param {Point} b */
const distance = ([ax, ay], [bx, by]) => Math.hypot(ax - bx, ay - by);

/** @param {Point[]} places @param {Point[]} others @param {number} [near_px] */
const assertNear = (places, others, near_px = NEAR_PX) =>
  places.forEach((place, i) => assert.ok(distance(place, others[i]) < near_px, `${place} is not ${others[i]}`));

/**
 * Where points come to lie by a rotation about another, clockwise.
 * @param {Point[]} points @param {Point} about @param {number} degrees @returns {Point[]}
 */
const rotated = (points, [x, y], degrees) => {
  const [sin, cos] = [Math.sin((degrees * Math.PI) / 180), Math.cos((degrees * Math.PI) / 180)];
  return points.map(([px, py]) => [x + cos * (px - x) - sin * (py - y), y + sin * (px - x) + cos * (py - y)]);
};

/** @param {Editor} editor */
const degrees = (editor) => editor.tab.evaluate(`parseInt(document.getElementById("rotated").textContent)`);

/** @param {Editor} editor @param {string} key */
const shift = (editor, key) => editor.tab.hold("Shift", () => editor.tab.press(key));

for (const browser of /** @type {const} */ (["chromium", "firefox"])) {
  describe(`rotation in ${browser}`, () => {
    const session = useSession(browser);

    const open = async () => {
      const editor = await session.open("cpu");
      await editor.openDrawing("rooms");
      return editor;
    };

    /** @param {Editor} editor @returns {Promise<Point>} */
    const middle = async (editor) => {
      const { width, height } = await editor.box();
      return [width / 2, height / 2];
    };

    test("keys and buttons rotate and mirror about the middle of the canvas, and back", async () => {
      const editor = await open();
      const [before, about] = [await editor.place(CORNERS, SIDE), await middle(editor)];
      await editor.until("Rotated by 15°", () => shift(editor, "6"));
      assertNear(await editor.place(CORNERS, SIDE), rotated(before, about, 15));
      await editor.until("Rotated by 30°", () => editor.click("Rotate right"));
      assert.equal(await degrees(editor), 30);
      await editor.until("Rotated by -30°, mirrored", () => editor.tab.press("m"));
      const mirrored = rotated(before, about, 30).map(([x, y]) => /** @type {Point} */ ([2 * about[0] - x, y]));
      assertNear(await editor.place(CORNERS, SIDE), mirrored);
      assert.deepEqual(await editor.tab.evaluate(`[document.querySelector('[data-action="mirror"]').ariaPressed, document.getElementById("rotation-button").matches(".on")]`), ["true", true]);
      await editor.until("Rotated by -45°", () => shift(editor, "4"));
      await editor.until("Mirrored", () => editor.click("Rotation -45°"));
      await editor.until("As drawn", () => editor.click("Mirror"));
      assertNear(await editor.place(CORNERS, SIDE), before);
      assert.equal(await editor.tab.evaluate(`document.querySelector('[data-action="undo"]').disabled`), true);
      assert.deepEqual(editor.tab.faults, []);
    });

    test("a drag while R is held rotates, and a page that is aslant fits", async () => {
      const editor = await open();
      const [before, about] = [await editor.place(CORNERS, SIDE), await middle(editor)];
      const [x, y] = about;
      const way = /** @type {Point[]} */ ([[x, y - 100], [x + 70, y - 70], [x + 100, y], [x + 80, y + 60]]);
      await editor.tab.hold("r", () => editor.drag(way));
      const turn = 90 + (Math.atan2(60, 80) * 180) / Math.PI;
      // Firefox has whole pixels alone.
      assert.ok(Math.abs((await degrees(editor)) - turn) < 1.5);
      assertNear(await editor.place(CORNERS, SIDE), rotated(before, about, turn), 5);
      await editor.click("Fit");
      const { width, height } = await editor.box();
      const corners = await editor.place(CORNERS, SIDE);
      assert.ok(corners.every(([px, py]) => px > 0 && py > 0 && px < width && py < height), `${corners}`);
    });

    test("what is drawn, moved, resized and picked is what is seen there", async () => {
      const editor = await open();
      await editor.until("Mirrored", () => editor.tab.press("m"));
      for (const turn of [15, 30, 45]) await editor.until(`Rotated by ${turn}°`, () => shift(editor, "6"));
      await editor.click("Fit");
      await editor.click("Red");
      await editor.scribble(IN_LEFT_ROOM, SIDE);
      const colors = async () => {
        const [picture, places] = [await editor.picture(), await editor.place([LEFT_ROOM, RIGHT_ROOM], SIDE)];
        return places.map(([x, y]) => hex(picture.at(x, y)));
      };
      assert.deepEqual(await colors(), [RED, hex(PAPER)]);

      // The frame lies along the canvas, around the scribble as it is seen.
      await editor.until("selected", () => editor.tab.press("n"));
      const frame = async () => {
        const { x, y } = await editor.box();
        const { left, top, right, bottom } = await editor.tab.evaluate(`document.getElementById("frame").getBoundingClientRect().toJSON()`);
        return [left - x, top - y, right - x, bottom - y];
      };
      const seen = await editor.place(IN_LEFT_ROOM, SIDE);
      const [left, top, right, bottom] = await frame();
      const rims = [Math.min(...seen.map(([x]) => x)) - left, bottom - Math.max(...seen.map(([, y]) => y))];
      assert.ok(rims.every((rim) => Math.abs(rim - rims[0]) < 1 && rim > 4), `${rims}`);

      // Its handles work along the canvas, too.
      const side = /** @type {Point} */ ([right, (top + bottom) / 2]);
      await editor.until("1 scribble resized", () => editor.drag([side, [side[0] + 30, side[1]], [side[0] + 50, side[1] + 9]]));
      assertNear([/** @type {Point} */ ((await frame()).slice(0, 2)), /** @type {Point} */ ((await frame()).slice(2))], [[left, top], [right + 50, bottom]]);

      await editor.until("moved", () => shift(editor, "ArrowLeft"));
      assert.ok((await frame())[0] < left - 5, "an arrow goes as it points");
      await editor.until("Undone", () => editor.click("Undo"));

      await editor.click("Blue");
      await editor.tab.click("radio", "Pick colour");
      const [at] = await editor.place([LEFT_ROOM], SIDE);
      await editor.until("Picked", () => editor.drag([at, at]));
      assert.deepEqual(editor.tab.faults, []);
    });

    test("Ctrl and wheel zooms about the pointer of a page that is aslant, the wheel moves it as it goes", async () => {
      const editor = await open();
      await editor.until("Rotated", () => shift(editor, "6"));
      const { x, y } = await editor.box();
      const [[px, py]] = await editor.place([LEFT_ROOM], SIDE);
      await editor.tab.mouse.move(x + px, y + py);
      const zoom = /** @type {string} */ (await editor.tab.evaluate(`document.getElementById("zoom").textContent`));
      await editor.tab.hold("Control", () => editor.tab.wheel(0, -20));
      await editor.tab.waitFor(`document.getElementById("zoom").textContent !== "${zoom}"`);
      const [at] = await editor.place([LEFT_ROOM], SIDE);
      assert.ok(distance(at, [px, py]) < 1.5, `${at} was ${[px, py]}`);
      const view = await editor.tab.evaluate(`document.getElementById("canvas").dataset.view`);
      await editor.tab.wheel(30, -20);
      await editor.tab.waitFor(`document.getElementById("canvas").dataset.view !== "${view}"`);
      assertNear(await editor.place([LEFT_ROOM], SIDE), [[at[0] - 30, at[1] + 20]]);
    });

    test("two fingers rotate it once they have turned far enough", async () => {
      const editor = await open();
      const { x, y } = await editor.box();
      const [cx, cy] = await middle(editor);
      const fingers = (/** @type {number} */ angle) =>
        /** @type {[Point, Point]} */ (rotated([[x + cx - 80, y + cy], [x + cx + 80, y + cy]], [x + cx, y + cy], angle));
      await editor.tab.pinch([0, 3, 6, 9].map(fingers));
      assert.equal(await degrees(editor), 0);
      await editor.tab.pinch([0, 5, 10, 15, 20, 30, 40, 50].map(fingers));
      const turn = await degrees(editor);
      assert.ok(turn >= 30 && turn <= 40, `${turn} degrees`);
      assert.equal(await editor.tab.evaluate(`document.querySelector('[data-action="undo"]').disabled`), true);
      assert.deepEqual(editor.tab.faults, []);
    });
  });
}
