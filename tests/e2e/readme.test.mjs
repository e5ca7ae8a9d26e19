// The picture at the top of the README: a sample of the page, coloured by hand. `cargo xtask picture` writes it anew.
import assert from "node:assert/strict";
import { writeFile } from "node:fs/promises";
import { after, before, test } from "node:test";
import { start } from "./harness.mjs";
import { hex } from "./picture.mjs";

/** The longer side of the goldfish's viewBox. */
const GOLDFISH = 400;

/** Swatches and the ways of the pen, in the units of the drawing. @type {[string, [number, number][]][]} */
const SCRIBBLES = [
  ["Teal", [[40, 60], [60, 110], [90, 230], [200, 40], [340, 60], [385, 150], [300, 250]]],
  ["Orange", [[170, 190], [230, 190], [265, 170]]],
  ["Yellow", [[180, 120], [230, 115]]],
];

/** @type {Awaited<ReturnType<typeof start>>} */
let session;
before(async () => {
  session = await start("chromium");
});
after(() => session.close());

test("a sample can be coloured with the palette", async () => {
  const editor = await session.open("webgpu");
  await editor.openSample("Goldfish");
  for (const [color, way] of SCRIBBLES) {
    await editor.click(color);
    await editor.scribble(way, GOLDFISH);
  }
  const picture = await editor.picture();
  assert.deepEqual(editor.tab.faults, []);
  if (process.env.PICTURE) await writeFile(process.env.PICTURE, await editor.tab.screenshot());
});
