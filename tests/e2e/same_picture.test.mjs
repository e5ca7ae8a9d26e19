// The three renderers show the same picture.
import { before, describe, test } from "node:test";
import { start, useSession } from "./harness.mjs";
import { assertSame } from "./picture.mjs";

/** The longer side of the viewBox of `drawings/shading.svg`. */
const SHADING = 200;
const SCRIBBLES = /** @type {[string, [number, number][]][]} */ ([
  ["Yellow", [[35, 45], [60, 30], [90, 28]]],
  ["Violet", [[40, 70], [80, 82], [110, 76]]],
  ["Teal", [[150, 20], [185, 40], [180, 80]]],
  ["Red", [[120, 45], [126, 52]]],
]);

/**
 * @param {Awaited<ReturnType<typeof start>>} session
 * @param {import("./harness.mjs").Target["renderer"]} renderer
 */
async function shaded(session, renderer) {
  const editor = await session.open(renderer);
  await editor.openDrawing("shading");
  for (const [color, points] of SCRIBBLES) {
    await editor.click(color);
    await editor.scribble(points, SHADING);
  }
  const straight = await editor.picture();
  // In the mirror and aslant it is as sharp.
  await editor.until("Mirrored", () => editor.tab.press("m"));
  await editor.until("Rotated by 15°", () => editor.tab.hold("Shift", () => editor.tab.press("6")));
  return [straight, await editor.picture()];
}

describe("the same picture from every renderer", () => {
  const session = useSession("chromium", { hasGpu: true });
  /** @type {import("./picture.mjs").Picture[]} */
  let expected;
  before(async () => {
    expected = await shaded(session, "cpu");
  });

  for (const renderer of /** @type {const} */ (["webgpu", "webgl"])) {
    test(renderer, async () => {
      const pictures = await shaded(session, renderer);
      pictures.forEach((picture, i) => assertSame(picture, expected[i]));
    });
  }
});
