// Files that are no drawings: the page says so, and the drawing that is open stays as it is.
import assert from "node:assert/strict";
import { describe, test } from "node:test";
import { makeFolder, useSession } from "./harness.mjs";

const svg = (/** @type {string} */ inside, box = "0 0 100 100") =>
  `<svg xmlns="http://www.w3.org/2000/svg" viewBox="${box}">${inside}</svg>`;

/** Ten times the one before: of ten levels nothing could draw all. */
const useBomb = () => {
  const levels = Array.from({ length: 10 }, (_, i) => {
    const uses = `<use href="#g${i}"/>`.repeat(10);
    return `<g id="g${i + 1}">${uses}</g>`;
  });
  return svg(`<defs><path id="g0" d="M0 0h1"/>${levels.join("")}</defs><use href="#g10"/>`);
};

const entityBomb = () => {
  const entities = Array.from({ length: 9 }, (_, i) => `<!ENTITY e${i + 1} "${`&e${i};`.repeat(10)}">`);
  return `<!DOCTYPE svg [<!ENTITY e0 "lol">${entities.join("")}]>${svg("<text>&e9;</text>")}`;
};

/** @type {Record<string, () => string | Uint8Array>} */
const BAD_FILES = {
  "an empty file": () => "",
  "not SVG": () => "<html><body>Good day</body></html>",
  "no curves": () => svg(""),
  "binary junk": () => Uint8Array.from({ length: 4096 }, (_, i) => (i * 197 + (i >> 3)) & 255),
  "a million nested groups": () => svg("<g>".repeat(1e6) + "</g>".repeat(1e6)),
  "a bomb of uses": useBomb,
  "a bomb of entities": entityBomb,
  "a page without area": () => svg('<path d="M0 0h10"/>', "0 0 0 0"),
  "50 MB": () => svg('<path d="M0 0h10v10z" stroke="#000"/>'.repeat(1.3e6)),
};

describe("files that are no drawings", () => {
  const session = useSession("chromium", { hasGpu: true });
  const folder = makeFolder();

  for (const [name, content] of Object.entries(BAD_FILES)) {
    test(name, async () => {
      const file = await folder.write("bad.svg", content());
      const editor = await session.open("webgpu");
      await editor.openDrawing("rooms");
      await editor.scribble([[30, 30], [70, 60]], 200);
      const untouched = await editor.picture();

      await editor.tab.chooseFiles([file]);
      await editor.tab.waitFor(`!document.getElementById("alert").hidden`);
      assert.match(await editor.message(), /\S+ \S+/);
      await editor.click("Dismiss");
      assert.ok((await editor.picture()).equals(untouched));
      await editor.until("Undone", () => editor.click("Undo"));
      assert.deepEqual(editor.tab.faults, []);
    });
  }
});
