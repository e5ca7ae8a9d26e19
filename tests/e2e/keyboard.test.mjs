// The whole job from the keyboard alone: choose a region, scribble in it, change the colour, undo, export.
import assert from "node:assert/strict";
import { describe, test } from "node:test";
import { useSession } from "./harness.mjs";

/** @typedef {import("./harness.mjs").Editor} Editor */

const IS_CANVAS = `document.activeElement.id === "canvas"`;

/** Goes on with Tab until something has the focus. @param {Editor} editor @param {string} isThere */
async function tabTo(editor, isThere) {
  for (let i = 0; i < 60; i++) {
    if (await editor.tab.evaluate(isThere)) return;
    await editor.tab.press("Tab");
  }
  assert.fail(`${isThere} is not reached`);
}

/** @param {Editor} editor @param {string} key @param {number} count */
async function press(editor, key, count) {
  for (let i = 0; i < count; i++) await editor.tab.press(key);
}

/** Where the cross hairs are, in CSS pixels of the canvas. @param {Editor} editor @returns {Promise<number[]>} */
const cross = (editor) =>
  editor.tab.evaluate(`document.getElementById("cross").style.translate.split(" ").map(parseFloat)`);

for (const browser of /** @type {const} */ (["chromium", "firefox"])) {
  describe(`the keyboard in ${browser}`, () => {
    const session = useSession(browser);

    /** A drawing of two rooms, with the canvas focused. */
    const begun = async () => {
      const editor = await session.open("cpu");
      await editor.openDrawing("rooms");
      await tabTo(editor, IS_CANVAS);
      return editor;
    };

    test("two regions are coloured, a mistake is taken back, and the picture is exported", async () => {
      const editor = await begun();
      await editor.until("Arrows move the cross hairs", () => editor.tab.press("Enter"));
      await press(editor, "ArrowLeft", 12);
      await editor.until("Pen down", () => editor.tab.press("Enter"));
      await press(editor, "ArrowDown", 4);
      await editor.until("Scribble added, 1 in the drawing", () => editor.tab.press("Enter"));
      await editor.until("Green", () => editor.tab.press("4"));
      await editor.until("Erase", () => editor.tab.press("e"));
      await editor.until("Scribble", () => editor.tab.press("b"));
      await editor.tab.hold("Shift", () => press(editor, "ArrowRight", 5));
      await editor.tab.press("Enter");
      await press(editor, "ArrowUp", 4);
      await editor.until("Scribble added, 2 in the drawing", () => editor.tab.press("Enter"));
      const [x, y] = await cross(editor);
      const picture = await editor.picture();
      const [left, right] = [x - 200 + 16, x - 16].map((at) => picture.at(Math.round(at), Math.round(y)));
      assert.notDeepEqual(left, right);
      await editor.until("Undone", () => editor.tab.hold("Control", () => editor.tab.press("z")));
      await editor.until("Redone", () => editor.tab.hold("Control", () => editor.tab.press("y")));

      await editor.tab.hold("Control", () => editor.tab.hold("Shift", () => editor.tab.press("E")));
      await editor.tab.waitFor(`document.getElementById("export")?.open`);
      await tabTo(editor, `document.activeElement.dataset.action === "save-export"`);
      await editor.until("Exported", () => editor.tab.press("Enter"));
      assert.deepEqual(editor.tab.faults, []);
    });

    test("single keys say what they have chosen, in the language of the page", async () => {
      const editor = await begun();
      const size = await editor.tab.evaluate(`document.getElementById("brush-size").valueAsNumber`);
      const shifted = (/** @type {string} */ key) => editor.tab.hold("Shift", () => editor.tab.press(key));
      for (const [key, words] of [
        ["e", "Erase"], ["v", "Select"], ["b", "Scribble"], ["s", "Shade"], ["s", "Fill"],
        ["3", "Yellow"], ["0", "No colour"], ["x", "Yellow"],
        ["m", "Mirrored"],
      ]) {
        await editor.until(words, () => editor.tab.press(key));
      }
      await editor.until("Show lines: off", () => shifted("L"));
      await editor.until("Show lines: on", () => shifted("L"));
      await editor.until("Zoom ", () => shifted("1"));
      await editor.until("Brush size: ", () => editor.tab.press("]"));
      assert.ok(Number((await editor.status()).split(" ").at(-1)) > size, await editor.status());
      await editor.choose("Language", "de");
      await tabTo(editor, IS_CANVAS);
      for (const [key, words] of [["e", "Radieren"], ["4", "Grün"]]) {
        await editor.until(words, () => editor.tab.press(key));
      }
      await editor.until("Kritzel zeigen: aus", () => shifted("B"));
      assert.deepEqual(editor.tab.faults, []);
    });

    test("what a key does to what is selected is said each time, though in the same words", async () => {
      const editor = await begun();
      await editor.scribble([[30, 30], [50, 60], [70, 40]], 200);
      await editor.until("selected", () => editor.tab.press("n"));
      for (let i = 0; i < 2; i++) {
        await editor.until("with another brush size", () => editor.tab.press("]"));
        await new Promise((wake) => setTimeout(wake, 200));
        assert.match(await editor.status(), /with another brush size/);
      }
    });

    test("Escape drops the stroke, then puts the cross hairs away; arrows move the view then, as at its rim", async () => {
      const editor = await begun();
      const view = () => editor.tab.evaluate(`document.getElementById("canvas").dataset.view`);
      await editor.tab.press("Enter");
      await editor.tab.waitFor(`document.getElementById("cross")?.hidden === false`);
      const before = await view();
      await editor.until("Pen down", () => editor.tab.press("Enter"));
      await press(editor, "ArrowDown", 3);
      assert.equal(await view(), before);
      await editor.until("dropped", () => editor.tab.press("Escape"));
      assert.equal(await editor.tab.evaluate(`document.getElementById("cross").hidden`), false);
      await editor.tab.hold("Shift", () => press(editor, "ArrowLeft", 40));
      assert.equal((await cross(editor))[0], 0);
      await editor.tab.waitFor(`document.getElementById("canvas").dataset.view !== "${before}"`);
      const beyond = await view();
      await editor.tab.press("Escape");
      assert.equal(await editor.tab.evaluate(`document.getElementById("cross").hidden`), true);
      await editor.tab.press("ArrowRight");
      await editor.tab.waitFor(`document.getElementById("canvas").dataset.view !== "${beyond}"`);
      assert.deepEqual(editor.tab.faults, []);
    });

    test("Enter and arrows that come before the cross hairs are there do what they do later", async () => {
      const editor = await begun();
      const view = () => editor.tab.evaluate(`document.getElementById("canvas").dataset.view`);
      const before = await view();
      const keys = ["Enter", "ArrowLeft", "ArrowLeft", "Enter", "ArrowDown", "ArrowDown", "Enter"];
      await editor.until("Scribble added, 1 in the drawing", () =>
        editor.tab.evaluate(`for (const key of ${JSON.stringify(keys)})
          document.activeElement.dispatchEvent(new KeyboardEvent("keydown", { key, code: key, bubbles: true }))`),
      );
      const [width, height] = await editor.tab.evaluate(`((stage) => [stage.clientWidth, stage.clientHeight])(
        document.getElementById("cross").parentElement)`);
      assert.deepEqual(await cross(editor), [Math.round(width / 2) - 16, Math.round(height / 2) + 16]);
      assert.equal(await view(), before);
      assert.deepEqual(editor.tab.faults, []);
    });

    test("Undo takes back what the pen draws, which is up then", async () => {
      const editor = await begun();
      await editor.tab.press("Enter");
      await editor.tab.waitFor(`document.getElementById("cross")?.hidden === false`);
      for (let count = 0; count < 2; count++) {
        await editor.until("Pen down", () => editor.tab.press("Enter"));
        await press(editor, "ArrowLeft", 3);
        await editor.until("Undone", () => editor.tab.hold("Control", () => editor.tab.press("z")));
      }
      assert.deepEqual(editor.tab.faults, []);
    });

    test("signs that take AltGr, or a Mac's Option, are shortcuts like others", async () => {
      for (const [platform, held] of /** @type {const} */ ([
        ["Win32", { ctrlKey: true, altKey: true, modifierAltGraph: true }],
        ["Linux x86_64", { modifierAltGraph: true }],
        ["MacIntel", { altKey: true }],
      ])) {
        const tab = await session.newTab();
        await tab.prepare(`Object.defineProperty(Navigator.prototype, "platform", { get: () => "${platform}" })`);
        const editor = await session.reopen(tab);
        /** @param {string} key @param {string} [id] */
        const send = (key, id = "canvas") => tab.evaluate(`document.getElementById("${id}").dispatchEvent(
          new KeyboardEvent("keydown", { key: "${key}", bubbles: true, cancelable: true, ...${JSON.stringify(held)} }))`);
        const size = () => tab.evaluate(`document.getElementById("brush-size").valueAsNumber`);
        const before = await size();
        await send("]");
        const larger = await size();
        assert.ok(larger > before, `${larger} on ${platform}`);
        await send("[");
        assert.ok((await size()) < larger, platform);
        await editor.click("Export");
        await editor.click("Close");
        const state = await size();
        await send("]", "export-size");
        assert.equal(await size(), state, "fields have their signs");
        assert.deepEqual(tab.faults, []);
      }
    });

    test("Tab lifts the pen, the mouse takes over, a colour is picked, and buttons keep Enter", async () => {
      const editor = await begun();
      await editor.tab.press("Enter");
      await editor.tab.waitFor(`document.getElementById("cross")?.hidden === false`);
      await press(editor, "ArrowLeft", 12);
      await editor.until("Pen down", () => editor.tab.press("Enter"));
      await press(editor, "ArrowDown", 3);
      await editor.until("Scribble added, 1", () => editor.tab.press("Tab"));
      const place = await cross(editor);
      await editor.tab.press("ArrowDown");
      assert.deepEqual(await cross(editor), place, "arrows are the focused control's");
      await tabTo(editor, IS_CANVAS);
      await editor.tab.press("0");
      await editor.tab.press("i");
      await editor.until("Picked", () => editor.tab.press("Enter"));
      await editor.tab.press("b");
      await editor.until("Scribble added, 2", () => editor.scribble([[120, 30], [140, 60]], 200));
      assert.equal(await editor.tab.evaluate(`document.getElementById("cross").hidden`), true);
      await tabTo(editor, `document.activeElement.tagName === "BUTTON"`);
      const focused = await editor.tab.evaluate(`document.activeElement.ariaLabel ?? document.activeElement.textContent`);
      await editor.tab.press("Enter");
      assert.equal(await editor.tab.evaluate(`document.getElementById("cross").hidden`), true, focused);
      assert.deepEqual(editor.tab.faults, []);
    });
  });
}
