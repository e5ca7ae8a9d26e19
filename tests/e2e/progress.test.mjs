// What takes long is seen to go on, and can be cancelled: opening, other settings and lines, and the writing of files.
import assert from "node:assert/strict";
import { describe, test } from "node:test";
import { PAINTED } from "./browsers.mjs";
import { useSession } from "./harness.mjs";

/** @typedef {import("./harness.mjs").Editor} Editor */

/** What workers are asked waits for ever. */
const HOLD_WORKERS = `Worker.prototype.postMessage = () => {};`;

/** What waits for so long waits for ever. @param {number | undefined} ms */
const hold = (ms) => `{
  const { setTimeout } = window;
  window.setTimeout = (act, delay_ms, ...more) => delay_ms === ${ms} ? (window.held = act) : setTimeout(act, delay_ms, ...more);
}`;

/** Where the page lets others go on, and where it shows that something will take long; the latter as in `busy.js`. */
const [HOLD_SLICES, HOLD_PAINTED] = [hold(undefined), hold(32)];
/** And where the picture for the list is made; as in `keeper.js`. */
const HOLD_REST = hold(1000);

/** Frames of the page's own scripts come when `window.go` is called. */
const HOLD_FRAMES = `{
  const { requestAnimationFrame } = window;
  const held = [];
  window.requestAnimationFrame = (act) => (new Error().stack.includes("/web/main.js") ? held.push(act) : requestAnimationFrame(act));
  window.go = () => requestAnimationFrame((now) => held.splice(0).forEach((act) => act(now)));
  window.goOn = () => {
    window.requestAnimationFrame = requestAnimationFrame;
    window.go();
  };
}`;

/** Whoever presses Cancel just as it goes does not draw. */
const PRESS_LATE = `{
  const cancel = document.querySelector("#busy button").getBoundingClientRect();
  const [clientX, clientY] = [cancel.x + cancel.width / 2, cancel.y + cancel.height / 2];
  const press = (kind) => document.getElementById("canvas").dispatchEvent(
    new PointerEvent(kind, { clientX, clientY, pointerId: 1, button: 0, buttons: 1, isPrimary: true, bubbles: true }));
  new MutationObserver((_, observer) => {
    observer.disconnect();
    window.pressed = true;
    press("pointerdown");
    press("pointerup");
  }).observe(document.getElementById("busy"), { attributes: true });
}`;

/** So many lines take longer than a slice. */
const MANY = 3000;

/** A drawing of so many lines. @param {number} count */
const lines = (count) => {
  const line = (/** @type {unknown} */ _, /** @type {number} */ i) => `<path stroke="black" d="M${(i % 80) * 12} ${Math.floor(i / 80) * 12}l9 7"/>`;
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 1000 1000">${Array.from({ length: count }, line).join("")}</svg>`;
};

/** So many lines across, and as many down. @param {number} count */
const mesh = (count) => {
  const line = (/** @type {unknown} */ _, /** @type {number} */ i) => `M${i} 0V${count}M0 ${i}H${count}`;
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${count} ${count}"><path stroke="black" d="${Array.from({ length: count }, line).join("")}"/></svg>`;
};

const SVG = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9"><path stroke="black" d="M1 1l5 5"/></svg>`;

const IS_SEEN = `!document.getElementById("busy").hidden`;
const CANCELLED = "Opening cancelled; everything is as it was";

/** Waits until the browser has one drawing alone. */
const KEEPS_ONE = `new Promise((done) => {
  indexedDB.open("scumble").onsuccess = ({ target: { result: database } }) => {
    const look = () => {
      database.transaction("entries").objectStore("entries").count().onsuccess = ({ target: { result: count } }) => {
        if (count > 1) return setTimeout(look, 20);
        database.close();
        done();
      };
    };
    look();
  };
})`;

for (const browser of /** @type {const} */ (["chromium", "firefox"])) {
  describe(`progress in ${browser}`, () => {
    const session = useSession(browser);

    const scribbled = async () => {
      const editor = await session.open("cpu");
      await editor.openDrawing("rooms");
      await editor.scribble([[30, 30], [50, 60]], 200);
      return editor;
    };

    /** Cancels what is on its way: all stays as it is, and goes on. @param {Editor} editor */
    const cancelled = async (editor) => {
      await editor.until(CANCELLED, () => editor.click("Cancel"));
      assert.equal(await editor.tab.evaluate(IS_SEEN), false);
      assert.equal(await editor.tab.evaluate(`document.activeElement.id`), "canvas");
      await editor.until("2 in the drawing", () => editor.scribble([[120, 30], [140, 60]], 200));
      assert.equal(await editor.message(), "");
      assert.deepEqual(editor.tab.faults, []);
    };

    test("a file that is being read", async () => {
      const editor = await scribbled();
      await editor.tab.evaluate(`window.ask = Worker.prototype.postMessage; ${HOLD_WORKERS}`);
      await editor.drop(SVG, "large.svg");
      await editor.tab.waitFor(IS_SEEN);
      assert.equal(await editor.tab.evaluate(`document.querySelector("#busy p").textContent`), "Opening large.svg …");
      await cancelled(editor);
      await editor.tab.evaluate(`Worker.prototype.postMessage = window.ask`);
      await editor.until("Opened large.svg", () => editor.drop(SVG, "large.svg"));
    });

    test("a large drawing that is being made ready", async () => {
      const editor = await scribbled();
      await editor.tab.evaluate(HOLD_SLICES);
      await editor.drop(lines(MANY), "many.svg");
      await editor.tab.waitFor(`window.held && ${IS_SEEN}`);
      await editor.until("2 in the drawing", () => editor.scribble([[120, 30], [140, 60]], 200));
      await editor.click("Undo");
      await editor.until(CANCELLED, async () => {
        await editor.click("Cancel");
        await editor.tab.evaluate(`window.held()`);
      });
      await editor.until("Redo", () => editor.click("Redo"));
      assert.equal(await editor.name(), "rooms.svg");
      assert.deepEqual(editor.tab.faults, []);
    });

    test("a large drawing, as soon as that is seen", async () => {
      const editor = await scribbled();
      await editor.tab.evaluate(HOLD_PAINTED);
      await editor.drop(lines(2 * MANY), "many.svg");
      await editor.tab.waitFor(`window.held && ${IS_SEEN}`);
      await editor.until(CANCELLED, () => editor.click("Cancel"));
      await editor.tab.evaluate(`window.held()`);
      await editor.until("2 in the drawing", () => editor.scribble([[120, 30], [140, 60]], 200));
      assert.equal(await editor.name(), "rooms.svg");
      assert.deepEqual(editor.tab.faults, []);
    });

    test("the picture of a large drawing, whose lines are there already", async () => {
      const editor = await scribbled();
      await editor.tab.evaluate(HOLD_FRAMES);
      await editor.until("Opened many.svg", () => editor.drop(lines(2 * MANY), "many.svg"));
      await editor.tab.waitFor(`${IS_SEEN} && document.querySelector("#busy p").textContent === "Making the picture …"`);
      await editor.until("1 in the drawing", () => editor.scribble([[120, 30], [140, 60]], 1000));
      await editor.until("Cancelled; the drawing is as it was before", () => editor.click("Cancel"));
      assert.equal(await editor.name(), "rooms.svg");
      assert.equal(await editor.tab.evaluate(`document.activeElement.id`), "canvas");
      await editor.until("Redo", () => editor.click("Redo"));
      assert.equal(await editor.name(), "many.svg");
      await editor.kept();
      await editor.tab.evaluate(`window.goOn()`);
      await editor.tab.waitFor(`!(${IS_SEEN})`);
      await editor.until("2 in the drawing", () => editor.scribble([[120, 130], [140, 160]], 1000));
      assert.deepEqual(editor.tab.faults, []);
    });

    test("a large drawing is kept at once, and no longer once it is cancelled", async () => {
      const editor = await scribbled();
      await editor.kept();
      await editor.tab.evaluate(HOLD_FRAMES);
      await editor.until("Opened many.svg", () => editor.drop(lines(2 * MANY), "many.svg"));
      await editor.kept();
      await editor.until("Cancelled; the drawing is as it was before", () => editor.click("Cancel"));
      await editor.tab.evaluate(KEEPS_ONE);
      await session.reopen(editor.tab);
      assert.equal(await editor.name(), "rooms.svg");
      await editor.tab.evaluate(HOLD_FRAMES);
      await editor.until("Opened again.svg", () => editor.drop(lines(2 * MANY), "again.svg"));
      await editor.kept();
      await session.reopen(editor.tab);
      assert.equal(await editor.name(), "again.svg");
      await editor.click("Recent drawings");
      await editor.tab.waitFor(`document.getElementById("recent")?.open`);
      const kept = await editor.tab.evaluate(`[...document.querySelectorAll("#recent li span")].map((name) => name.textContent)`);
      assert.deepEqual(kept, ["again.svg", "rooms.svg"]);
      assert.deepEqual(editor.tab.faults, []);
    });

    test("a large drawing that was scribbled on is listed, without the picture of another", async () => {
      const editor = await session.open("cpu");
      await editor.openSample("Apple");
      await editor.tab.evaluate(HOLD_FRAMES);
      await editor.tab.evaluate(HOLD_REST);
      await editor.until("Opened many.svg", () => editor.drop(lines(2 * MANY), "many.svg"));
      await editor.drag([[300, 300], [340, 320]]);
      await editor.kept();
      await editor.until("Cancelled; the drawing is as it was before", () => editor.click("Cancel"));
      await editor.tab.evaluate(`goOn(), held(), ${PAINTED}`);
      await editor.click("Recent drawings");
      await editor.tab.waitFor(`document.getElementById("recent")?.open`);
      assert.equal(await editor.tab.evaluate(`document.querySelectorAll("#recent li").length`), 1);
      assert.equal(await editor.tab.evaluate(`document.querySelectorAll('#recent img[src^="blob:"]').length`), 0);
      assert.deepEqual(editor.tab.faults, []);
    });

    test("a drawing whose lines are shown before it turns out to have too many pieces", async () => {
      const editor = await scribbled();
      await editor.drop(mesh(2700), "mesh.svg");
      await editor.tab.waitFor(`!document.getElementById("alert").hidden`);
      assert.equal(
        await editor.message(),
        "The drawing has more than 1,000,000 pieces of line, or too many on one spot; simplify it or split it.",
      );
      assert.deepEqual([await editor.status(), await editor.name()], ["mesh.svg has been closed again", "rooms.svg"]);
      assert.equal(await editor.tab.evaluate(IS_SEEN), false);
      await editor.until("2 in the drawing", () => editor.scribble([[120, 30], [140, 60]], 200));
      assert.deepEqual(editor.tab.faults, []);
    });

    test("the picture of the drawing that the page starts with", async () => {
      const editor = await session.open("cpu");
      await editor.until("Opened many.svg", () => editor.drop(lines(2 * MANY), "many.svg"));
      await editor.kept();
      await editor.tab.prepare(HOLD_FRAMES);
      await editor.tab.goto(`${session.url}?renderer=cpu`);
      await editor.tab.waitFor(`${IS_SEEN} && document.querySelector("#busy p").textContent === "Making the picture …"`);
      assert.equal(await editor.name(), "many.svg");
      await editor.until("Pick a colour", () => editor.click("Cancel"));
      assert.equal(await editor.name(), "Goldfish");
      assert.equal(await editor.tab.evaluate(IS_SEEN), false);
      assert.deepEqual(editor.tab.faults, []);
    });

    test("a picture with other settings", async () => {
      const editor = await session.open("cpu");
      await editor.until("Opened many.svg", () => editor.drop(lines(MANY), "many.svg"));
      await editor.until("1 in the drawing", () => editor.scribble([[120, 30], [140, 60]], 200));
      const isChecked = () => editor.tab.evaluate(`document.querySelector("[data-setting=spread]").checked`);
      await editor.tab.evaluate(HOLD_FRAMES);
      await editor.toggle("Spread");
      await editor.tab.evaluate(`window.go()`);
      await editor.tab.waitFor(IS_SEEN);
      assert.equal(await isChecked(), true);
      await editor.until("Cancelled; the drawing is as it was before", () => editor.click("Cancel"));
      assert.deepEqual([await isChecked(), await editor.tab.evaluate(IS_SEEN)], [false, false]);
      assert.equal(await editor.tab.evaluate(`document.activeElement.id`), "canvas");
      await editor.until("Redo", () => editor.click("Redo"));
      await editor.tab.evaluate(`window.go()`);
      await editor.tab.waitFor(IS_SEEN);
      await editor.tab.evaluate(PRESS_LATE);
      await editor.tab.evaluate(`window.goOn()`);
      await editor.tab.waitFor(`window.pressed`);
      await editor.until("2 in the drawing", () => editor.scribble([[120, 130], [140, 160]], 200));
      assert.equal(await isChecked(), true);
      assert.deepEqual(editor.tab.faults, []);
    });

    test("a link that is being read as the page starts", async () => {
      const tab = await session.newTab();
      await tab.prepare(HOLD_WORKERS);
      await tab.goto(`${session.url}?renderer=cpu#1.AAAA`);
      await tab.waitFor(IS_SEEN);
      await tab.click("button", "Cancel");
      await tab.waitFor(`document.getElementById("status").textContent.startsWith("Pick a colour")`);
      assert.equal(await tab.evaluate(`document.getElementById("drawing").textContent`), "Goldfish");
      assert.deepEqual(tab.faults, []);
    });

    test("a file whose picture is not made yet", async () => {
      const editor = await scribbled();
      await editor.tab.evaluate(HOLD_FRAMES);
      await editor.until("Opened many.svg", () => editor.drop(lines(2 * MANY), "many.svg"));
      await editor.click("Export");
      await editor.click("Save file");
      await editor.tab.waitFor(`!document.getElementById("export-progress").hidden`);
      assert.equal(await editor.tab.evaluate(`document.getElementById("export-share").hasAttribute("value")`), false);
      await editor.tab.evaluate(`document.querySelector("[data-action=cancel-export]").click()`);
      await editor.tab.waitFor(`document.getElementById("export-status").textContent === "Cancelled"`);
      await editor.tab.evaluate(`window.goOn()`);
      await editor.until("Exported", () => editor.click("Save file"));
      assert.deepEqual(editor.tab.faults, []);
    });

    for (const format of ["SVG", "PDF"]) {
      test(`${format}, while it is written`, async () => {
        const editor = await scribbled();
        await editor.click("Export");
        await editor.tab.click("radio", format);
        await editor.tab.evaluate(`window.ask = Worker.prototype.postMessage; ${HOLD_WORKERS}`);
        await editor.click("Save file");
        await editor.tab.waitFor(`document.getElementById("export-share").value === 0 && !document.getElementById("export-progress").hidden`);
        await editor.click("Cancel");
        await editor.tab.waitFor(`document.getElementById("export-status").textContent === "Cancelled"`);
        await editor.tab.evaluate(`Worker.prototype.postMessage = window.ask`);
        await editor.until("Exported", () => editor.click("Save file"));
        assert.deepEqual(editor.tab.faults, []);
      });
    }
  });
}
