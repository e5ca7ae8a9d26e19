// axe, by Deque, looks at the page in each of its states: nothing serious or critical.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { describe, test } from "node:test";
import { Editor, useSession } from "./harness.mjs";

const AXE = await readFile(new URL("../../node_modules/axe-core/axe.min.js", import.meta.url), "utf8");

const WIDE = /** @type {const} */ ([1200, 800]);
const PHONE = /** @type {const} */ ([360, 640]);

/** What is open or chosen, and how one comes there. @type {Record<string, (editor: Editor) => Promise<unknown>>} */
const STATES = {
  "a drawing": async () => {},
  shading: (editor) => editor.tab.click("radio", "Shade"),
  settings: (editor) => editor.click("Settings"),
  "a rotated page": (editor) => editor.click("Rotate left"),
  erasing: (editor) => editor.tab.click("radio", "Erase"),
  "a selection": (editor) => selected(editor, 1),
  "a selected line": (editor) => selected(editor, 3),
  samples: (editor) => opened(editor, "Samples", "samples"),
  "recent drawings": (editor) => opened(editor, "Recent drawings", "recent"),
  export: (editor) => opened(editor, "Export", "export"),
  "a bad size": async (editor) => {
    await opened(editor, "Export", "export");
    await editor.tab.evaluate(`{
      const size = document.getElementById("export-size");
      size.value = "0";
      size.dispatchEvent(new Event("input", { bubbles: true }));
    }`);
  },
  "the picker": (editor) => shown(editor, "Colour"),
  "the picker, HSV": async (editor) => {
    await shown(editor, "Colour");
    await editor.tab.click("radio", "HSV");
  },
  "the palette": (editor) => shown(editor, "Edit palette"),
  history: async (editor) => {
    await editor.tab.evaluate(`document.querySelector('[data-action="undo"]').click()`);
    await shown(editor, "History");
  },
  share: (editor) => opened(editor, "Share", "share"),
  help: (editor) => opened(editor, "Help", "help"),
  "the first steps": (editor) => editor.tab.evaluate(`document.querySelector('[data-action="first-steps"]').click()`),
  "another version": (editor) => editor.tab.evaluate(`document.getElementById("update").hidden = false`),
  "a drawing on its way": (editor) => editor.tab.evaluate(`document.getElementById("busy").hidden = false; document.querySelector("#busy p").textContent = "Opening …"`),
  "a warning": (editor) =>
    editor.tab.evaluate(`document.getElementById("alert").hidden = false; document.querySelector("#alert p").textContent = "Mind."`),
};

/** Those that only a narrow window has. @type {typeof STATES} */
const NARROW = {
  files: (editor) => editor.tab.click("button", "File"),
  view: (editor) => editor.tab.click("button", "View"),
};

/** @param {Editor} editor @param {string} button @param {string} dialog */
async function opened(editor, button, dialog) {
  await editor.click(button);
  await editor.tab.waitFor(`document.getElementById("${dialog}")?.open`);
}

/**
 * Scribbles, and selects what comes so many after nothing.
 * @param {Editor} editor
 * @param {number} count
 */
async function selected(editor, count) {
  await editor.tab.press("b");
  await editor.scribble([[30, 30], [60, 60]], 200);
  for (let i = 0; i < count; i++) await editor.until("selected", () => editor.tab.press("n"));
}

/** @param {Editor} editor @param {string} button of a panel of colours */
async function shown(editor, button) {
  await editor.tab.click("button", button);
  await editor.tab.waitFor(`document.querySelector(".colors:popover-open") !== null`);
}

/** @param {Editor} editor @returns {Promise<string[]>} what is serious or critical, and where */
const faults = (editor) =>
  editor.tab.evaluate(`axe.run(document, { resultTypes: ["violations"] }).then(({ violations }) =>
    violations
      .filter(({ impact }) => ["serious", "critical"].includes(impact))
      .flatMap(({ id, nodes }) => nodes.map(({ target, failureSummary }) => [id, target, failureSummary].join(" | "))))`);

/** Colours are the same in both browsers. @type {["chromium" | "firefox", string[]][]} */
const THEMES = [
  ["chromium", ["light", "dark"]],
  ["firefox", ["light"]],
];

for (const [browser, themes] of THEMES) {
  describe(`axe in ${browser}`, () => {
    const session = useSession(browser);

    for (const [name, [width, height], states] of /** @type {const} */ ([
      ["a wide window", WIDE, STATES],
      ["a phone", PHONE, { ...STATES, ...NARROW }],
    ])) {
      for (const theme of themes) {
        test(`finds nothing serious in ${name}, ${theme}`, async () => {
          const editor = await session.open("cpu");
          await editor.tab.resize(width, height);
          await editor.openDrawing("rooms");
          await editor.tab.evaluate(`document.documentElement.style.colorScheme = "${theme}"`);
          await editor.tab.evaluate(AXE);
          for (const [state, reach] of Object.entries(states)) {
            await reach(editor);
            assert.deepEqual(await faults(editor), [], state);
            await editor.tab.evaluate(`
              document.querySelector("dialog[open]")?.close();
              document.querySelector(":popover-open")?.hidePopover();`);
          }
        });
      }
    }
  });
}

describe("the colours of a system", () => {
  const session = useSession("chromium");

  test("are not those of swatches, and leave it to a frame what is on", async () => {
    const tab = await session.newTab({ isForced: true });
    const editor = await Editor.open(tab, `${session.url}?renderer=cpu`, "cpu");
    await editor.click("Colour");
    await tab.waitFor(`document.querySelector(".colors:popover-open .pair") !== null`);
    const forced = await tab.evaluate(`{
      const style = (selector) => getComputedStyle(document.querySelector(selector));
      const adjust = (selector) => style(selector).forcedColorAdjust;
      [
        style("#palette .swatch").backgroundColor,
        adjust(".colors .pair > *"),
        style(".tool:has(:checked)").borderTopWidth,
        style(".tool:not(:has(:checked))").borderTopWidth,
      ];
    }`);
    assert.deepEqual(forced, ["rgb(229, 72, 77)", "none", "2px", "0px"]);
    assert.deepEqual(tab.faults, []);
  });
});
