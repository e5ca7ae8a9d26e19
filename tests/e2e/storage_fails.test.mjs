// A storage that fails, in each of its ways: the page works all the same, says that nothing is kept, and offers a file.
import assert from "node:assert/strict";
import { describe, test } from "node:test";
import { useSession } from "./harness.mjs";

/** The longer side of the viewBox of the drawing. */
const ROOMS = 200;
const IN_LEFT_ROOM = /** @type {[number, number][]} */ ([[30, 30], [50, 60], [70, 40]]);

/** Waiting for a storage, and trying again, take no time here. */
const WITHOUT_PATIENCE = `{
  const { setTimeout } = window;
  window.setTimeout = (act, ms) => setTimeout(act, ms >= 5000 ? 300 : ms);
}`;

/** @typedef {import("./harness.mjs").Editor} Editor */

/** @param {Editor} editor @returns {Promise<boolean>} */
const isTold = (editor) => editor.tab.evaluate(`!document.getElementById("unkept").hidden`);

/** What is done to the storage before the page comes to it; it works again once `storageWorks` is set. */
const FAILURES = {
  "is not there": `{
    const { indexedDB } = window;
    Object.defineProperty(window, "indexedDB", { get: () => (window.storageWorks ? indexedDB : undefined) });
  }`,
  "is forbidden": `{
    const { open } = IDBFactory.prototype;
    IDBFactory.prototype.open = function (...args) {
      if (!window.storageWorks) throw new DOMException("", "SecurityError");
      return open.apply(this, args);
    };
    for (const area of ["localStorage", "sessionStorage"]) {
      const storage = window[area];
      const get = () => {
        if (window.storageWorks) return storage;
        throw new DOMException("", "SecurityError");
      };
      Object.defineProperty(window, area, { get });
    }
  }`,
  "cannot be opened": `{
    const { open } = IDBFactory.prototype;
    IDBFactory.prototype.open = function (...args) {
      if (window.storageWorks) return open.apply(this, args);
      const request = { error: new DOMException("", "UnknownError") };
      setTimeout(() => request.onerror());
      return request;
    };
  }`,
  "does not open": `{
    const { open } = IDBFactory.prototype;
    IDBFactory.prototype.open = function (...args) {
      return window.storageWorks ? open.apply(this, args) : {};
    };
  }`,
  "takes it back": `{
    const { put } = IDBObjectStore.prototype;
    IDBObjectStore.prototype.put = function (...args) {
      const request = put.apply(this, args);
      if (!window.storageWorks) this.transaction.abort();
      return request;
    };
  }`,
  "does not answer": `{
    const { transaction } = IDBDatabase.prototype;
    IDBDatabase.prototype.transaction = function (names, ...args) {
      // One that is never done keeps all after it waiting.
      const first = transaction.call(this, names, "readwrite");
      const store = first.objectStore(names[0]);
      const goOn = () => { if (!window.storageWorks) store.get("").onsuccess = goOn; };
      goOn();
      return transaction.call(this, names, ...args);
    };
  }`,
};

/** Those that are tried in Firefox, too. */
const IN_BOTH = ["is not there", "takes it back"];

for (const browser of /** @type {const} */ (["chromium", "firefox"])) {
  describe(`${browser}'s storage`, () => {
    const session = useSession(browser);

    /** @param {string} script that runs before the page's own */
    const scribbled = async (script) => {
      const tab = await session.newTab();
      await tab.prepare(WITHOUT_PATIENCE + script);
      const editor = await session.reopen(tab);
      assert.equal(await isTold(editor), false, "there is nothing to keep yet");
      await editor.openDrawing("rooms");
      await editor.scribble(IN_LEFT_ROOM, ROOMS);
      return editor;
    };

    /** @param {Editor} editor */
    const assertTold = async (editor) => {
      await editor.tab.waitFor(`!document.getElementById("unkept").hidden`);
      assert.match(await editor.tab.evaluate(`document.getElementById("unkept").textContent`), /cannot keep .*Save as a file/s);
      assert.equal(await editor.leaves(), false, "the page asks before it goes");
    };

    for (const [failure, script] of Object.entries(FAILURES)) {
      if (browser === "firefox" && !IN_BOTH.includes(failure)) continue;
      test(`that ${failure} is told of, and used once it works`, async () => {
        const editor = await scribbled(script);
        await assertTold(editor);
        assert.equal(await editor.message(), "");
        await editor.tab.evaluate("window.storageWorks = true");
        await editor.tab.waitFor(`document.getElementById("unkept").hidden`);
        await editor.kept();
        assert.equal(await editor.leaves(), true);
        assert.deepEqual(editor.tab.faults, []);
      });
    }

    test("that takes nothing more gives out what it has", async () => {
      const editor = await session.open("cpu");
      await editor.openDrawing("rooms");
      await editor.kept();
      await editor.tab.prepare(`${WITHOUT_PATIENCE}{
        const { put } = IDBObjectStore.prototype;
        IDBObjectStore.prototype.put = function (...args) {
          const request = put.apply(this, args);
          if (!window.storageWorks && this.name === "entries") this.transaction.abort();
          return request;
        };
      }`);
      await session.reopen(editor.tab);
      assert.equal(await editor.name(), "rooms.svg");
      assert.equal(await isTold(editor), false, "it is kept as it is");
      await editor.scribble(IN_LEFT_ROOM, ROOMS);
      await assertTold(editor);
      await editor.tab.evaluate("window.storageWorks = true");
      await editor.kept();
      await editor.tab.evaluate("window.storageWorks = false");
      await session.reopen(editor.tab);
      await editor.until("Scribble added, 2 in", () => editor.scribble(IN_LEFT_ROOM, ROOMS));
      assert.deepEqual(editor.tab.faults, []);
    });

    if (browser === "firefox") return;

    test("that is full is told of, and a file is there to have", async () => {
      const editor = await session.open("cpu");
      await editor.tab.limitStorage(1);
      await editor.openDrawing("rooms");
      await editor.scribble(IN_LEFT_ROOM, ROOMS);
      await assertTold(editor);
      assert.ok(await editor.tab.download(() => editor.click("Save as a file")));
      assert.equal(await editor.leaves(), true, "it is in the file");
      assert.deepEqual(editor.tab.faults, []);
    });

    test("that a newer page has made is left alone", async () => {
      const editor = await scribbled(`indexedDB.open("scumble", 1000)`);
      await assertTold(editor);
      await editor.click("Recent drawings");
      await editor.tab.waitFor(`!document.getElementById("alert").hidden`);
      assert.match(await editor.message(), /does not give out the drawings/);
      await editor.tab.evaluate(`document.querySelector("#unkept [data-action=dismiss-unkept]").click()`);
      await editor.scribble(IN_LEFT_ROOM, ROOMS);
      assert.equal(await isTold(editor), false, "it has been told");
      assert.deepEqual(editor.tab.faults, []);
    });
  });
}
