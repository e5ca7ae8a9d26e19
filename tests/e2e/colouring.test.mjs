// Scribbling, as a user does it, in every renderer: colour where it belongs and nowhere else, sharp at every zoom.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { describe, test } from "node:test";
import { TARGETS, useSession } from "./harness.mjs";
import { assertSame, hex, PAPER, Picture } from "./picture.mjs";

/** @typedef {[number, number]} Point */

/** The longer side of the viewBox of `drawings/rooms.svg`, which has two rooms; in the right one stands a pillar. */
const ROOMS = 200;
const LEFT_ROOM = /** @type {Point[]} */ ([[12, 12], [98, 88]]);
const RIGHT_ROOM = /** @type {Point[]} */ ([[102, 12], [123, 88]]);
const PILLAR = /** @type {Point[]} */ ([[133, 38], [157, 62]]);
const IN_LEFT_ROOM = /** @type {Point[]} */ ([[30, 30], [50, 60], [70, 40]]);
const IN_PILLAR = /** @type {Point[]} */ ([[140, 50], [150, 50]]);

const RED = "#e5484d";
const BLUE = "#3b82f6";
const WHITE = hex(PAPER);

for (const { browser, renderer } of TARGETS) {
  describe(`${renderer} in ${browser}`, () => {
    const session = useSession(browser, { hasGpu: renderer !== "cpu" });

    const openRooms = async () => {
      const editor = await session.open(renderer);
      await editor.openDrawing("rooms");
      await editor.toggle("Show scribbles");
      return editor;
    };

    /**
     * The colours on the canvas inside a rectangle of the drawing.
     * @param {import("./harness.mjs").Editor} editor
     * @param {Point[]} corners
     */
    const colorsIn = async (editor, corners) => {
      const [from, to] = await editor.place(corners, ROOMS);
      return (await editor.picture()).colors(from, to);
    };

    test("a scribble colours all of its room, exactly as picked, and nothing else", async () => {
      const editor = await openRooms();
      await editor.click("Red");
      await editor.scribble(IN_LEFT_ROOM, ROOMS);
      assert.deepEqual(await colorsIn(editor, LEFT_ROOM), [RED]);
      assert.deepEqual(await colorsIn(editor, RIGHT_ROOM), [WHITE]);
      assert.deepEqual(await colorsIn(editor, PILLAR), [WHITE]);

      await editor.click("Blue");
      await editor.scribble(IN_PILLAR, ROOMS);
      assert.deepEqual(await colorsIn(editor, LEFT_ROOM), [RED]);
      assert.deepEqual(await colorsIn(editor, RIGHT_ROOM), [WHITE]);
      assert.deepEqual(await colorsIn(editor, PILLAR), [BLUE]);
      assert.deepEqual(editor.tab.faults, []);
    });

    test("colour follows the pen while it is down", async () => {
      const editor = await openRooms();
      await editor.click("Red");
      const { x, y } = await editor.box();
      const way = await editor.place(IN_LEFT_ROOM, ROOMS);
      await editor.tab.mouse.move(x + way[0][0], y + way[0][1]);
      await editor.tab.mouse.down();
      for (const [px, py] of way) await editor.tab.mouse.move(x + px, y + py);
      assert.deepEqual(await colorsIn(editor, LEFT_ROOM), [RED]);
      await editor.until("Scribble added", () => editor.tab.mouse.up());
    });

    test("undo takes a scribble back, redo brings it again", async () => {
      const editor = await openRooms();
      const empty = await editor.picture();
      await editor.click("Blue");
      await editor.scribble(IN_LEFT_ROOM, ROOMS);
      const colored = await editor.picture();
      assert.ok(!colored.equals(empty));
      await editor.until("Undone", () => editor.click("Undo"));
      assert.ok((await editor.picture()).equals(empty));
      await editor.until("Redone", () => editor.click("Redo"));
      assert.ok((await editor.picture()).equals(colored));
    });

    test("edges are at most two pixels wide at 800%", async () => {
      const editor = await openRooms();
      await editor.click("Red");
      await editor.scribble(IN_LEFT_ROOM, ROOMS);
      const percent = () => editor.tab.evaluate(`parseInt(document.getElementById("zoom").textContent)`);
      while ((await percent()) < 800) await editor.click("Zoom in");
      const [[wall_px, y_px]] = await editor.place([[100, 50]], ROOMS);
      const across = async () => {
        const picture = await editor.picture();
        return runs(Array.from({ length: 201 }, (_, i) => hex(picture.at(wall_px - 100 + i, y_px))));
      };
      assertSharp(await across(), [RED, "#000000", WHITE]);
      await editor.toggle("Show lines");
      assertSharp(await across(), [RED, WHITE]);
    });

    const noDownloads = browser === "firefox" && "downloads are watched in Chromium";
    test("the exported PNG is what the canvas shows", { skip: noDownloads }, async () => {
      const editor = await openRooms();
      await editor.click("Red");
      await editor.scribble(IN_LEFT_ROOM, ROOMS);
      await editor.click("Blue");
      await editor.scribble([[110, 20], [115, 80]], ROOMS);
      await editor.click("Export");
      const exported = Picture.decode(await readFile(await editor.tab.download(() => editor.click("Save file"))));

      await editor.tab.evaluate(`document.getElementById("zoom").click()`);
      const [[left, top]] = await editor.place([[0, 0]], ROOMS);
      const shown = await editor.picture();
      assertSame(shown.part(Math.round(left), Math.round(top), exported), exported);
    });
  });
}

/**
 * Neighbours of equal colour taken together.
 * @param {string[]} row
 */
function runs(row) {
  /** @type {{color: string, length: number}[]} */
  const runs = [];
  for (const color of row) {
    const last = runs.at(-1);
    if (last?.color === color) last.length += 1;
    else runs.push({ color, length: 1 });
  }
  return runs;
}

/**
 * Asserts that a row shows these colours one after the other with at most two pixels between them.
 * @param {{color: string, length: number}[]} row
 * @param {string[]} colors
 */
function assertSharp(row, colors) {
  const between_px = row.filter(({ color }) => !colors.includes(color)).reduce((sum, { length }) => sum + length, 0);
  const flat = row.filter(({ color }) => colors.includes(color)).map(({ color }) => color);
  assert.deepEqual(flat, colors, JSON.stringify(row));
  assert.ok(between_px <= 2 * (colors.length - 1), `${between_px} pixels between: ${JSON.stringify(row)}`);
}
