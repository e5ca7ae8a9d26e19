// Two tabs with the same drawing: neither writes over what the other has done, with the browser's locks or without.
import assert from "node:assert/strict";
import { describe, test } from "node:test";
import { Editor, useSession } from "./harness.mjs";

/** The longer side of the viewBox of the drawing. */
const ROOMS = 200;
const IN_LEFT_ROOM = /** @type {[number, number][]} */ ([[30, 30], [50, 60], [70, 40]]);
/** Edits of both tabs together; EDITS=1000 in the environment asks for more than is usual. */
const EDITS = Number(process.env.EDITS ?? 100);

/** Clicks of a pen all over the canvas, each kept before the next: timers would be slowed in a tab that is not in front. */
const clicks = (/** @type {number} */ count) => `(async () => {
  const canvas = document.getElementById("canvas");
  const { x, y, width, height } = canvas.getBoundingClientRect();
  canvas.parentElement.setPointerCapture = () => {};
  const breath = () => new Promise((wake) => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = wake;
    port2.postMessage(0);
  });
  for (let i = 0; i < ${count}; i++) {
    const place = { clientX: x + width * (0.3 + 0.4 * ((i * 0.618) % 1)), clientY: y + height * (0.4 + 0.2 * ((i * 0.414) % 1)) };
    for (const kind of ["pointerdown", "pointerup"]) {
      canvas.dispatchEvent(new PointerEvent(kind, { ...place, pointerId: 7, bubbles: true, cancelable: true }));
    }
    while (document.getElementById("drawing").dataset.kept !== "true") await breath();
  }
})()`;

for (const browser of /** @type {const} */ (["chromium", "firefox"])) {
  describe(`two tabs of ${browser}`, () => {
    const session = useSession(browser);

    /** @param {string} script that runs before the page's own */
    const twoTabs = async (script) => {
      const tab = await session.newTab();
      await tab.prepare(script);
      const one = await session.reopen(tab);
      await one.openDrawing("rooms");
      await one.scribble(IN_LEFT_ROOM, ROOMS);
      await one.kept();
      const other = await tab.beside();
      await other.prepare(script);
      return [one, await session.reopen(other)];
    };

    /**
     * What the storage has, told by a tab that comes after those.
     * @param {Editor[]} editors
     */
    const counts = async (editors) => {
      const tab = await editors[0].tab.beside();
      for (const editor of editors) await editor.tab.close();
      const last = await session.reopen(tab);
      /** @type {Record<string, number>} */
      const found = {};
      for (const name of ["rooms.svg", "Copy of rooms.svg"]) {
        await last.click("Recent drawings");
        await last.tab.waitFor(`document.getElementById("recent")?.open`);
        await last.click(`Open ${name}`);
        await last.tab.waitFor(`document.getElementById("drawing").textContent === ${JSON.stringify(name)}`);
        await last.scribble(IN_LEFT_ROOM, ROOMS);
        found[name] = Number(/added, (\d+) in/.exec(await last.status())?.[1]) - 1;
      }
      return found;
    };

    test("the later one works on a copy, and says so; nothing of either is lost", async () => {
      const [one, other] = await twoTabs("");
      assert.match(await other.status(), /Opened Copy of rooms.svg: another tab has the drawing itself/);
      assert.equal(await other.name(), "Copy of rooms.svg");
      const edits = EDITS / 2;
      await Promise.all([one, other].map((editor) => editor.tab.evaluate(clicks(edits))));
      assert.deepEqual([await one.name(), await other.name()], ["rooms.svg", "Copy of rooms.svg"]);
      assert.deepEqual([...one.tab.faults, ...other.tab.faults], []);
      assert.deepEqual(await counts([one, other]), { "rooms.svg": edits + 1, "Copy of rooms.svg": edits + 1 });
    });

    /** @param {Editor} editor */
    const list = async (editor) => {
      await editor.click("Recent drawings");
      await editor.tab.waitFor(`document.getElementById("recent")?.open`);
    };

    /** A tab comes to nothing with a drawing that it does not show; another one opens it then. @param {(one: Editor) => Promise<void>} fail */
    const leftToOthers = async (fail) => {
      const one = await session.open("cpu");
      await one.openDrawing("rooms");
      await one.scribble(IN_LEFT_ROOM, ROOMS);
      await one.kept();
      await one.openSample("Apple");
      await one.scribble([[30, 40], [40, 45]], 72);
      await one.kept();
      await session.reopen(one.tab);
      await list(one);
      await fail(one);
      const other = await session.reopen(await one.tab.beside());
      await list(other);
      await other.until("Opened rooms.svg", () => other.click("Open rooms.svg"));
      assert.equal(await other.name(), "rooms.svg");
      assert.deepEqual([...one.tab.faults, ...other.tab.faults], []);
    };

    test("a tab that cancels the opening of a drawing leaves it to others", () =>
      leftToOthers(async (one) => {
        // The drawing waits to be made ready.
        await one.tab.evaluate(`{
          const { setTimeout } = window;
          window.setTimeout = (act, ms) => (ms === undefined ? (window.held = act) : setTimeout(act, ms));
        }`);
        await one.click("Open rooms.svg");
        await one.tab.waitFor(`window.held && !document.getElementById("busy").hidden`);
        await one.until("Opening cancelled", () => one.click("Cancel"));
        await one.tab.evaluate(`window.held()`);
      }));

    test("so does one that cannot delete it", () =>
      leftToOthers(async (one) => {
        await one.tab.evaluate(`{
          window.confirm = () => true;
          IDBObjectStore.prototype.delete = () => { throw new Error("it is kept"); };
        }`);
        await one.click("Delete rooms.svg");
        await one.tab.waitFor(`[...document.querySelectorAll("#recent small")].some((note) => note.textContent.startsWith("It could not"))`);
      }));

    test("without locks the one that opened it last has it; the other goes on as a copy, and says so", async () => {
      const [one, other] = await twoTabs(`Object.defineProperty(Navigator.prototype, "locks", { value: undefined })`);
      assert.equal(await other.name(), "rooms.svg");
      await other.scribble(IN_LEFT_ROOM, ROOMS);
      await other.kept();
      await one.tab.evaluate(clicks(1));
      assert.match(await one.status(), /Another tab has rooms.svg; this one goes on as Copy of rooms.svg/);
      assert.deepEqual([await other.name(), await one.name()], ["rooms.svg", "Copy of rooms.svg"]);
      await Promise.all([one, other].map((editor) => editor.tab.evaluate(clicks(EDITS / 10))));
      assert.deepEqual([...one.tab.faults, ...other.tab.faults], []);
      assert.deepEqual(await counts([one, other]), { "rooms.svg": EDITS / 10 + 2, "Copy of rooms.svg": EDITS / 10 + 2 });
    });
  });
}
