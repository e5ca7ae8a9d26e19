// The settings of a drawing: each changes the picture, and undo takes it back.
import assert from "node:assert/strict";
import { describe, test } from "node:test";
import { useSession } from "./harness.mjs";
import { hex, PAPER } from "./picture.mjs";

/** @typedef {[number, number]} Point */

/** The longer side of the viewBox of the drawings here. */
const SIDE = 200;
const IN_LEFT_ROOM = /** @type {Point[]} */ ([[30, 30], [50, 60], [70, 40]]);
const ROOMS = /** @type {Point[]} */ ([[20, 80], [115, 80]]);

const RED = "#e5484d";
const WHITE = hex(PAPER);

describe("settings", () => {
  const session = useSession("chromium");

  /**
   * A drawing with a red scribble in its left part.
   * @param {string} drawing
   */
  const open = async (drawing) => {
    const editor = await session.open("cpu");
    await editor.openDrawing(drawing);
    await editor.toggle("Show scribbles");
    await editor.click("Red");
    await editor.scribble(IN_LEFT_ROOM, SIDE);
    return editor;
  };

  /** @param {import("./harness.mjs").Editor} editor */
  const colors = async (editor) => {
    const [places, picture] = [await editor.place(ROOMS, SIDE), await editor.picture()];
    return places.map(([x, y]) => hex(picture.at(x, y)));
  };

  /**
   * What a control has and says.
   * @param {import("./harness.mjs").Editor} editor
   * @param {string} setting
   */
  const shown = (editor, setting) => editor.tab.evaluate(`{
    const control = document.querySelector('[data-setting="${setting}"]');
    ({ value: control.value, text: control.getAttribute("aria-valuetext"), disabled: control.disabled });
  }`);

  test("the engine", async () => {
    const editor = await open("shading");
    await editor.click("Blue");
    await editor.scribble([[60, 80], [100, 70], [130, 80]], SIDE);
    const global = await editor.picture();
    await editor.choose("Engine", "progressive");
    const progressive = await editor.picture();
    assert.ok(!progressive.equals(global));
    assert.equal((await shown(editor, "spread")).disabled, true);
    await editor.until("Undone", () => editor.click("Undo"));
    assert.ok((await editor.picture()).equals(global));
    assert.equal((await shown(editor, "engine")).value, "global");
    assert.deepEqual(editor.tab.faults, []);
  });

  test("gap closing opens and closes a doorway, and follows the slider while it is dragged", async () => {
    const editor = await open("doorway");
    await editor.slide("gap-closing", 100);
    assert.deepEqual(await colors(editor), [RED, WHITE]);
    assert.deepEqual(await shown(editor, "gap-closing"), { value: "100", text: "100%", disabled: false });
    await editor.slide("gap-closing", 0, async () => assert.deepEqual(await colors(editor), [RED, RED]));
    assert.deepEqual(await colors(editor), [RED, RED]);
    await editor.until("Undone", () => editor.click("Undo"));
    assert.deepEqual(await colors(editor), [RED, WHITE]);
    assert.equal((await shown(editor, "gap-closing")).text, "100%");
    await editor.until("Undone", () => editor.click("Undo"));
    assert.equal((await shown(editor, "gap-closing")).text, "50%");
    assert.deepEqual(editor.tab.faults, []);
  });

  test("the ends of gap closing say what is there, in each language", async () => {
    const editor = await open("doorway");
    for (const [language, settings, ends] of /** @type {const} */ ([
      ["en", "Settings", ["Less: colours flow on", "more: stop sooner"]],
      ["de", "Einstellungen", ["Weniger: Farben laufen", "mehr: sie stoppen"]],
    ])) {
      if (language !== "en") await editor.choose("Language", language);
      await editor.tab.waitFor(`document.documentElement.lang === "${language}"`);
      await editor.tab.click("button", settings);
      const { words, apart, heights } = await editor.tab.evaluate(`{
        const [slider, ...ends] = ["#gap-closing", "#gap-note :first-child", "#gap-note :last-child"].map((end) => document.querySelector(end));
        const [track, low, high] = [slider, ...ends].map((part) => part.getBoundingClientRect());
        ({
          words: ends.map((end) => end.textContent),
          apart: [low.left - track.left, track.right - high.right],
          heights: [low.height, high.height],
        });
      }`);
      assert.deepEqual(words, ends);
      assert.deepEqual(apart, [0, 0]);
      assert.ok(heights.every((/** @type {number} */ height) => height < 24), `${heights}: a line each`);
      await editor.tab.press("Escape");
    }
    assert.deepEqual(editor.tab.faults, []);
  });

  test("regions and gaps are shown in place of the result", async () => {
    const editor = await open("doorway");
    await editor.slide("gap-closing", 100);
    await editor.toggle("Show regions and gaps");
    const [left, right] = await colors(editor);
    assert.notDeepEqual(left, right);
    assert.ok(![left, right].some((tint) => [RED, WHITE].includes(tint)), `${left} ${right}`);
    await editor.tab.press("Shift+G");
    assert.deepEqual(await colors(editor), [RED, WHITE]);
    assert.deepEqual(editor.tab.faults, []);
  });

  test("while C is held, the drawing is shown as it was before", async () => {
    const editor = await open("rooms");
    const after = await colors(editor);
    await editor.tab.hold("c", async () => assert.deepEqual(await colors(editor), [WHITE, WHITE]));
    assert.deepEqual(await colors(editor), after);
    assert.equal(after[0], RED);
  });

  test("Spread colours what was paper", async () => {
    const editor = await open("rooms");
    assert.deepEqual(await colors(editor), [RED, WHITE]);
    await editor.toggle("Spread");
    assert.deepEqual(await colors(editor), [RED, RED]);
    await editor.until("Undone", () => editor.click("Undo"));
    assert.deepEqual(await colors(editor), [RED, WHITE]);
  });
});
