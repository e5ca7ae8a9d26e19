// What can be done with scribbles once they are there, and a scribble of no colour.
import assert from "node:assert/strict";
import { describe, test } from "node:test";
import { useSession } from "./harness.mjs";
import { distance, hex, PAPER } from "./picture.mjs";

/** @typedef {[number, number]} Point */

/** The longer side of the viewBox of the drawings here. */
const SIDE = 200;
const IN_LEFT_ROOM = /** @type {Point[]} */ ([[30, 30], [50, 60], [70, 40]]);
const IN_PILLAR = /** @type {Point[]} */ ([[140, 50], [150, 50]]);

const RED = "#e5484d";
const BLUE = "#3b82f6";
const WHITE = hex(PAPER);

describe("editing", () => {
  const session = useSession("chromium");

  /** @param {string} drawing */
  const open = async (drawing) => {
    const editor = await session.open("cpu");
    await editor.openDrawing(drawing);
    await editor.toggle("Show scribbles");
    return editor;
  };

  /**
   * The colours at places of the drawing.
   * @param {import("./harness.mjs").Editor} editor
   * @param {Point[]} points
   */
  const colorsAt = async (editor, points) => {
    const [places, picture] = [await editor.place(points, SIDE), await editor.picture()];
    return places.map(([x, y]) => hex(picture.at(x, y)));
  };

  /**
   * Drags the pointer through places of the drawing, and waits for the page's word.
   * @param {import("./harness.mjs").Editor} editor
   * @param {Point[]} points
   * @param {string} words
   */
  const drag = async (editor, points, words) => {
    const way = await editor.place(points, SIDE);
    await editor.until(words, () => editor.drag(way));
  };

  const twoScribbles = async () => {
    const editor = await open("rooms");
    await editor.click("Red");
    await editor.scribble(IN_LEFT_ROOM, SIDE);
    await editor.click("Blue");
    await editor.scribble(IN_PILLAR, SIDE);
    return editor;
  };
  const PLACES = /** @type {Point[]} */ ([[20, 80], [145, 65]]);

  test("a click with the eraser takes a whole scribble away, undo brings it back", async () => {
    const editor = await twoScribbles();
    const colored = await editor.picture();
    await editor.tab.click("radio", "Erase");
    await drag(editor, [[50, 60]], "Scribble erased, 1 in the drawing");
    assert.deepEqual(await colorsAt(editor, PLACES), [WHITE, BLUE]);
    await editor.until("Undone", () => editor.click("Undo"));
    assert.ok((await editor.picture()).equals(colored));
    await editor.until("Redone", () => editor.click("Redo"));
    assert.deepEqual(await colorsAt(editor, PLACES), [WHITE, BLUE]);
    assert.deepEqual(editor.tab.faults, []);
  });

  test("an eraser that is dragged takes all that it crosses, in one gesture", async () => {
    const editor = await twoScribbles();
    const colored = await editor.picture();
    await editor.tab.press("e");
    await drag(editor, [[40, 30], [50, 80], [145, 40], [145, 60]], "2 scribbles erased, 0 in the drawing");
    await drag(editor, [[40, 30], [50, 80]], "No scribble there to erase");
    assert.deepEqual(await colorsAt(editor, PLACES), [WHITE, WHITE]);
    await editor.until("Undone", () => editor.tab.press("Control+z"));
    assert.ok((await editor.picture()).equals(colored));
  });

  test("a colour that is picked, or B, goes back to scribbling", async () => {
    const editor = await open("rooms");
    const tool = () => editor.tab.evaluate(`document.querySelector('input[name="tool"]:checked').value`);
    for (const act of [() => editor.click("Red"), () => editor.tab.press("b"), () => editor.tab.press("1")]) {
      await editor.tab.press("e");
      assert.equal(await tool(), "erase");
      await act();
      assert.equal(await tool(), "scribble");
    }
  });

  test("no colour keeps a place free", async () => {
    const editor = await open("doorway");
    await editor.slide("gap-closing", 0);
    await editor.click("Red");
    await editor.scribble(IN_LEFT_ROOM, SIDE);
    const rooms = /** @type {Point[]} */ ([[20, 80], [180, 80]]);
    assert.deepEqual(await colorsAt(editor, rooms), [RED, RED]);
    /** A breath of the red comes in by the door. */
    const assertLeftAlone = async () => {
      const [places, picture] = [await editor.place(rooms, SIDE), await editor.picture()];
      const [left, right] = places.map(([x, y]) => picture.at(x, y));
      assert.equal(hex(left), RED);
      assert.ok(distance(right, PAPER) <= 4, `${hex(right)} is no paper`);
    };
    await editor.click("No colour");
    await editor.scribble([[130, 30], [150, 60], [170, 40]], SIDE);
    await assertLeftAlone();
    await editor.until("Undone", () => editor.click("Undo"));
    await editor.tab.press("1");
    await editor.tab.press("0");
    await editor.scribble([[130, 30], [150, 60], [170, 40]], SIDE);
    await assertLeftAlone();
    assert.deepEqual(editor.tab.faults, []);
  });
});
