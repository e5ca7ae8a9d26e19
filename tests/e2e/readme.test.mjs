// The picture at the top of the README: a sample of the page, coloured by hand. `cargo xtask picture` writes it anew.
import assert from "node:assert/strict";
import { writeFile } from "node:fs/promises";
import { test } from "node:test";
import { useSession } from "./harness.mjs";
import { hex } from "./picture.mjs";

/** The longer side of the goldfish's viewBox. */
const GOLDFISH = 400;

/** Swatches and the ways of the pen with each, in units of the viewBox. @type {[string, ...[number, number][][]][]} */
const SCRIBBLES = [
  ["Teal", [[20, 135], [60, 150], [78, 146]], [[300, 236], [385, 230]], [[95, 220], [150, 236]]],
  ["Blue", [[20, 15], [200, 12], [380, 20]]],
  ["Peach", [[30, 291], [200, 293], [370, 291]]],
  ["Orange", [[106, 161], [118, 180], [135, 195]], [[175, 192], [245, 187]]],
  ["Red", [[172, 114], [232, 121]], [[310, 155], [345, 120]], [[308, 158], [345, 195]]],
  ["Yellow", [[176, 168], [205, 174]], [[178, 84], [215, 70]], [[178, 214], [188, 236]], [[242, 202], [252, 214]]],
  ["Green", [[35, 265], [30, 226], [38, 194]], [[61, 264], [69, 232]]],
  ["Green", [[322, 264], [316, 236]], [[345, 264], [350, 246]]],
  ["Slate", [[110, 268], [136, 270]], [[158, 272], [168, 272]], [[114, 143], [117, 143]]],
  ["Pink", [[258, 262], [268, 268]]],
  ["White", [[116, 151], [121, 151]]],
];

/** Places in closed shapes, and what colours them. @type {[[number, number], string][]} */
const COLORED = [
  [[125, 272], "#60646c"],
  [[200, 172], "#f7c948"],
  [[120, 152], "#ffffff"],
];

const session = useSession("chromium", { hasGpu: true });

test("a sample can be coloured with the palette", async () => {
  const editor = await session.open("webgpu");
  await editor.openSample("Goldfish");
  for (let i = 0; i < 5; i++) await editor.tab.press("[");
  for (const [color, ...ways] of SCRIBBLES) {
    await editor.click(color);
    for (const way of ways) await editor.scribble(way, GOLDFISH);
  }
  await editor.picture();
  if (process.env.PICTURE) await writeFile(process.env.PICTURE, await editor.tab.screenshot());

  await editor.toggle("Show scribbles");
  const places = await editor.place(COLORED.map(([place]) => place), GOLDFISH);
  const picture = await editor.picture();
  assert.deepEqual(places.map(([x, y]) => hex(picture.at(x, y))), COLORED.map(([, color]) => color));
  assert.deepEqual(editor.tab.faults, []);
});
