// Scribbles that shade: where their colour shows, by which controls, with the pointer and from the keyboard.
import assert from "node:assert/strict";
import { describe, test } from "node:test";
import { useSession } from "./harness.mjs";
import { distance, hex, PAPER } from "./picture.mjs";

/** @typedef {[number, number]} Point */
/** @typedef {import("./harness.mjs").Editor} Editor */

/** The longer side of the viewBox of the drawings here. */
const SIDE = 200;
const IN_LEFT_ROOM = /** @type {Point[]} */ ([[20, 20], [30, 22]]);
const MIDDLE = /** @type {Point} */ ([55, 50]);
const CORNER = /** @type {Point} */ ([13, 86]);
/** Beyond the wall at 100. */
const NEXT_ROOM = /** @type {Point} */ ([112, 50]);

const RED = /** @type {[number, number, number]} */ ([0xe5, 0x48, 0x4d]);
const BLUE = /** @type {[number, number, number]} */ ([0x3b, 0x82, 0xf6]);

/** A difference, in levels, that nobody sees. */
const UNSEEN = 2;

describe("shading", () => {
  const session = useSession("chromium", { hasGpu: true });

  /**
   * A room filled with red, and a brush that shades.
   * @param {"cpu" | "webgpu" | "webgl"} [renderer]
   */
  const open = async (renderer = "cpu") => {
    const editor = await session.open(renderer);
    await editor.openDrawing("rooms");
    await editor.toggle("Show scribbles");
    await editor.click("Red");
    await editor.scribble(IN_LEFT_ROOM, SIDE);
    await editor.tab.click("radio", "Shade");
    return editor;
  };

  /**
   * The colours at places of the drawing.
   * @param {Editor} editor
   * @param {Point[]} points
   */
  const colorsAt = async (editor, points) => {
    const [places, picture] = [await editor.place(points, SIDE), await editor.picture()];
    return places.map(([x, y]) => picture.at(x, y));
  };

  /**
   * @param {[number, number, number]} found
   * @param {[number, number, number]} expected
   */
  const assertClose = (found, expected) =>
    assert.ok(distance(found, expected) <= UNSEEN, `${hex(found)}, not ${hex(expected)}`);

  /**
   * What of the controls is on.
   * @param {Editor} editor
   * @returns {Promise<{kind: string, tool: string, shading: boolean, strength: string, pressed: string[]}>}
   */
  const controls = (editor) =>
    editor.tab.evaluate(`{
      const on = (name) => document.querySelector('input[name="' + name + '"]:checked').value;
      ({
        kind: on("kind"),
        tool: on("tool"),
        shading: document.getElementById("strength").checkVisibility(),
        strength: document.getElementById("strength").getAttribute("aria-valuetext"),
        pressed: [...document.querySelectorAll('.palette [aria-pressed="true"]')].map((swatch) => swatch.ariaLabel),
      });
    }`);

  for (const renderer of /** @type {const} */ (["cpu", "webgpu", "webgl"])) {
    test(`a dab shows its colour in the middle of a room, and not at its rim (${renderer})`, async () => {
      const editor = await open(renderer);
      await editor.slide("strength", 100);
      await editor.click("Blue");
      await editor.scribble([MIDDLE], SIDE);
      const [middle, corner] = await colorsAt(editor, [MIDDLE, CORNER]);
      assertClose(middle, BLUE);
      assertClose(corner, RED);
      assert.deepEqual(editor.tab.faults, []);
    });
  }

  test("the picture follows the pen while it is down", async () => {
    const editor = await open();
    await editor.slide("strength", 100);
    await editor.click("Blue");
    const { x, y } = await editor.box();
    const way = await editor.place([[40, 50], MIDDLE], SIDE);
    await editor.tab.mouse.move(x + way[0][0], y + way[0][1]);
    await editor.tab.mouse.down();
    assertClose((await colorsAt(editor, [[40, 50]]))[0], BLUE);
    await editor.tab.mouse.move(x + way[1][0], y + way[1][1]);
    assertClose((await colorsAt(editor, [MIDDLE]))[0], BLUE);
    await editor.until("Shade added", () => editor.tab.mouse.up());
  });

  test("without strength nothing changes, and undo restores every pixel", async () => {
    const editor = await open();
    const filled = await editor.picture();
    await editor.click("Blue");
    await editor.slide("strength", 0);
    await editor.scribble([MIDDLE, [70, 60]], SIDE);
    assert.ok((await editor.picture()).equals(filled));
    await editor.slide("strength", 60);
    await editor.scribble([MIDDLE, [70, 60]], SIDE);
    const shaded = await editor.picture();
    assert.ok(!shaded.equals(filled));
    await editor.until("Undone", () => editor.click("Undo"));
    assert.ok((await editor.picture()).equals(filled));
    await editor.until("Redone", () => editor.click("Redo"));
    assert.ok((await editor.picture()).equals(shaded));
    await editor.tab.click("radio", "Erase");
    const [place] = await editor.place([MIDDLE], SIDE);
    await editor.until("Scribble erased", () => editor.drag([place]));
    assert.ok((await editor.picture()).equals(filled));
    assert.deepEqual(editor.tab.faults, []);
  });

  test("a stroke stays in the room that it begins in, unless it crosses lines", async () => {
    const editor = await open();
    await editor.slide("strength", 100);
    await editor.click("Blue");
    await editor.scribble([[85, 50], [115, 50]], SIDE);
    assert.deepEqual(await colorsAt(editor, [NEXT_ROOM]), [PAPER]);
    await editor.until("Undone", () => editor.click("Undo"));
    await editor.toggle("Cross lines");
    await editor.scribble([[85, 50], [115, 50]], SIDE);
    assertClose((await colorsAt(editor, [NEXT_ROOM]))[0], BLUE);
  });

  test("tones are steps from the colour under the pen", async () => {
    const editor = await open();
    await editor.slide("strength", 100);
    const luma = (/** @type {number[]} */ [r, g, b]) => 0.3 * r + 0.6 * g + 0.1 * b;
    const warmth = (/** @type {number[]} */ [r, , b]) => r - b;
    /** @type {[string, (found: number[]) => boolean][]} */
    const tones = [
      ["Lighter", (found) => luma(found) > luma(RED) + 40],
      ["Darker", (found) => luma(found) < luma(RED) - 40],
      ["Warmer", (found) => warmth(found) > warmth(RED) + 20],
      ["Cooler", (found) => warmth(found) < warmth(RED) - 20],
    ];
    for (const [tone, holds] of tones) {
      await editor.click(tone);
      assert.deepEqual((await controls(editor)).pressed, [tone]);
      await editor.scribble([MIDDLE], SIDE);
      const [found, corner] = await colorsAt(editor, [MIDDLE, CORNER]);
      assert.ok(holds(found), `${tone}: ${hex(found)}`);
      assertClose(corner, RED);
      await editor.until("Undone", () => editor.click("Undo"));
    }
    await editor.click("Blue");
    assert.deepEqual((await controls(editor)).pressed, ["Blue"]);
    assert.deepEqual(editor.tab.faults, []);
  });

  test("the pressure of a pen gives the radius or the strength, that of a mouse nothing", async () => {
    const editor = await open();
    await editor.slide("strength", 100);
    await editor.click("Blue");
    /** The colours in the middle of a dab, and within its radius, at full pressure. */
    const dabbed = async (/** @type {() => Promise<unknown>} */ dab) => {
      await editor.until("Shade added", dab);
      const colors = await colorsAt(editor, [MIDDLE, [MIDDLE[0] + 4, MIDDLE[1]]]);
      await editor.until("Undone", () => editor.click("Undo"));
      return colors;
    };
    const pen = async (/** @type {number} */ pressure) => {
      const [place] = await editor.place([MIDDLE], SIDE);
      return dabbed(() => press(editor, place, pressure));
    };
    const [, byMouse] = await dabbed(() => editor.scribble([MIDDLE], SIDE));
    const [, hard] = await pen(1);
    const [, soft] = await pen(0.2);
    assertClose(byMouse, hard);
    assert.ok(distance(soft, RED) < 0.7 * distance(hard, RED), `${hex(soft)}, ${hex(hard)}`);

    await editor.choose("Pen pressure", "strength");
    assertClose((await pen(1))[0], BLUE);
    const [weak] = await pen(0.2);
    assert.ok(distance(weak, BLUE) > 0.4 * distance(RED, BLUE), hex(weak));

    await editor.choose("Pen pressure", "off");
    assertClose((await pen(0.2))[1], hard);
    assert.deepEqual(editor.tab.faults, []);
  });

  test("S goes to and fro between Fill and Shade, and goes back to scribbling", async () => {
    const editor = await open();
    await editor.tab.press("s");
    assert.deepEqual(await controls(editor).then(({ kind, shading }) => [kind, shading]), ["fill", false]);
    await editor.tab.press("e");
    await editor.tab.press("s");
    const { kind, shading, tool } = await controls(editor);
    assert.deepEqual([kind, shading, tool], ["shade", true, "scribble"]);
  });

  test("each control has a name and is worked from the keyboard", async () => {
    const editor = await open();
    await editor.tab.click("slider", "Strength");
    const { strength } = await controls(editor);
    await editor.tab.press("ArrowRight");
    assert.equal((await controls(editor)).strength, `${parseInt(strength) + 1}%`);
    await editor.choose("Pen pressure", "strength");
    for (const box of [true, false]) {
      await editor.toggle("Cross lines");
      assert.equal(await editor.tab.evaluate(`document.querySelector('[data-setting="crosses"]').checked`), box);
    }
    // A colour goes back to the tool, a tone leads on to it: Tab goes through all of them.
    await editor.tab.evaluate(`document.querySelector('input[name="kind"]:checked').focus()`);
    await editor.tab.press("ArrowLeft");
    assert.equal((await controls(editor)).kind, "fill");
    await editor.tab.press("ArrowRight");
    assert.equal((await controls(editor)).kind, "shade");
    const names = await tabbed(editor, 24);
    for (const name of ["Lighter", "Darker", "Warmer", "Cooler", "Brush size", "Strength", "Pen pressure"]) {
      assert.ok(names.includes(name), `${name} is not among ${names}`);
    }
    await editor.tab.evaluate(`document.querySelector('[data-color="darker"]').focus()`);
    await editor.tab.press("Enter");
    assert.deepEqual((await controls(editor)).pressed, ["Darker"]);
    assert.deepEqual(editor.tab.faults, []);
  });

  test("strength is for the shade that is selected, and is shown as it is", async () => {
    const editor = await open();
    await editor.slide("strength", 40);
    await editor.click("Blue");
    await editor.scribble([MIDDLE, [70, 60]], SIDE);
    await editor.slide("strength", 90);
    await editor.tab.click("radio", "Fill");
    await editor.until("selected", () => editor.tab.press("n"));
    const shown = async () => {
      const { strength, kind, tool } = await controls(editor);
      return [strength, kind, tool];
    };
    assert.deepEqual(await shown(), ["40%", "shade", "select"]);
    await editor.slide("strength", 100);
    assert.deepEqual(await shown(), ["100%", "shade", "select"]);
    await editor.until("Undone", () => editor.click("Undo"));
    assert.deepEqual(await shown(), ["40%", "shade", "select"]);
    await editor.until("Redone", () => editor.click("Redo"));
    await editor.until("Nothing selected", () => editor.tab.press("Escape"));
    assert.deepEqual(await shown(), ["90%", "fill", "select"]);
    await editor.toggle("Show scribbles");
    assertClose((await colorsAt(editor, [MIDDLE]))[0], BLUE);
    assert.deepEqual(editor.tab.faults, []);
  });

  test("samples open with their highlights", async () => {
    const editor = await session.open("cpu");
    for (const [name, side, [highlight, dark]] of SHADED) {
      await editor.openColored(name);
      const places = await editor.place([highlight, dark], side);
      await editor.toggle("Show scribbles");
      const picture = await editor.picture();
      const [light, shadow] = places.map(([x, y]) => picture.at(x, y));
      assert.ok(Math.min(...light) > 215, `${name}: ${hex(light)}`);
      assert.ok(Math.max(...shadow) < 140, `${name}: ${hex(shadow)}`);
      await editor.toggle("Show scribbles");
    }
    assert.deepEqual(editor.tab.faults, []);
  });
});

/** Samples, the longer side of each, its highlight and its shadow. @type {[string, number, [Point, Point]][]} */
const SHADED = [
  ["Pear", 360, [[106, 228], [232, 262]]],
  ["Sphere", 360, [[129, 94], [210, 180]]],
];

/**
 * Puts a pen down and takes it away again.
 * @param {Editor} editor
 * @param {Point} place in CSS pixels of the canvas
 * @param {number} pressure
 */
async function press(editor, [x, y], pressure) {
  const box = await editor.box();
  // Only a pointer that the browser knows can be captured: the first is the mouse's.
  const at = { pointerId: 1, pointerType: "pen", bubbles: true, clientX: box.x + x, clientY: box.y + y, pressure };
  await editor.tab.evaluate(`
    for (const kind of ["pointerdown", "pointerup"]) {
      document.getElementById("canvas").dispatchEvent(new PointerEvent(kind, ${JSON.stringify(at)}));
    }`);
}

/**
 * The names of what Tab comes to, one after the other.
 * @param {Editor} editor
 * @param {number} count
 */
async function tabbed(editor, count) {
  const names = [];
  for (let i = 0; i < count; i++) {
    await editor.tab.press("Tab");
    names.push(await editor.tab.evaluate(`{
      const { ariaLabel, labels } = document.activeElement;
      ariaLabel ?? labels?.[0]?.textContent.trim() ?? "";
    }`));
  }
  return names;
}
