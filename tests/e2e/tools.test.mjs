// The tools that change nothing of the drawing, picking a colour and moving the view, and the layers that are shown: with
// the pointer, by their keys, and with the cursor that tells them apart.
import assert from "node:assert/strict";
import { describe, test } from "node:test";
import { useSession } from "./harness.mjs";
import { distance, hex, PAPER } from "./picture.mjs";

/** @typedef {[number, number]} Point */
/** @typedef {import("./harness.mjs").Editor} Editor */

/** The longer side of the viewBox of the drawings here. */
const SIDE = 200;
const IN_LEFT_ROOM = /** @type {Point[]} */ ([[30, 30], [50, 60], [70, 40]]);
const LEFT_ROOM = /** @type {Point} */ ([20, 80]);

const RED = "#e5484d";

for (const browser of /** @type {const} */ (["chromium", "firefox"])) {
  describe(`tools in ${browser}`, () => {
    const session = useSession(browser);

    /** A red room, and blue at hand. */
    const open = async () => {
      const editor = await session.open("cpu");
      await editor.openDrawing("rooms");
      await editor.click("Red");
      await editor.scribble(IN_LEFT_ROOM, SIDE);
      await editor.click("Blue");
      return editor;
    };

    /** @param {Editor} editor @returns {Promise<{tool: string, color: string, cursor: string, shown: string[]}>} */
    const state = (editor) =>
      editor.tab.evaluate(`({
        tool: document.querySelector('input[name="tool"]:checked').value,
        color: document.getElementById("color").dataset.color,
        cursor: getComputedStyle(document.getElementById("canvas")).cursor,
        shown: [...document.querySelectorAll(".toggle :checked")].map((box) => box.ariaLabel),
      })`);

    /** @param {Editor} editor @param {Point[]} points in units of the viewBox */
    const drag = async (editor, points) => editor.drag(await editor.place(points, SIDE));

    /** @param {Editor} editor @param {Point} point */
    const colorAt = async (editor, point) => {
      const [[x, y]] = await editor.place([point], SIDE);
      return (await editor.picture()).at(x, y);
    };

    test("Pick colour takes that of a region, exactly, and scribbling goes on with it", async () => {
      const editor = await open();
      await editor.tab.click("radio", "Pick colour");
      assert.equal((await state(editor)).tool, "pick");
      await editor.until(`Picked ${RED}`, () => drag(editor, [LEFT_ROOM]));
      const { tool, color } = await state(editor);
      assert.deepEqual([tool, color], ["scribble", RED]);
      assert.deepEqual(editor.tab.faults, []);
    });

    test("what is picked from a shaded place is what the canvas shows there", async () => {
      const editor = await session.open("cpu");
      await editor.openColored("Sphere");
      await editor.toggle("Show scribbles");
      const { width, height } = await editor.box();
      const place = /** @type {Point} */ ([Math.round(0.45 * width), Math.round(0.4 * height)]);
      const seen = (await editor.picture()).at(...place);
      assert.ok(distance(seen, PAPER) > 20, `${hex(seen)} is paper`);
      await editor.tab.press("i");
      await editor.until("Picked", () => editor.drag([place]));
      const { color } = await state(editor);
      const picked = /** @type {[number, number, number]} */ ([1, 3, 5].map((i) => parseInt(color.slice(i, i + 2), 16)));
      assert.ok(distance(picked, seen) <= 2, `${color} is not ${hex(seen)}`);
    });

    test("Alt picks for a moment, and scribbles nothing", async () => {
      const editor = await open();
      const before = await editor.picture();
      await editor.until(`Picked ${RED}`, () => editor.tab.hold("Alt", () => drag(editor, [[150, 30], [60, 70], LEFT_ROOM])));
      assert.equal((await state(editor)).color, RED);
      assert.ok((await editor.picture()).equals(before));
    });

    test("the hand moves the view, and scribbles nothing", async () => {
      const editor = await open();
      await editor.until("Hand", () => editor.tab.press("h"));
      const before = await editor.place([LEFT_ROOM], SIDE);
      await editor.drag([[200, 200], [230, 190], [260, 180]]);
      const [[x, y]] = await editor.place([LEFT_ROOM], SIDE);
      assert.deepEqual([Math.round(x - before[0][0]), Math.round(y - before[0][1])], [60, -20]);
      assert.equal(await editor.status(), "Hand");
      assert.equal(await colorAt(editor, LEFT_ROOM).then(hex), RED);
    });

    test("each tool has a key and a cursor of its own", async () => {
      const editor = await open();
      const cursors = new Set();
      for (const [key, tool] of [["e", "erase"], ["i", "pick"], ["h", "hand"], ["b", "scribble"]]) {
        await editor.tab.press(key);
        const now = await state(editor);
        assert.equal(now.tool, tool);
        cursors.add(now.cursor);
      }
      assert.equal(cursors.size, 4);
      assert.deepEqual(editor.tab.faults, []);
    });

    test("lines, scribbles and result are shown and hidden by their boxes and keys", async () => {
      const editor = await open();
      const all = ["Show lines", "Show scribbles", "Show result"];
      assert.deepEqual((await state(editor)).shown, all);
      await editor.toggle("Show result");
      assert.equal(hex(await colorAt(editor, LEFT_ROOM)), hex(PAPER));
      assert.equal(hex(await colorAt(editor, IN_LEFT_ROOM[1])), RED, "the scribble is there");
      for (const [key, layer] of [["L", all[0]], ["B", all[1]]]) {
        await editor.tab.hold("Shift", () => editor.tab.press(key));
        assert.ok(!(await state(editor)).shown.includes(layer), layer);
      }
      assert.equal(hex(await colorAt(editor, IN_LEFT_ROOM[1])), hex(PAPER));
      await editor.tab.hold("Shift", () => editor.tab.press("R"));
      assert.deepEqual((await state(editor)).shown, ["Show result"]);
      assert.equal(hex(await colorAt(editor, LEFT_ROOM)), RED);
    });
  });
}
