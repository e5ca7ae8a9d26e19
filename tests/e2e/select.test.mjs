// Selecting scribbles and lines, and what is done with them: with the mouse, a finger, and from the keyboard alone; and the
// eraser that takes parts.
import assert from "node:assert/strict";
import { describe, test } from "node:test";
import { useSession } from "./harness.mjs";
import { hex, PAPER } from "./picture.mjs";

/** @typedef {[number, number]} Point */
/** @typedef {import("./harness.mjs").Editor} Editor */

/** The longer side of the viewBox of the drawings here. */
const SIDE = 200;
const IN_LEFT_ROOM = /** @type {Point[]} */ ([[30, 30], [50, 60], [70, 40]]);
const IN_PILLAR = /** @type {Point[]} */ ([[140, 50], [150, 50]]);
const LEFT_ROOM = /** @type {Point} */ ([20, 80]);
const PILLAR = /** @type {Point} */ ([145, 65]);
const RIGHT_ROOM = /** @type {Point} */ ([180, 80]);
/** Of the wall between the rooms. */
const WALL = /** @type {Point} */ ([100, 70]);

const RED = "#e5484d";
const BLUE = "#3b82f6";
const GREEN = "#46a758";
const WHITE = hex(PAPER);

/** Windows in which the bar must fit, in CSS pixels. */
const WIDTHS = [320, 360, 800, 1280, 1600];

for (const browser of /** @type {const} */ (["chromium", "firefox"])) {
  describe(`selecting in ${browser}`, () => {
    const session = useSession(browser);

    /** A red room, a blue pillar, and the tool that selects. */
    const open = async () => {
      const editor = await session.open("cpu");
      await editor.openDrawing("rooms");
      await editor.click("Red");
      await editor.scribble(IN_LEFT_ROOM, SIDE);
      await editor.click("Blue");
      await editor.scribble(IN_PILLAR, SIDE);
      await editor.tab.click("radio", "Select");
      return editor;
    };

    /** @param {Editor} editor @param {Point[]} points in units of the viewBox @param {string} words */
    const drag = async (editor, points, words) => {
      const way = await editor.place(points, SIDE);
      await editor.until(words, () => editor.drag(way));
    };

    /** @param {Editor} editor @param {Point[]} points */
    const colorsAt = async (editor, points) => {
      const [places, picture] = [await editor.place(points, SIDE), await editor.picture()];
      return places.map(([x, y]) => hex(picture.at(x, y)));
    };

    /** @param {Editor} editor @returns {Promise<string[]>} the buttons of the bar, if it is there */
    const bar = (editor) =>
      editor.tab.evaluate(`[...document.querySelectorAll("#selected button")].filter((b) => b.checkVisibility()).map((b) => b.ariaLabel)`);

    /** @param {Editor} editor @returns {Promise<Point[] | null>} two corners of the frame on the canvas */
    const frame = (editor) =>
      editor.tab.evaluate(`{
        const [box, canvas] = ["frame", "canvas"].map((id) => document.getElementById(id).getBoundingClientRect());
        box.width ? [[box.left - canvas.left, box.top - canvas.top], [box.right - canvas.left, box.bottom - canvas.top]] : null;
      }`);

    test("a click selects, a drag moves and recolours as it goes, one Undo takes it back", async () => {
      const editor = await open();
      assert.deepEqual(await bar(editor), []);
      const before = await editor.picture();
      await drag(editor, [[50, 60]], "Scribble 1 of 2 selected");
      assert.deepEqual(await bar(editor), ["Send backward", "Bring forward", "Duplicate", "Delete", "Select more", "Deselect"]);
      const way = await editor.place([[50, 60], [90, 62], [150, 62]], SIDE);
      const { x, y } = await editor.box();
      await editor.tab.mouse.move(x + way[0][0], y + way[0][1]);
      await editor.tab.mouse.down();
      for (const [px, py] of way.slice(1)) await editor.tab.mouse.move(x + px, y + py);
      assert.equal((await colorsAt(editor, [LEFT_ROOM]))[0], WHITE, "it has left before it is let go");
      await editor.until("1 scribble moved", () => editor.tab.mouse.up());
      await editor.until("Undone", () => editor.click("Undo"));
      await editor.until("Nothing selected", () => editor.tab.press("Escape"));
      assert.ok((await editor.picture()).equals(before));
      assert.deepEqual(editor.tab.faults, []);
    });

    test("Shift adds, a rectangle selects, a press beside deselects", async () => {
      const editor = await open();
      await drag(editor, [[50, 60]], "Scribble 1 of 2 selected");
      await editor.tab.hold("Shift", () => drag(editor, [[145, 50]], "2 scribbles selected"));
      await editor.tab.hold("Shift", () => drag(editor, [[50, 60]], "Scribble 2 of 2 selected"));
      await drag(editor, [[3, 3]], "Nothing selected");
      assert.equal(await frame(editor), null);
      await drag(editor, [[3, 3], [40, 50], [80, 90]], "Scribble 1 of 2 selected");
      await drag(editor, [[3, 3]], "Nothing selected");
      await drag(editor, [[3, 3], [40, 50], [190, 95]], "2 scribbles selected");
    });

    test("a corner of the frame resizes, with its cursor", async () => {
      const editor = await open();
      await drag(editor, [[50, 60]], "selected");
      const [from, to] = /** @type {Point[]} */ (await frame(editor));
      const { x, y } = await editor.box();
      await editor.tab.mouse.move(x + to[0], y + to[1]);
      const cursor = await editor.tab.evaluate(`getComputedStyle(document.elementFromPoint(${x + to[0]}, ${y + to[1]})).cursor`);
      assert.equal(cursor, "nwse-resize");
      const size = [to[0] - from[0], to[1] - from[1]];
      const half = /** @type {Point} */ ([to[0] - size[0] / 2, to[1] - size[1] / 2]);
      await editor.until("1 scribble resized", () => editor.drag([to, half]));
      const [still, corner] = /** @type {Point[]} */ (await frame(editor));
      assert.ok(Math.hypot(still[0] - from[0], still[1] - from[1]) < 1.5, `${still} is not ${from}`);
      assert.ok(Math.hypot(corner[0] - half[0], corner[1] - half[1]) < 3, `${corner} is not ${half}`);
    });

    test("a colour that is picked is for what is selected", async () => {
      const editor = await open();
      await drag(editor, [[50, 60]], "selected");
      assert.equal(await editor.tab.evaluate(`document.getElementById("color").dataset.color`), RED);
      await editor.until("1 scribble recoloured", () => editor.click("Green"));
      assert.deepEqual(await colorsAt(editor, [LEFT_ROOM, PILLAR]), [GREEN, BLUE]);
      await editor.until("Undone", () => editor.click("Undo"));
      assert.deepEqual(await colorsAt(editor, [LEFT_ROOM, PILLAR]), [RED, BLUE]);
    });

    test("the bar duplicates, orders and deletes", async () => {
      const editor = await open();
      await drag(editor, [[50, 60]], "selected");
      await editor.until("brought forward", () => editor.click("Bring forward"));
      await editor.until("Nothing lies in front", () => editor.click("Bring forward"));
      await editor.until("sent backward", () => editor.click("Send backward"));
      await editor.until("1 scribble duplicated", () => editor.click("Duplicate"));
      await editor.until("Scribble erased, 2 in the drawing", () => editor.click("Delete"));
      assert.deepEqual(await bar(editor), []);
      await editor.tab.hold("Control", () => editor.until("2 scribbles selected", () => editor.tab.press("a")));
      await editor.until("2 scribbles erased, 0 in the drawing", () => editor.click("Delete"));
      assert.deepEqual(await colorsAt(editor, [LEFT_ROOM, PILLAR]), [WHITE, WHITE]);
    });

    test("a line is hidden and parts colours still; deleted, it does not", async () => {
      const editor = await open();
      await editor.click("Red");
      await editor.scribble([[120, 30], [130, 30]], SIDE);
      await editor.tab.press("v");
      await drag(editor, [WALL], "1 line selected");
      assert.deepEqual(await bar(editor), ["Hide", "Delete", "Select more", "Deselect"]);
      await editor.until("1 line hidden", () => editor.click("Hide"));
      await editor.until("1 line shown again", () => editor.click("Show again"));
      await editor.until("1 line hidden", () => editor.click("Hide"));
      await editor.until("Nothing selected", () => editor.tab.press("Escape"));
      assert.deepEqual(await colorsAt(editor, [WALL, LEFT_ROOM, RIGHT_ROOM]), [RED, RED, RED]);
      await editor.kept();
      const again = await session.reopen(editor.tab);
      assert.equal((await colorsAt(again, [WALL]))[0], RED, "it is kept hidden");
      await again.tab.press("v");
      await drag(again, [WALL], "1 line selected");
      await again.until("1 line deleted", () => again.tab.press("Delete"));
      await again.until("Undone", () => again.click("Undo"));
      assert.deepEqual(again.tab.faults, []);
    });

    test("everything is done from the keyboard alone", async () => {
      const editor = await open();
      const { tab } = editor;
      await tab.press("b");
      await tab.evaluate(`document.getElementById("canvas").focus()`);
      await editor.until("Scribble 2 of 2 selected", () => tab.press("n"));
      assert.equal(await tab.evaluate(`document.querySelector('input[name="tool"]:checked').value`), "select");
      await editor.until("Scribble 1 of 2 selected", () => tab.press("n"));
      const [before] = /** @type {Point[]} */ (await frame(editor));
      await tab.hold("ArrowRight", () => tab.hold("Shift", () => editor.until("moved", () => tab.press("ArrowDown"))));
      const [after] = /** @type {Point[]} */ (await frame(editor));
      const [[ax, ay], [bx, by]] = await editor.place([[0, 0], [SIDE / 1024, (10 * SIDE) / 1024]], SIDE);
      assert.ok(Math.hypot(after[0] - before[0] - (bx - ax), after[1] - before[1] - (by - ay)) < 0.1, `${after}`);
      await editor.until("Undone", () => tab.hold("Control", () => tab.press("z")));
      assert.deepEqual((await frame(editor))?.[0].map(Math.round), before.map(Math.round));
      await tab.hold("Control", () => editor.until("duplicated", () => tab.press("d")));
      await tab.hold("Control", () => editor.until("sent backward", () => tab.press("[")));
      await tab.hold("Control", () => editor.until("brought forward", () => tab.press("]")));
      await editor.until("Scribble erased, 2 in the drawing", () => tab.press("Backspace"));
      await editor.until("Scribble 2 of 2 selected", () => tab.press("n"));
      // From the canvas, Tab goes to the bar; when that has gone, the focus is on the canvas.
      await tab.press("Tab");
      assert.equal(await tab.evaluate("document.activeElement.ariaLabel"), "Send backward");
      for (let i = 0; i < 3; i++) await tab.press("Tab");
      await editor.until("Scribble erased, 1 in the drawing", () => tab.press("Enter"));
      assert.equal(await tab.evaluate("document.activeElement.id"), "canvas");
      await tab.hold("Shift", () => editor.until("1 line selected", () => tab.press("N")));
      assert.deepEqual(tab.faults, []);
    });

    test("a finger selects, moves and draws a rectangle", async () => {
      const editor = await open();
      const { x, y } = await editor.box();
      /** @param {Point[]} points @param {string} words */
      const swipe = async (points, words) => {
        const way = (await editor.place(points, SIDE)).map(([px, py]) => /** @type {Point} */ ([x + px, y + py]));
        await editor.until(words, () => editor.tab.swipe(way));
      };
      // Beside it, but no further than a finger is broad.
      await swipe([[50, 63]], "Scribble 1 of 2 selected");
      await swipe([[40, 45], [80, 62], [140, 47]], "1 scribble moved");
      assert.equal((await colorsAt(editor, [LEFT_ROOM]))[0], WHITE);
      await swipe([[3, 3]], "Nothing selected");
      await swipe([[3, 3], [100, 50], [190, 95]], "2 scribbles selected");
      const moved = /** @type {Point} */ ([170, 44]);
      await swipe([[3, 3]], "Nothing selected");
      await swipe([moved], "Scribble 1 of 2 selected");
      await editor.click("Select more");
      await swipe(IN_PILLAR.slice(0, 1), "2 scribbles selected");
      await swipe([moved], "Scribble 2 of 2 selected");
      await editor.click("Select more");
      await swipe([moved], "Scribble 1 of 2 selected");
    });

    test("the bar fits, and the canvas keeps its place", async () => {
      const editor = await open();
      for (const width of WIDTHS) {
        await editor.tab.resize(width, 640);
        const { width: before, height } = await editor.box();
        await editor.tab.hold("Control", () => editor.until("selected", () => editor.tab.press("a")));
        const after = await editor.box();
        assert.deepEqual([after.width, after.height], [before, height], `${width}`);
        const { left, right, least } = await editor.tab.evaluate(`{
          const { left, right } = document.getElementById("selected").getBoundingClientRect();
          const sides = [...document.querySelectorAll("#selected button")].filter((b) => b.checkVisibility())
            .flatMap((b) => [b.offsetWidth, b.offsetHeight]);
          ({ left, right, least: Math.min(...sides) });
        }`);
        assert.ok(left >= after.x && right <= after.x + after.width && least >= 24, `${width}: ${left} ${right} ${least}`);
        await editor.until("Nothing selected", () => editor.tab.press("Escape"));
      }
    });

    test("the eraser takes parts, live, in one step, and whole scribbles again", async () => {
      const editor = await open();
      const { tab } = editor;
      await tab.press("e");
      await tab.click("radio", "Parts");
      await drag(editor, [[40, 30], [40, 60]], "Part of a scribble erased, 3 in the drawing");
      await editor.until("Undone", () => editor.click("Undo"));
      await tab.press("v");
      await drag(editor, [[50, 60]], "Scribble 1 of 2 selected");
      await tab.hold("Shift", () => editor.until("The eraser takes whole scribbles", () => tab.press("E")));
      assert.deepEqual(await bar(editor), []);
      await drag(editor, [[40, 30], [40, 60]], "Scribble erased, 1 in the drawing");
      assert.deepEqual(tab.faults, []);
    });
  });
}
