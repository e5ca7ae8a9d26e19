// How the page lies in its window: the canvas has the room, and every control can be reached, from a wide screen to a phone.
import assert from "node:assert/strict";
import { before, describe, test } from "node:test";
import { useSession } from "./harness.mjs";

/** @typedef {import("./harness.mjs").Editor} Editor */

/** Windows, in CSS pixels, and how much of their height the canvas has at least. 600 by 400 is 1200 by 800 at 200%. */
const WINDOWS = /** @type {[number, number, number][]} */ ([
  [1600, 900, 0.88],
  [1200, 800, 0.88],
  [800, 600, 0.82],
  [600, 400, 0.6],
  [640, 360, 0.6],
  [568, 320, 0.6],
  [600, 960, 0.6],
  [360, 640, 0.6],
  [320, 568, 0.6],
]);

/** What can be pressed is at least so wide and high, in CSS pixels. */
const TARGET_PX = 24;

/** The longer side of the viewBox of `drawings/rooms.svg`. */
const ROOMS = 200;

/**
 * What is wrong with the controls that are shown: their names. What lies beside in its own scrolling row is fetched first.
 * @param {Editor} editor
 * @param {string} [within] a selector of where they are
 * @returns {Promise<string[]>}
 */
const unreachable = (editor, within = "") =>
  editor.tab.evaluate(`{
    const controls = [...document.querySelectorAll("${within}:is(button, input, select)")];
    controls.filter((control) => control.checkVisibility() && !control.closest("[aria-hidden], dialog") && control.type !== "file")
      .filter((control) => {
        const target = control.closest("label") ?? control;
        target.scrollIntoView({ block: "nearest", inline: "nearest" });
        const { left, top, right, bottom, width, height } = target.getBoundingClientRect();
        const isThere = left >= 0 && top >= 0 && right <= innerWidth && bottom <= innerHeight;
        const hit = document.elementFromPoint((left + right) / 2, (top + bottom) / 2);
        const isHit = control.disabled || target.contains(hit);
        return !isThere || !isHit || width < ${TARGET_PX} || height < ${TARGET_PX};
      })
      .map((control) => (control.ariaLabel ?? control.id) + " " + JSON.stringify(control.getBoundingClientRect()));
  }`);

/** @param {Editor} editor @returns {Promise<string>} what has the focus */
const focused = (editor) => editor.tab.evaluate("document.activeElement.ariaLabel");

/** @param {Editor} editor @param {string} id */
const isOpen = (editor, id) => editor.tab.evaluate(`document.getElementById("${id}").matches(":popover-open, [open]")`);

for (const browser of /** @type {const} */ (["chromium", "firefox"])) {
  describe(`the layout in ${browser}`, () => {
    const session = useSession(browser);
    /** @type {Editor} */
    let editor;
    before(async () => {
      editor = await session.open("cpu");
      await editor.openDrawing("rooms");
    });

    for (const [width, height, share] of WINDOWS) {
      test(`${width} by ${height}: the canvas has the room, and all controls can be reached`, async () => {
        await editor.tab.resize(width, height);
        await editor.tab.click("radio", "Shade");
        const { height: canvas } = await editor.box();
        assert.ok(canvas >= share * height, `the canvas is ${canvas} high`);
        assert.equal(await editor.tab.evaluate("document.documentElement.scrollWidth"), width);
        assert.deepEqual(await unreachable(editor), []);
        const openers = /** @type {string[]} */ (await editor.tab.evaluate(`
          [...document.querySelectorAll("[popovertarget]")].filter((b) => b.checkVisibility()).map((b) => b.ariaLabel)`));
        assert.ok(openers.includes("Settings"));
        for (const opener of openers) {
          await editor.click(opener);
          const inPanel = await editor.tab.evaluate(`document.querySelectorAll(":popover-open :is(button, input, select)").length`);
          assert.ok(inPanel >= 4, `${opener} has ${inPanel} controls`);
          assert.deepEqual(await unreachable(editor, ":popover-open "), []);
          await editor.tab.press("Escape");
          assert.equal(await focused(editor), opener, "the focus comes back");
          assert.equal(await editor.tab.evaluate(`document.querySelector(":popover-open")`), null);
        }
      });
    }

    for (const [width, height] of WINDOWS) {
      test(`${width} by ${height}: the panels of colours can be used, and the picture is seen beside them`, async () => {
        await editor.tab.resize(width, height);
        for (const opener of ["Colour", "Edit palette", "History"]) {
          await editor.tab.click("button", opener);
          await editor.tab.waitFor(`document.querySelector(".colors:popover-open") !== null`);
          assert.deepEqual(await unreachable(editor, ".colors:popover-open "), []);
          const { canvas, panel } = await editor.tab.evaluate(`({
            canvas: document.getElementById("canvas").getBoundingClientRect().toJSON(),
            panel: document.querySelector(".colors:popover-open").getBoundingClientRect().toJSON(),
          })`);
          const beside = (canvas.right - panel.right) / canvas.width;
          const above = (panel.top - canvas.top) / canvas.height;
          assert.ok(Math.max(beside, above) >= 0.25, `${beside} beside, ${above} above ${opener}`);
          await editor.tab.press("Escape");
          assert.equal(await editor.tab.evaluate(`document.querySelector(":popover-open")`), null);
        }
      });
    }

    test("in a low window the panels of colours leave the swatches to be seen", async () => {
      await editor.tab.resize(844, 390);
      await editor.tab.click("button", "Colour");
      await editor.tab.waitFor(`document.querySelector(".colors:popover-open") !== null`);
      const [rail, panel] = await editor.tab.evaluate(`
        ["aside", ".colors:popover-open"].map((part) => document.querySelector(part).getBoundingClientRect().toJSON())`);
      assert.ok(panel.left >= rail.right && panel.right <= 844, `${rail.right}, ${panel.left} to ${panel.right}`);
      await editor.tab.press("Escape");
    });

    test("in a low window the swatches are seen without scrolling", async () => {
      for (const [kind, width, height] of /** @type {const} */ ([
        ["Fill", 640, 360],
        ["Fill", 568, 320],
        ["Shade", 1024, 500],
        ["Shade", 1280, 750],
        ["Shade", 1280, 751],
      ])) {
        await editor.tab.resize(width, height);
        await editor.tab.click("radio", kind);
        const hidden = await editor.tab.evaluate(`{
          const rail = document.querySelector("aside");
          rail.scrollTop = 0;
          const end = rail.getBoundingClientRect().bottom;
          const swatches = [...document.querySelectorAll("#color, #palette button")];
          swatches.filter((swatch) => swatch.getBoundingClientRect().bottom > end).map((swatch) => swatch.ariaLabel);
        }`);
        assert.deepEqual(hidden, [], `${kind}, ${width} by ${height}`);
      }
    });

    test("on a phone held lengthwise all that shading takes is seen without scrolling", async () => {
      await editor.tab.resize(844, 390);
      await editor.tab.click("radio", "Shade");
      const [rail, shading] = await editor.tab.evaluate(`{
        const rail = document.querySelector("aside");
        rail.scrollTop = 0;
        [rail, document.getElementById("shading")].map((part) => part.getBoundingClientRect().bottom);
      }`);
      assert.ok(shading <= rail, `${shading} in ${rail}`);
    });

    test("on a small phone for fingers, the bar fits, what is said is whole, and rows that go on fade", async () => {
      await editor.tab.resize(320, 568);
      await editor.tab.evaluate(`document.getElementById("unsaved").hidden = false`);
      const { bar, status, rows, name } = await editor.tab.evaluate(`{
        const root = document.documentElement.style;
        // As the page has it for fingers.
        root.setProperty("--target", "44px");
        const status = document.getElementById("status");
        status.textContent = "Pick a colour and scribble it into the drawing";
        const shown = {
          name: document.getElementById("drawing").scrollWidth <= document.getElementById("drawing").clientWidth,
          bar: [...document.querySelectorAll("#bar button")].map((button) => button.getBoundingClientRect().right),
          status: [status.scrollWidth <= status.clientWidth, status.scrollHeight <= status.clientHeight],
          rows: [...document.querySelectorAll("aside .row")].map((row) => [row.scrollWidth > row.clientWidth, getComputedStyle(row).maskImage]),
        };
        root.removeProperty("--target");
        document.getElementById("unsaved").hidden = true;
        shown;
      }`);
      assert.ok(Math.max(...bar) <= 320, `${bar}`);
      assert.deepEqual([...status, name], [true, true, true]);
      for (const [goesOn, mask] of rows) assert.ok(goesOn && mask.startsWith("linear-gradient"), `${mask}`);
    });

    test("on a phone, files are in a menu, which closes when one of its commands is taken", async () => {
      await editor.tab.resize(360, 640);
      await editor.tab.click("button", "File");
      assert.ok(await isOpen(editor, "files"));
      await editor.tab.click("button", "Samples");
      await editor.tab.waitFor(`document.getElementById("samples")?.open`);
      assert.ok(!(await isOpen(editor, "files")));
      await editor.tab.press("Escape");
      await editor.tab.waitFor(`!document.getElementById("samples").open`);
      assert.equal(await focused(editor), "File");
    });

    test("a press beside an open panel closes it, and scribbles nothing", async () => {
      await editor.tab.resize(1200, 800);
      await editor.tab.click("button", "Settings");
      const way = await editor.place([[30, 30], [60, 50]], ROOMS);
      await editor.drag(way);
      assert.ok(!(await isOpen(editor, "settings")));
      assert.equal(await editor.tab.evaluate(`document.querySelector('[data-action="undo"]').disabled`), true);
      await editor.scribble([[30, 30], [60, 50]], ROOMS);
      assert.deepEqual(editor.tab.faults, []);
    });

    test("the toolbar is there before the module is", async () => {
      const tab = await session.newTab();
      await tab.prepare(`for (const name of ["instantiate", "instantiateStreaming"]) WebAssembly[name] = () => new Promise(() => {})`);
      await tab.goto(`${session.url}?renderer=cpu`);
      await tab.waitFor(`[...document.querySelectorAll("body > header button")].some((button) => button.ariaLabel === "Open")`);
      const names = await tab.evaluate(`
        [...document.querySelectorAll(":is(body > header, aside) :is(button, input, select)")]
          .filter((control) => control.checkVisibility() && !control.closest("[aria-hidden]"))
          .map((control) => control.ariaLabel ?? control.labels[0].textContent)`);
      for (const name of ["Open", "Undo", "Scribble", "Red", "Brush size", "Settings"]) {
        assert.ok(/** @type {string[]} */ (names).includes(name), `${name} among ${names}`);
      }
      assert.equal(await tab.evaluate(`document.getElementById("canvas").dataset.renderer`), undefined);
      assert.deepEqual(tab.faults, []);
    });
  });
}
