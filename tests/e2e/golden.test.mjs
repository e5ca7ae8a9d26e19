// The page in its main states is like the pictures in `golden/`. `cargo xtask golden` takes new ones.
import assert from "node:assert/strict";
import { describe, test } from "node:test";
import { ALIKE, assertGolden, atRest, isGolden } from "./golden.mjs";
import { Editor, useSession } from "./harness.mjs";

const WIDE = /** @type {const} */ ([1280, 800]);
const PHONE = /** @type {const} */ ([360, 740]);

/** What is open or chosen, and how one comes there from the first page. @type {Record<string, (editor: Editor) => Promise<unknown>>} */
const STATES = {
  start: async () => {},
  colored: (editor) => editor.openColored("Teapot with flowers"),
  shade: async (editor) => {
    await editor.openColored("Pear");
    await editor.tab.press("s");
  },
  selection: async (editor) => {
    await editor.openColored("Apple");
    await editor.tab.press("v");
    for (let i = 0; i < 6; i++) await editor.until("selected", () => editor.tab.press("n"));
  },
  picker: async (editor) => {
    await editor.openColored("Butterfly");
    await editor.tab.click("button", "Colour");
    await editor.tab.waitFor(`document.querySelector(".colors:popover-open") !== null`);
  },
  samples: async (editor) => {
    await editor.click("Samples");
    await editor.tab.waitFor(`document.querySelectorAll("#samples img").length > 0 &&
      [...document.querySelectorAll("#samples img")].slice(0, 8).every((image) => image.complete)`);
  },
  help: async (editor) => {
    await editor.click("Help");
    await editor.tab.waitFor(`document.getElementById("help")?.open`);
  },
  export: async (editor) => {
    await editor.click("Export");
    await editor.tab.waitFor(`document.getElementById("export")?.open`);
  },
};

/** @typedef {{renderer?: "webgpu" | "webgl", size?: readonly [number, number], isDark?: boolean, isFirst?: boolean}} Window */

describe("golden pictures", () => {
  const session = useSession("chromium", { hasGpu: true });

  /**
   * The page in a state, in a window of its own.
   * @param {string} state
   * @param {Window} window
   */
  async function reach(state, { renderer = "webgpu", size = WIDE, ...options }) {
    const tab = await session.newTab(options);
    await tab.resize(...size);
    await tab.prepare(ALIKE);
    const editor = await Editor.open(tab, `${session.url}?renderer=${renderer}`, renderer);
    await STATES[state](editor);
    assert.deepEqual(tab.faults, []);
    return tab;
  }

  /** The page as it is kept: a wide one at half its size. @param {import("./browsers.mjs").Tab} tab */
  async function seen(tab) {
    const picture = await atRest(tab);
    return picture.width > 1000 ? picture.half() : picture;
  }

  for (const state of Object.keys(STATES)) {
    test(state, async () => assertGolden(state, await seen(await reach(state, { isFirst: state === "start" }))));
  }
  test("dark", async () => assertGolden("dark", await seen(await reach("colored", { isDark: true }))));
  test("phone", async () => assertGolden("phone", await seen(await reach("colored", { size: PHONE }))));

  test("another renderer makes no difference", async () => {
    assert.ok(await isGolden("colored", await seen(await reach("colored", { renderer: "webgl" }))));
  });

  if (process.env.GOLDEN === "accept") return;
  for (const [change, script] of Object.entries({
    "a button that is missing": `document.getElementById("history").style.visibility = "hidden"`,
    "a swatch of another colour": `document.querySelector("#palette button").style.filter = "hue-rotate(20deg)"`,
    "a word that is another": `document.getElementById("drawing").textContent = "Teapot with flower"`,
    "a bar that is lower by two pixels": `document.querySelector("footer").style.paddingTop = "7px"`,
    "a picture with paler colours": `document.querySelector("canvas").style.filter = "saturate(0.8)"`,
  })) {
    test(`${change} is seen`, async () => {
      const tab = await reach("colored", {});
      await tab.evaluate(script);
      assert.ok(!(await isGolden("colored", await seen(tab))));
    });
  }
});
