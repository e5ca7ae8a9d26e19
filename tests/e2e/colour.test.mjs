// Colours: the picker, the palette that belongs to the drawing, and the colours that were used last; with the pointer and
// with keys alone.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { describe, test } from "node:test";
import { makeFolder, useSession } from "./harness.mjs";
import { distance, hex } from "./picture.mjs";

/** @typedef {[number, number]} Point */
/** @typedef {import("./harness.mjs").Editor} Editor */

/** The longer side of the viewBox of the drawings here. */
const SIDE = 200;
const IN_LEFT_ROOM = /** @type {Point[]} */ ([[30, 30], [50, 60], [70, 40]]);
const IN_PILLAR = /** @type {Point[]} */ ([[140, 50], [150, 50]]);
/** Where no panel lies over it. */
const LEFT_ROOM = /** @type {Point} */ ([94, 20]);
const PILLAR = /** @type {Point} */ ([145, 65]);

const RED = "#e5484d";
const BLUE = "#3b82f6";

const USUAL = ["Red", "Orange", "Yellow", "Green", "Teal", "Blue", "Violet", "Pink", "Brown", "Peach", "Slate", "White"];

/** @param {Editor} editor @returns {Promise<string>} */
const color = (editor) => editor.tab.evaluate(`document.getElementById("color").dataset.color`);

/** The names of a list's swatches. @param {Editor} editor @param {string} list @returns {Promise<string[]>} */
const names = (editor, list) =>
  editor.tab.evaluate(`[...document.querySelectorAll('ul[aria-label="${list}"] > li')]
    .filter((item) => item.checkVisibility())
    .map((item) => item.ariaLabel ?? item.querySelector("button").ariaLabel)`);

/** The palette beside the canvas, but for "No colour". @param {Editor} editor */
const palette = async (editor) => (await names(editor, "Palette")).slice(0, -1);

/** Opens a panel, and waits for it. @param {Editor} editor @param {"Colour" | "Edit palette"} button */
const openPanel = async (editor, button) => {
  await editor.tab.click("button", button);
  // The panel takes the focus some time after it is there.
  await editor.tab.waitFor(`document.querySelector(".colors:popover-open:focus-within") !== null`);
};

/** Whatever is in the panel that is open. */
const IN_PANEL = ".colors:popover-open";

/** @param {Editor} editor @param {string} name of a slider */
const slider = (editor, name) =>
  /** @type {Promise<{x: number, y: number, width: number, height: number, text: string, max: number}>} */ (
    editor.tab.evaluate(`{
      const label = [...document.querySelectorAll("${IN_PANEL} label")].find((label) => label.textContent === "${name}");
      const slider = label.control;
      slider.scrollIntoView({ block: "nearest" });
      ({ ...slider.getBoundingClientRect().toJSON(), text: slider.getAttribute("aria-valuetext"), max: Number(slider.max) });
    }`)
  );

/**
 * Drags a slider of a panel over some of its parts, 0 to 1.
 * @param {Editor} editor
 * @param {string} name
 * @param {number[]} way
 * @param {() => Promise<unknown>} [look] before it is let go
 */
const turn = async (editor, name, way, look = async () => {}) => {
  const { x, y, width, height } = await slider(editor, name);
  const move = (/** @type {number} */ part) => editor.tab.mouse.move(x + 9 + (width - 18) * part, y + height / 2);
  await move(way[0]);
  await editor.tab.mouse.down();
  for (const part of way) await move(part);
  await look();
  await editor.tab.mouse.up();
};

/** Gives something in the panel the focus. @param {Editor} editor @param {string} selector */
const focus = (editor, selector) => editor.tab.evaluate(`document.querySelector('${IN_PANEL} ${selector}').focus()`);

/** Writes into a field of the panel, as keys do. @param {Editor} editor @param {string} selector @param {string} text */
const write = async (editor, selector, text) => {
  await editor.tab.evaluate(`document.querySelector('${IN_PANEL} ${selector}').select()`);
  for (const key of text) await editor.tab.press(key);
  await editor.tab.press("Enter");
};

const HEX = `input[aria-label="Hex"]`;
const NAME = ".field input";

for (const browser of /** @type {const} */ (["chromium", "firefox"])) {
  describe(`colour in ${browser}`, () => {
    const session = useSession(browser);
    const folder = makeFolder();

    const open = async () => {
      const editor = await session.open("cpu");
      await editor.openDrawing("rooms");
      return editor;
    };

    /** A red room and a blue pillar. */
    const openColoured = async () => {
      const editor = await open();
      await editor.click("Red");
      await editor.scribble(IN_LEFT_ROOM, SIDE);
      await editor.click("Blue");
      await editor.scribble(IN_PILLAR, SIDE);
      await editor.toggle("Show scribbles");
      return editor;
    };

    /** @param {Editor} editor */
    const colorsOfRooms = async (editor) => {
      const [places, picture] = [await editor.place([LEFT_ROOM, PILLAR], SIDE), await editor.picture()];
      return places.map(([x, y]) => picture.at(x, y));
    };

    test("a place in the HSV square is saturation and value, by a drag or by keys", async () => {
      const editor = await open();
      await editor.click("Red");
      await openPanel(editor, "Colour");
      await editor.tab.click("radio", "HSV");
      const square = () => editor.tab.evaluate(`{
        const square = document.querySelector("${IN_PANEL} [role=slider]");
        ({ ...square.getBoundingClientRect().toJSON(), text: square.getAttribute("aria-valuetext"), now: square.ariaValueNow });
      }`);
      const { x, y, width, height, text } = await square();
      assert.equal(text, "Saturation 69%, Value 90%");
      const move = (/** @type {number} */ right, /** @type {number} */ up) => editor.tab.mouse.move(x + right * width, y + (1 - up) * height);
      await move(0.2, 0.2);
      await editor.tab.mouse.down();
      await move(0.5, 0.6);
      await move(0.75, 0.8);
      await editor.tab.mouse.up();
      assert.match((await square()).text, /^Saturation 7[456]%, Value (79|8[01])%$/);
      await focus(editor, "[role=slider]");
      for (const key of ["End", "PageUp", "PageUp", "PageUp", "ArrowLeft", "ArrowDown", "ArrowDown"]) await editor.tab.press(key);
      assert.deepEqual([(await square()).text, (await square()).now], ["Saturation 99%, Value 98%", "99"]);
      await editor.tab.hold("Shift", () => editor.tab.press("ArrowLeft"));
      assert.equal((await square()).text, "Saturation 89%, Value 98%");
      assert.match(await color(editor), /^#fa1b/);
      await editor.tab.press("Escape");
      await editor.tab.press("x");
      assert.equal(await color(editor), RED, "all of the way was one colour");
      assert.deepEqual(editor.tab.faults, []);
    });

    test("the picker's sliders give colours, and X goes back to the one before all of them", async () => {
      const editor = await open();
      await editor.click("Red");
      await openPanel(editor, "Colour");
      assert.equal((await slider(editor, "Lightness")).text, "63%");
      await turn(editor, "Hue", [0.07, 0.3, 0.72]);
      const turned = await color(editor);
      assert.notEqual(turned, RED);
      assert.equal((await slider(editor, "Hue")).text.split("°")[0], "259");
      await focus(editor, "[type=range]");
      for (let i = 0; i < 5; i++) await editor.tab.press("ArrowRight");
      assert.match((await slider(editor, "Lightness")).text, /^68%/);
      const lighter = await color(editor);
      assert.notEqual(lighter, turned);
      await editor.tab.press("x");
      assert.equal(await color(editor), RED);
      assert.equal((await slider(editor, "Lightness")).text, "63%", "the picker follows");
      await editor.tab.press("x");
      assert.equal(await color(editor), lighter);
      assert.deepEqual(editor.tab.faults, []);
    });

    test("what is scribbled is exactly what was picked", async () => {
      const editor = await open();
      await openPanel(editor, "Colour");
      await write(editor, HEX, "#1b9");
      assert.equal(await color(editor), "#11bb99");
      await editor.tab.press("Escape");
      await editor.toggle("Show scribbles");
      await editor.scribble(IN_LEFT_ROOM, SIDE);
      assert.equal(hex((await colorsOfRooms(editor))[0]), "#11bb99");
    });

    test("beyond sRGB a slider says so, and gives what there is", async () => {
      const editor = await open();
      await editor.click("Blue");
      await openPanel(editor, "Colour");
      assert.equal((await slider(editor, "Chroma")).text, "0.188");
      await turn(editor, "Chroma", [0.57, 0.8, 1]);
      assert.equal((await slider(editor, "Chroma")).text, "0.330, more than screens have");
      const most = await color(editor);
      await turn(editor, "Chroma", [1, 0.9]);
      assert.equal(await color(editor), most);
      await turn(editor, "Chroma", [0.9, 0]);
      assert.match(await color(editor), /^#(..)\1\1$/);
      await turn(editor, "Chroma", [0, 0.57]);
      assert.equal((await slider(editor, "Hue")).text, "260°", "gray has kept the hue");
    });

    test("HSV, shades and harmonies", async () => {
      const editor = await open();
      await openPanel(editor, "Colour");
      await write(editor, HEX, "ff0000");
      await editor.tab.click("radio", "HSV");
      const texts = () => Promise.all(["Hue", "Saturation", "Value"].map(async (name) => (await slider(editor, name)).text));
      assert.deepEqual(await texts(), ["0°", "100%", "100%"]);
      await turn(editor, "Hue", [0, 0.5]);
      assert.equal(await color(editor), "#00ffff");
      const shades = await names(editor, "Shades");
      assert.equal(shades.length, 5);
      const light = shades.map((shade) => parseInt(shade.slice(-4, -2), 16));
      assert.ok(light.every((green, i) => i === 0 || green <= light[i - 1]), `${shades} get darker`);
      await editor.tab.click("button", shades[4]);
      assert.equal(await color(editor), shades[4].slice(-7));
      const kinds = (await names(editor, "Harmonies")).map((name) => name.split(" ")[0]);
      assert.deepEqual(kinds, ["Complementary", "Analogous", "Analogous", "Triadic", "Triadic"]);
      assert.deepEqual(editor.tab.faults, []);
    });

    test("a digit beyond the palette picks nothing", async () => {
      const editor = await open();
      await editor.until("The palette has the colours of", () => editor.tab.evaluate(`{
        const data = new DataTransfer();
        data.setData("text/plain", "#112233 #445566");
        document.body.dispatchEvent(new DragEvent("drop", { dataTransfer: data, bubbles: true }));
      }`));
      await editor.tab.press("2");
      await editor.tab.press("9");
      assert.equal(await color(editor), "#445566");
      await editor.scribble(IN_LEFT_ROOM, SIDE);
      assert.equal(await editor.message(), "");
      assert.deepEqual(editor.tab.faults, []);
    });

    test("what is no colour is marked, and changes nothing", async () => {
      const editor = await open();
      await editor.click("Red");
      await openPanel(editor, "Colour");
      await editor.tab.evaluate(`document.querySelector('${IN_PANEL} ${HEX}').select()`);
      for (const key of "#12") await editor.tab.press(key);
      const state = () => editor.tab.evaluate(`{
        const field = document.querySelector('${IN_PANEL} ${HEX}');
        [field.value, field.ariaInvalid];
      }`);
      assert.deepEqual(await state(), ["#12", "true"]);
      await editor.tab.press("Enter");
      assert.deepEqual(await state(), [RED, "false"]);
      assert.equal(await color(editor), RED, "digits in the field are no shortcuts");
    });

    test("a swatch that gets another colour takes all along that is painted with it, while it is dragged, in one step", async () => {
      const editor = await openColoured();
      const colored = await editor.picture();
      await editor.click("Red");
      await openPanel(editor, "Edit palette");
      await turn(editor, "Hue", [0.07, 0.2, 0.4], async () => {
        const [room, pillar] = await colorsOfRooms(editor);
        assert.ok(distance(room, [0xe5, 0x48, 0x4d]) > 60, `${hex(room)} is still red`);
        assert.equal(hex(pillar), BLUE);
      });
      const edited = await color(editor);
      assert.notEqual(edited, RED, "who scribbles with the swatch goes on with it");
      assert.deepEqual((await colorsOfRooms(editor)).map(hex), [edited, BLUE]);
      assert.deepEqual(await palette(editor), [edited, ...USUAL.slice(1)]);
      await editor.tab.press("Escape");
      await editor.until("Undone", () => editor.click("Undo"));
      assert.ok((await editor.picture()).equals(colored));
      assert.deepEqual(await palette(editor), USUAL);
      await editor.until("Redone", () => editor.click("Redo"));
      assert.deepEqual((await colorsOfRooms(editor)).map(hex), [edited, BLUE]);
      assert.deepEqual(editor.tab.faults, []);
    });

    test("the brush follows its swatch where undo and redo give it another colour, and stays where it was picked since", async () => {
      const editor = await openColoured();
      await openPanel(editor, "Edit palette");
      await editor.tab.click("option", "Blue");
      await write(editor, HEX, "#20a060");
      await editor.tab.press("Escape");
      const marked = () => editor.tab.evaluate(`[...document.querySelectorAll("#palette [aria-pressed=true]")].map((swatch) => swatch.dataset.color)`);
      for (const [words, button, swatch] of [["Undone", "Undo", BLUE], ["Redone", "Redo", "#20a060"]]) {
        await editor.until(words, () => editor.click(button));
        assert.deepEqual([await color(editor), await marked()], [swatch, [swatch]], words);
      }
      await editor.click("Red");
      await editor.until("Undone", () => editor.click("Undo"));
      assert.equal(await color(editor), RED);
      assert.deepEqual(editor.tab.faults, []);
    });

    test("a swatch's other colour is the brush's, and not that of what is selected in other colours", async () => {
      const editor = await openColoured();
      await editor.click("Red");
      await editor.until("2 scribbles selected", () => editor.tab.hold("Control", () => editor.tab.press("a")));
      await openPanel(editor, "Edit palette");
      await editor.tab.click("option", "Red");
      await write(editor, HEX, "#00ff00");
      await editor.tab.press("Escape");
      await editor.tab.press("Escape");
      assert.deepEqual((await colorsOfRooms(editor)).map(hex), ["#00ff00", BLUE]);
      assert.equal(await color(editor), "#00ff00");
      await editor.until("Undone", () => editor.click("Undo"));
      assert.deepEqual((await colorsOfRooms(editor)).map(hex), [RED, BLUE], "it was one step");
      assert.deepEqual(editor.tab.faults, []);
    });

    test("a colour that a swatch passes on its way stays where it was", async () => {
      const editor = await openColoured();
      await openPanel(editor, "Edit palette");
      await editor.tab.click("option", "Red");
      await write(editor, HEX, BLUE);
      await write(editor, HEX, "#00ff00");
      // From blue on both were one colour.
      assert.deepEqual((await colorsOfRooms(editor)).map(hex), ["#00ff00", "#00ff00"]);
      await editor.tab.press("Escape");
      for (let i = 0; i < 2; i++) await editor.until("Undone", () => editor.click("Undo"));
      assert.deepEqual((await colorsOfRooms(editor)).map(hex), [RED, BLUE]);
    });

    test("swatches are added, named and removed, all of it with undo, and are there again with the drawing", async () => {
      const editor = await open();
      await openPanel(editor, "Colour");
      await write(editor, HEX, "#804020");
      await editor.until("#804020 has been added to the palette", () => editor.tab.click("button", "Add to palette"));
      assert.deepEqual(await palette(editor), [...USUAL, "#804020"]);
      await editor.tab.press("Escape");
      await openPanel(editor, "Edit palette");
      await editor.until("Fur is the name", () => write(editor, NAME, "Fur"));
      assert.deepEqual(await palette(editor), [...USUAL, "Fur"]);
      await editor.tab.click("option", "Orange");
      await editor.until("Orange removed", () => editor.tab.click("button", "Remove swatch"));
      const edited = [USUAL[0], ...USUAL.slice(2), "Fur"];
      assert.deepEqual(await palette(editor), edited);
      await editor.kept();
      const again = await session.reopen(editor.tab);
      assert.deepEqual(await palette(again), edited);
      assert.deepEqual(editor.tab.faults, []);
    });

    test("keys that remove a swatch leave what is selected", async () => {
      const editor = await openColoured();
      await editor.until("2 scribbles selected", () => editor.tab.hold("Control", () => editor.tab.press("a")));
      await openPanel(editor, "Edit palette");
      await editor.tab.click("option", "Green");
      await editor.until("Green removed", () => editor.tab.press("Delete"));
      await editor.until("Teal removed", () => editor.tab.press("Backspace"));
      assert.deepEqual((await colorsOfRooms(editor)).map(hex), [RED, BLUE]);
      assert.equal(await editor.tab.evaluate(`document.getElementById("selected-count").textContent`), "2 scribbles");
    });

    test("what is written in a field is for the swatch that it was written for, whichever is chosen next", async () => {
      const editor = await open();
      await openPanel(editor, "Edit palette");
      await editor.tab.click("option", "Red");
      await editor.tab.evaluate(`document.querySelector('${IN_PANEL} ${NAME}').select()`);
      for (const key of "Fur") await editor.tab.press(key);
      await editor.tab.click("option", "Green");
      assert.deepEqual(await palette(editor), ["Fur", ...USUAL.slice(1)]);
      await editor.tab.evaluate(`document.querySelector('${IN_PANEL} ${HEX}').select()`);
      for (const key of "#123456") await editor.tab.press(key);
      await editor.tab.click("option", "Orange");
      assert.deepEqual(await palette(editor), ["Fur", "Orange", "Yellow", "#123456", ...USUAL.slice(4)]);
      const chosen = `document.querySelector('${IN_PANEL} [aria-selected=true]').title`;
      assert.equal(await editor.tab.evaluate(chosen), "Orange");
      assert.deepEqual(editor.tab.faults, []);
    });

    test("the last swatch stays, with the focus", async () => {
      const editor = await open();
      await openPanel(editor, "Edit palette");
      for (let count = USUAL.length; count > 1; count--) await editor.tab.click("button", "Remove swatch");
      assert.deepEqual(await palette(editor), USUAL.slice(-1));
      assert.equal(await editor.tab.evaluate(`document.activeElement.getAttribute("role")`), "option");
    });

    test("each change of the palette is one step", async () => {
      const editor = await open();
      await editor.click("Red");
      await openPanel(editor, "Edit palette");
      await write(editor, NAME, "Skin");
      await editor.tab.click("button", "Remove swatch");
      await editor.tab.click("button", "Sort by lightness");
      for (const expected of [USUAL.slice(1), ["Skin", ...USUAL.slice(1)], USUAL]) {
        await editor.until("Undone", () => editor.tab.hold("Control", () => editor.tab.press("z")));
        assert.deepEqual(await palette(editor), expected);
      }
      assert.deepEqual(await names(editor, "Swatches"), USUAL, "the panel follows");
    });

    test("swatches are sorted by hue and lightness, by hand, and by keys", async () => {
      const editor = await open();
      await openPanel(editor, "Edit palette");
      await editor.until("Palette sorted", () => editor.tab.click("button", "Sort by lightness"));
      const light = await palette(editor);
      assert.deepEqual([light[0], light[1], light.at(-1)], ["White", "Peach", "Slate"]);
      await editor.until("Palette sorted", () => editor.tab.click("button", "Sort by hue"));
      const hues = await palette(editor);
      assert.deepEqual(hues.slice(-2), ["White", "Slate"], "grays are last");
      assert.ok(hues.indexOf("Red") < hues.indexOf("Yellow") && hues.indexOf("Yellow") < hues.indexOf("Blue"), `${hues}`);

      await focus(editor, "[role=option][aria-selected=true]");
      await editor.tab.press("Home");
      await editor.tab.hold("Shift", () => editor.tab.press("ArrowRight"));
      const [first, second, ...rest] = hues;
      assert.deepEqual(await palette(editor), [second, first, ...rest]);
      await editor.tab.click("button", "Move earlier");
      assert.deepEqual(await palette(editor), hues);

      const places = await editor.tab.evaluate(`
        [...document.querySelectorAll("[role=option]")].map((option) => {
          const { x, y, width, height } = option.getBoundingClientRect();
          return [x + width / 2, y + height / 2];
        })`);
      const [from, over, to] = [0, 1, 3].map((i) => /** @type {Point[]} */ (places)[i]);
      await editor.tab.mouse.move(...from);
      await editor.tab.mouse.down();
      for (const place of [over, to]) await editor.tab.mouse.move(...place);
      await editor.tab.mouse.up();
      assert.deepEqual(await palette(editor), [...hues.slice(1, 4), hues[0], ...hues.slice(4)]);
      assert.deepEqual(await names(editor, "Swatches"), await palette(editor));
      assert.deepEqual(editor.tab.faults, []);
    });

    test("the colours that were used last are at hand, also the next time", async () => {
      const editor = await openColoured();
      assert.deepEqual(await names(editor, "Recent"), ["Recent: Blue", "Recent: Red"]);
      await editor.tab.press("3");
      assert.equal((await names(editor, "Recent")).length, 2, "what is picked is not used yet");
      await editor.click("Recent: Red");
      assert.equal(await color(editor), RED);
      await editor.scribble(IN_PILLAR, SIDE);
      assert.deepEqual(await names(editor, "Recent"), ["Recent: Red", "Recent: Blue"]);
      await editor.kept();
      const again = await session.reopen(editor.tab);
      assert.deepEqual(await names(again, "Recent"), ["Recent: Red", "Recent: Blue"]);
    });

    test("all of the picker is done with keys", async () => {
      const editor = await open();
      await editor.tab.evaluate(`document.getElementById("color").focus()`);
      await editor.tab.press("Enter");
      await editor.tab.waitFor(`document.querySelector("${IN_PANEL}") !== null`);
      const focused = () => editor.tab.evaluate(`{
        const { id, labels, ariaLabel, textContent } = document.activeElement;
        labels?.[0]?.textContent || ariaLabel || textContent || id;
      }`);
      assert.equal(await focused(), "Lightness");
      const order = [];
      for (let i = 0; i < 4; i++) {
        order.push(await focused());
        await editor.tab.press("Tab");
      }
      assert.deepEqual(order.slice(0, 3), ["Lightness", "Chroma", "Hue"]);
      assert.match(order[3], /^Shade #/);
      await editor.tab.press("Escape");
      assert.equal(await focused(), "Colour", "the focus comes back");
      await editor.tab.press("Enter");
      await editor.tab.waitFor(`document.querySelector("${IN_PANEL}") !== null`);
      await editor.tab.press("Escape");
      assert.equal(await focused(), "Colour");
      assert.deepEqual(editor.tab.faults, []);
    });

    test("a colour is taken from the screen where the browser has that", async () => {
      const tab = await session.newTab();
      await tab.prepare(`window.EyeDropper = class { open() { return Promise.resolve({ sRGBHex: "#123456" }); } }`);
      const editor = await session.reopen(tab);
      await openPanel(editor, "Colour");
      await tab.click("button", "Pick from the screen");
      await tab.waitFor(`document.getElementById("color").dataset.color === "#123456"`);
      assert.deepEqual(tab.faults, []);
    });

    if (browser === "chromium") {
      test("a palette goes out as a file and comes back with its names", async () => {
        const editor = await open();
        await openPanel(editor, "Edit palette");
        await write(editor, NAME, "Rot");
        const file = async () => readFile(await editor.tab.download(() => editor.tab.click("button", "Export palette")), "utf8");
        assert.match(await file(), /^GIMP Palette\n[^]*229 {2}72 {2}77\tRot\n245 128 {2}62\tOrange\n/);
        await editor.tab.choose("Format", "hex");
        assert.match(await file(), /^e5484d\nf5803e\n/);

        const path = await folder.write("two.gpl", "GIMP Palette\nName: Two\n#\n1 2 3\tInk\n250 251 252\n");
        await editor.until("The palette has the colours of two.gpl", () =>
          editor.tab.chooseFiles([path], "Import palette"));
        assert.deepEqual(await palette(editor), ["Ink", "#fafbfc"]);
        assert.deepEqual(await names(editor, "Swatches"), ["Ink", "#fafbfc"]);
      });
    }
  });
}
