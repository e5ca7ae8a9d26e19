// The ways by which a drawing comes into the page, beside the file dialog: dropped, pasted, chosen from the samples.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { join } from "node:path";
import { before, describe, test } from "node:test";
import { DIST, drawing, useSession, version } from "./harness.mjs";

describe("opening a drawing", () => {
  const session = useSession("chromium");
  /** @type {import("./harness.mjs").Editor} */
  let editor;
  /** @type {string} */
  let svg;
  before(async () => {
    svg = JSON.stringify(await readFile(drawing("rooms.svg"), "utf8"));
    editor = await session.open("cpu");
  });

  test("a file dropped on the page", () =>
    editor.until("Opened rooms", () => editor.tab.evaluate(`{
      const data = new DataTransfer();
      data.items.add(new File([${svg}], "rooms.svg", { type: "image/svg+xml" }));
      document.getElementById("canvas").dispatchEvent(new DragEvent("drop", { dataTransfer: data, bubbles: true }));
    }`)));

  test("pasted text", () =>
    editor.until("Opened", () => editor.tab.evaluate(`{
      const data = new DataTransfer();
      data.setData("text/plain", ${svg});
      document.body.dispatchEvent(new ClipboardEvent("paste", { clipboardData: data, bubbles: true }));
    }`)));

  test("each sample, with the credit that it asks for", async () => {
    /** @type {{name: string, credit: string}[]} */
    const samples = JSON.parse(await readFile(join(DIST, await version(), "samples/index.json"), "utf8"));
    assert.equal(samples.filter(({ credit }) => credit === "OpenMoji, CC BY-SA 4.0").length, 12);
    assert.ok(samples.length >= 14);
    for (const { name } of samples) await editor.openSample(name);
    const shown = await editor.tab.evaluate(`document.getElementById("samples").textContent`);
    for (const { credit } of samples) assert.ok(String(shown).includes(credit));
    assert.deepEqual(editor.tab.faults, []);
  });
});
