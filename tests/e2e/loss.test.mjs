// A graphics device that is lost, in the middle of a stroke and of a solution, again and again: the picture comes back, and
// with the stroke in hand. LOSSES=20 in the environment asks for more losses than the usual few.
import assert from "node:assert/strict";
import { describe, test } from "node:test";
import { Editor, useSession } from "./harness.mjs";
import { assertSame } from "./picture.mjs";

/** @typedef {[number, number]} Point */

const LOSSES = Number(process.env.LOSSES ?? 3);

/** The longer side of the viewBox of `drawings/rooms.svg`. */
const ROOMS = 200;
const WAY = /** @type {Point[]} */ ([[30, 30], [50, 60], [70, 40]]);

/** The page's renderer is not asked for again after so many losses while nobody draws. */
const LOSSES_BORNE = 3;

/** Has no WebGL 2. */
const WITHOUT_WEBGL = `
  HTMLCanvasElement.prototype.getContext = function (kind, ...options) {
    return kind === "webgl2" ? null : given.call(this, kind, ...options);
  };`;

/** What is said of the renderers that come after one. */
const FOLLOWERS = { webgpu: ["draws with WebGL 2", "draws without it"], webgl: ["draws without it"] };

/** Keeps hold of the devices and contexts that the page is given. */
const WATCH = `
  window.devices = [];
  if (window.GPUAdapter) {
    const request = GPUAdapter.prototype.requestDevice;
    GPUAdapter.prototype.requestDevice = async function (...options) {
      const device = await request.apply(this, options);
      devices.push(() => device.destroy());
      return device;
    };
  }
  const given = HTMLCanvasElement.prototype.getContext;
  HTMLCanvasElement.prototype.getContext = function (kind, ...options) {
    const context = given.call(this, kind, ...options);
    if (kind === "webgl2") devices.push(() => context.getExtension("WEBGL_lose_context").loseContext());
    return context;
  };`;

for (const renderer of /** @type {const} */ (["webgpu", "webgl"])) {
  describe(`${renderer}, lost`, () => {
    const session = useSession("chromium", { hasGpu: true });

    /** @param {string} solver */
    const open = async (solver) => {
      const tab = await session.newTab();
      await tab.prepare(WATCH);
      const editor = await Editor.open(tab, `${session.url}?renderer=${renderer}`, renderer);
      await editor.openDrawing("rooms");
      await editor.choose("Solver", solver);
      await editor.shows(solver);
      await editor.click("Red");
      return editor;
    };

    /** Loses what paints, and waits until the page has told of it. @param {Editor} editor @param {string} words */
    const lose = (editor, words) => editor.until(words, () => editor.tab.evaluate("devices.at(-1)()"));

    for (const solver of ["mesh", "gpu"]) {
      test(`${LOSSES} times in the middle of a stroke, with the ${solver} solver: the same picture`, async () => {
        const editor = await open(solver);
        await editor.scribble(WAY, ROOMS);
        const expected = await editor.picture();
        await editor.until("Undone", () => editor.click("Undo"));

        const { x, y } = await editor.box();
        const [first, ...rest] = await editor.place(WAY, ROOMS);
        await editor.tab.mouse.move(x + first[0], y + first[1]);
        await editor.tab.mouse.down();
        for (let loss = 0; loss < LOSSES; loss++) {
          const [px, py] = rest[Math.min(loss, rest.length - 1)];
          await editor.tab.mouse.move(x + px, y + py);
          await lose(editor, "has been drawn again");
        }
        for (const [px, py] of rest.slice(LOSSES)) await editor.tab.mouse.move(x + px, y + py);
        await editor.until("Scribble added, 1", () => editor.tab.mouse.up());
        assert.ok((await editor.picture()).equals(expected));
        assert.deepEqual(editor.tab.faults, []);
        await editor.tab.close();
      });
    }

    test("while nobody draws: after some losses what comes next paints the same picture", async () => {
      const editor = await open("mesh");
      await editor.scribble(WAY, ROOMS);
      const expected = await editor.picture();
      for (const words of FOLLOWERS[renderer]) {
        for (let loss = 1; loss < LOSSES_BORNE; loss++) await lose(editor, "has been drawn again");
        await lose(editor, words);
        assertSame(await editor.picture(), expected);
        await editor.until("Undone", () => editor.click("Undo"));
        await editor.until("Scribble added, 1", () => editor.scribble(WAY, ROOMS));
        assertSame(await editor.picture(), expected);
      }
      assert.deepEqual(editor.tab.faults, []);
      await editor.tab.close();
    });
  });
}

describe("webgpu, lost where there is no WebGL 2", () => {
  const session = useSession("chromium", { hasGpu: true });

  test("in the middle of a stroke, with the gpu solver: the CPU goes on with it", async () => {
    const tab = await session.newTab();
    await tab.prepare(WATCH + WITHOUT_WEBGL);
    const editor = await Editor.open(tab, `${session.url}?renderer=webgpu`, "webgpu");
    await editor.openDrawing("rooms");
    await editor.choose("Solver", "gpu");
    await editor.shows("gpu");
    const { x, y } = await editor.box();
    const [first, ...rest] = (await editor.place(WAY, ROOMS)).map(([px, py]) => /** @type {const} */ ([x + px, y + py]));
    await tab.mouse.move(...first);
    await tab.mouse.down();
    for (let loss = 1; loss < LOSSES_BORNE; loss++) {
      await editor.until("has been drawn again", () => tab.evaluate("devices.at(-1)()"));
    }
    await editor.until("draws without it", () => tab.evaluate("devices.at(-1)()"));
    for (const place of rest) await tab.mouse.move(...place);
    await editor.until("Scribble added, 1", () => tab.mouse.up());
    await editor.shows("without-gpu");
    assert.deepEqual(tab.faults, []);
  });
});

