// The solver of the picture on the canvas: both make the same one, and the page says where it takes the other.
import assert from "node:assert/strict";
import { describe, test } from "node:test";
import { useSession } from "./harness.mjs";
import { distance, hex } from "./picture.mjs";

/** @typedef {[number, number]} Point */
/** @typedef {import("./harness.mjs").Editor} Editor */
/** @typedef {import("./picture.mjs").Picture} Picture */

/** The longer side of the viewBox of the drawings here. */
const SIDE = 200;
const SHADED = /** @type {[string, Point[]][]} */ ([
  ["Yellow", [[35, 45], [60, 30], [90, 28]]],
  ["Violet", [[40, 70], [80, 82], [110, 76]]],
  ["Teal", [[150, 20], [185, 40], [180, 80]]],
  ["Red", [[120, 45], [126, 52]]],
]);
const IN_LEFT_ROOM = /** @type {Point[]} */ ([[30, 30], [50, 60], [70, 40]]);
/** A place in the left room, and one in the wall's other side. */
const ROOMS = /** @type {Point[]} */ ([[20, 80], [180, 80]]);

/** So far that another part of the page is solved. */
const ASIDE = /** @type {Point[]} */ ([[400, 300], [250, 200], [100, 100]]);

/**
 * How far solvers are apart where there is no edge: in the mean, and in most pixels, in levels. Without a graphics card a
 * pixel of the grid is some four of the canvas wide, from close by eight.
 */
const MEAN_LEVELS = 1;
const MOST_LEVELS = 3;
const MOST_PART = 0.95;

/** A small disc in the middle of the page. */
const DISC = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 200 200"><circle cx="100" cy="100" r="1" fill="none" stroke="#000" stroke-width=".05"/></svg>`;

/** @param {Editor} editor */
async function shade(editor) {
  await editor.openDrawing("shading");
  for (const [color, points] of SHADED) {
    await editor.click(color);
    await editor.scribble(points, SIDE);
  }
}

/**
 * @param {Picture} actual
 * @param {Picture} expected
 */
function assertAlike(actual, expected) {
  assert.deepEqual([actual.width, actual.height], [expected.width, expected.height]);
  let [count, sum, far] = [0, 0, 0];
  for (let y = 0; y < expected.height; y++) {
    for (let x = 0; x < expected.width; x++) {
      if (expected.isEdge(x, y) || actual.isEdge(x, y)) continue;
      const levels = distance(actual.at(x, y), expected.at(x, y));
      [count, sum, far] = [count + 1, sum + levels, far + (levels > MOST_LEVELS ? 1 : 0)];
    }
  }
  assert.ok(count > 0.8 * expected.width * expected.height, `only ${count} pixels are on no edge`);
  assert.ok(sum < MEAN_LEVELS * count, `${sum / count} levels in the mean`);
  assert.ok(far < (1 - MOST_PART) * count, `${far} of ${count} pixels differ by more than ${MOST_LEVELS} levels`);
}

describe("the solver", () => {
  const session = useSession("chromium", { hasGpu: true });
  /** @type {Editor} */
  let editor;

  /**
   * A test with a page that is closed after it: what draws without a graphics card draws for one at a time.
   * @param {string} name
   * @param {import("./harness.mjs").Target["renderer"]} renderer
   * @param {string} more of the address
   * @param {() => Promise<void>} act
   */
  const testPage = (name, renderer, more, act) =>
    test(`${renderer}: ${name}`, async () => {
      editor = await session.open(renderer, more);
      await act();
      assert.deepEqual(editor.tab.faults, []);
      await editor.tab.close();
    });

  const asked = () => editor.tab.evaluate(`document.querySelector('[data-setting="solver"]').value`);

  for (const renderer of /** @type {const} */ (["webgpu", "webgl"])) {
    testPage("both make the same picture", renderer, "", async () => {
      await shade(editor);
      await editor.shows("mesh");
      const mesh = await editor.picture();
      await editor.choose("Solver", "gpu");
      await editor.shows("gpu");
      const grid = await editor.picture();
      assert.ok(!grid.equals(mesh), "the canvas shows the picture of the other solver");
      assertAlike(grid, mesh);
      await editor.choose("Solver", "mesh");
      await editor.shows("mesh");
      assert.ok((await editor.picture()).equals(mesh));
    });

    testPage("both make the same picture from close by, also after a pan", renderer, "", async () => {
      await shade(editor);
      for (let steps = 0; steps < 6; steps++) await editor.click("Zoom in");
      await editor.tab.press("h");
      await editor.shows("mesh");
      const mesh = await editor.picture();
      await editor.drag(ASIDE);
      const aside = await editor.picture();
      await editor.choose("Solver", "gpu");
      await editor.shows("gpu");
      const grid = await editor.picture();
      assertAlike(grid, aside);
      await editor.drag([...ASIDE].reverse());
      assertAlike(await editor.picture(), mesh);
      await editor.drag(ASIDE);
      assert.ok((await editor.picture()).equals(grid), "the same part, the same picture");
    });

    testPage("both have round curves from as close as can be", renderer, "", async () => {
      await editor.until("Opened disc.svg", () => editor.drop(DISC, "disc.svg"));
      await editor.click("Red");
      await editor.scribble([[40, 60], [60, 60]], SIDE);
      await editor.click("White");
      await editor.scribble([[99.8, 100], [100.2, 100]], SIDE);
      await editor.toggle("Show scribbles");
      await editor.toggle("Show lines");
      const [[x, y]] = await editor.place([[100, 100]], SIDE);
      await editor.tab.evaluate(`{
        const canvas = document.getElementById("canvas");
        const { left, top } = canvas.getBoundingClientRect();
        const wheel = { deltaY: -100, ctrlKey: true, clientX: left + ${x}, clientY: top + ${y}, bubbles: true };
        for (let steps = 0; steps < 40; steps++) canvas.dispatchEvent(new WheelEvent("wheel", wheel));
      }`);
      await editor.tab.waitFor(`document.getElementById("canvas").dataset.view.startsWith("64 ")`);
      await editor.shows("mesh");
      const mesh = await editor.picture();
      await editor.choose("Solver", "gpu");
      await editor.shows("gpu");
      const grid = await editor.picture();
      let [inside, far] = [0, 0];
      for (let y = 0; y < mesh.height; y++) {
        for (let x = 0; x < mesh.width; x++) {
          inside += Number(hex(mesh.at(x, y)) === "#ffffff");
          far += Number(distance(mesh.at(x, y), grid.at(x, y)) > 64);
        }
      }
      assert.ok(inside > 100_000 && far < 20, `${far} pixels differ, of ${inside} in the disc`);
    });

    testPage("GPU colours exactly as picked, and undo takes it back", renderer, "", async () => {
      await editor.openDrawing("rooms");
      await editor.choose("Solver", "gpu");
      await editor.toggle("Show scribbles");
      const empty = await editor.picture();
      await editor.click("Red");
      await editor.scribble(IN_LEFT_ROOM, SIDE);
      await editor.shows("gpu");
      const [places, picture] = [await editor.place(ROOMS, SIDE), await editor.picture()];
      assert.deepEqual(places.map(([x, y]) => hex(picture.at(x, y))), ["#e5484d", "#ffffff"]);
      await editor.until("Undone", () => editor.click("Undo"));
      assert.ok((await editor.picture()).equals(empty));
    });
  }

  for (const [name, expected] of [["mesh", "mesh"], ["gpu", "gpu"], ["automatic", "automatic"], ["other", "automatic"]]) {
    testPage(`the address names ${name}: ${expected}`, "cpu", `&solver=${name}`, async () => {
      assert.equal(await asked(), expected);
    });
  }

  testPage("Automatic leaves a graphics card that is none to the canvas", "webgl", "", async () => {
    assert.equal(await asked(), "automatic");
    await editor.openDrawing("shading");
    await editor.shows("mesh");
  });

  testPage("GPU without a GPU: the mesh solver, and the page says so", "cpu", "", async () => {
    await shade(editor);
    const mesh = await editor.picture();
    await editor.until("has no GPU solver", () => editor.choose("Solver", "gpu"));
    await editor.shows("without-gpu");
    assert.ok((await editor.picture()).equals(mesh));
  });
});
