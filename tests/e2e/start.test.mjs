// What is seen before the editor's module is there: the whole toolbar, as it stays.
import assert from "node:assert/strict";
import { test } from "node:test";
import { useSession } from "./harness.mjs";
import { Picture } from "./picture.mjs";

/** Each module waits, once it is asked for, until `release` is called. */
const HOLD_MODULES = `{
  const { fetch } = window;
  window.asked = 0;
  const released = new Promise((release) => (window.release = release));
  window.fetch = async (input, ...options) => {
    if (String(input.url ?? input).endsWith(".wasm")) {
      window.asked += 1;
      await released;
    }
    return fetch(input, ...options);
  };
}`;

const session = useSession("chromium", { hasGpu: true });

test("the toolbar is painted before the module is loaded", async () => {
  const tab = await session.newTab();
  await tab.prepare(HOLD_MODULES);
  await tab.goto(session.url);
  await tab.waitFor("window.asked > 0");
  const shot = async () => Picture.decode(Buffer.from(await tab.screenshot({ x: 0, y: 0, width: 1200, height: 40 })));
  const early = await shot();
  const painted = await tab.evaluate(`performance.getEntriesByName("first-contentful-paint").length`);
  assert.equal(painted, 1);
  assert.equal(await tab.evaluate(`document.getElementById("status").textContent`), "");
  const unnamed = await tab.evaluate(`
    [...document.querySelectorAll("header button, aside button")].filter((button) => !button.ariaLabel && !button.textContent).length`);
  assert.equal(unnamed, 0);
  assert.ok(early.colors([0, 0], [1199, 39]).length > 50, "icons and words");

  await tab.evaluate("window.release()");
  await tab.waitFor(`document.getElementById("status").textContent !== ""`);
  // What comes after it depends on the drawing.
  const undo = await tab.evaluate(`document.querySelector('[data-action="undo"]').getBoundingClientRect().left`);
  const files = { width: Math.floor(undo), height: 40 };
  assert.ok(early.part(0, 0, files).equals((await shot()).part(0, 0, files)));
  assert.deepEqual(tab.faults, []);
});
