// The ways by which a drawing comes into the page, beside the file dialog: dropped, pasted.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { before, describe, test } from "node:test";
import { drawing, useSession } from "./harness.mjs";

describe("opening a drawing", () => {
  const session = useSession("chromium");
  /** @type {import("./harness.mjs").Editor} */
  let editor;
  /** @type {string} */
  let svg;
  before(async () => {
    svg = await readFile(drawing("rooms.svg"), "utf8");
    editor = await session.open("cpu");
  });

  test("a file dropped on the page", () =>
    editor.until("Opened rooms", () => editor.drop(svg, "rooms.svg")));

  test("two files dropped at once, of which one is opened", () =>
    editor.until("Opened first.svg alone", () => editor.drop(svg, "first.svg", "second.svg")));

  const paste = (/** @type {string} */ text) =>
    editor.tab.evaluate(`{
      const data = new DataTransfer();
      data.setData("text/plain", ${JSON.stringify(text)});
      document.body.dispatchEvent(new ClipboardEvent("paste", { clipboardData: data, bubbles: true }));
    }`);

  test("pasted text", () => editor.until("Opened", () => paste(svg)));

  test("a pasted colour is the brush's from then on, and the palette stays", async () => {
    const swatches = () => editor.tab.evaluate(`document.querySelectorAll('ul[aria-label="Palette"] > li').length`);
    const before = await swatches();
    await editor.until("Picked #ff8800", () => paste(" #F80\n"));
    assert.equal(await editor.tab.evaluate(`document.getElementById("color").dataset.color`), "#ff8800");
    assert.equal(await swatches(), before);
  });

  test("pasted colours become the palette, and are called what they are", () =>
    editor.until("The palette has the colours of the text", () => paste("#112233 #445566")));

  test("pasted text that is no drawing, of which it says so", async () => {
    for (const text of ["Dear <all>,", "Issue #12 is open"]) {
      await paste(text);
      assert.match(await editor.message(), /text is no drawing/);
      await editor.tab.press("Escape");
    }
  });
});
