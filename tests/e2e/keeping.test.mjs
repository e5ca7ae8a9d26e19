// What the browser keeps: the page comes up with the drawing that was open last, and has the others in a list. What is
// damaged there stays out of the way.
import assert from "node:assert/strict";
import { describe, test } from "node:test";
import { useSession } from "./harness.mjs";

/** The longer sides of the viewBoxes of the drawings here. */
const ROOMS = 200;
const APPLE = 72;
const IN_LEFT_ROOM = /** @type {[number, number][]} */ ([[30, 30], [50, 60], [70, 40]]);
const IN_RIGHT_ROOM = /** @type {[number, number][]} */ ([[120, 80], [130, 85]]);
const IN_APPLE = /** @type {[number, number][]} */ ([[30, 40], [40, 45]]);

/** Ways to damage work: cut off, of a newer version, no bytes, gone. */
const DAMAGES = [
  `(work) => work.slice(0, -1)`,
  `(work) => [work[0]++, work][1]`,
  `() => "work"`,
  `() => undefined`,
];

/** Changes what the storage has, behind the page's back. @param {string} changes of the drawings with some `ids` */
const tamper = (changes) => `new Promise((done, fail) => {
  const request = indexedDB.open("scumble");
  request.onsuccess = () => {
    const transaction = request.result.transaction("works", "readwrite");
    const works = transaction.objectStore("works");
    const damage = (id, change) => {
      works.get(id).onsuccess = ({ target }) => works.put(change(target.result), id);
    };
    works.getAllKeys().onsuccess = ({ target: { result: ids } }) => { ${changes} };
    transaction.oncomplete = done;
    transaction.onabort = fail;
  };
})`;

/** The works in the storage, each as a text. */
const WORKS = `new Promise((done) => {
  indexedDB.open("scumble").onsuccess = ({ target: { result: database } }) => {
    database.transaction("works").objectStore("works").getAll().onsuccess = ({ target: { result: works } }) => {
      database.close();
      done(works.map(String));
    };
  };
})`;

/** Takes all pictures out of the storage, and tells how many there were. */
const CLEAR_PICTURES = `new Promise((done) => {
  indexedDB.open("scumble").onsuccess = ({ target: { result: database } }) => {
    const pictures = database.transaction("pictures", "readwrite").objectStore("pictures");
    pictures.count().onsuccess = ({ target: { result: count } }) => {
      pictures.clear().onsuccess = () => {
        database.close();
        done(count);
      };
    };
  };
})`;

for (const browser of /** @type {const} */ (["chromium", "firefox"])) {
  describe(`what ${browser} keeps`, () => {
    const session = useSession(browser);

    const scribbled = async () => {
      const editor = await session.open("cpu");
      await editor.openDrawing("rooms");
      await editor.scribble(IN_LEFT_ROOM, ROOMS);
      await editor.kept();
      return editor;
    };

    /** @param {import("./harness.mjs").Editor} editor @returns {Promise<string[]>} what the buttons of the list say, without its heads */
    const list = async (editor) => {
      await editor.click("Recent drawings");
      await editor.tab.waitFor(`document.getElementById("recent")?.open`);
      return editor.tab.evaluate(`[...document.querySelectorAll("#recent li button")].map((button) => button.ariaLabel)`);
    };

    test("each gesture is kept, and the page comes up as it was", async () => {
      const editor = await scribbled();
      await editor.choose("Blend", "srgb");
      await editor.scribble(IN_RIGHT_ROOM, ROOMS);
      await editor.scribble(IN_RIGHT_ROOM, ROOMS);
      await editor.until("Undone", () => editor.click("Undo"));
      await editor.kept();
      const picture = await editor.picture();
      const again = await session.reopen(editor.tab);
      assert.ok((await again.picture()).equals(picture));
      assert.equal(await again.tab.evaluate("document.title"), "• rooms.svg – Scumble");
      assert.equal(await again.status(), "Opened rooms.svg");
      await again.until("Scribble added, 3 in", () => again.scribble(IN_RIGHT_ROOM, ROOMS));
      assert.deepEqual(editor.tab.faults, []);
    });

    test("what a key has in hand is kept where it is not heard of any more", async () => {
      const svg = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9"><path stroke="black" d="M1 1l5 5"/></svg>`;
      /** @type {((editor: import("./harness.mjs").Editor) => Promise<unknown>)[]} */
      const ways = [
        (editor) => editor.until("Opened other.svg", () => editor.drop(svg, "other.svg")),
        ...["blur", "pagehide", "beforeunload"].map((kind) => (/** @type {import("./harness.mjs").Editor} */ editor) =>
          editor.tab.evaluate(`window.dispatchEvent(new Event("${kind}"))`)),
      ];
      for (const [i, leave] of ways.entries()) {
        const editor = await scribbled();
        await editor.until("selected", () => editor.tab.hold("Control", () => editor.tab.press("a")));
        const [before] = await editor.tab.evaluate(WORKS);
        await editor.tab.hold("ArrowRight", async () => {
          await leave(editor);
          await editor.kept();
          assert.ok(!(await editor.tab.evaluate(WORKS)).includes(before), `way ${i}`);
        });
        assert.deepEqual(editor.tab.faults, []);
      }
    });

    test("the list has a picture of each drawing; one is gone on with, one is deleted", async () => {
      const editor = await scribbled();
      const rooms = await editor.picture();
      await editor.openSample("Apple");
      await editor.scribble(IN_APPLE, APPLE);
      await editor.kept();
      await session.reopen(editor.tab);
      assert.deepEqual(await list(editor), ["Open Apple", "Open rooms.svg", "Delete rooms.svg"]);
      await editor.tab.waitFor(`[...document.querySelectorAll("#recent img")].every((image) => image.naturalWidth === 240)`);
      const [below, beside] = await editor.tab.evaluate(`{
        const [dialog, card] = ["#recent", "#recent li"].map((part) => document.querySelector(part).getBoundingClientRect());
        [dialog.bottom - card.bottom, card.left - dialog.left];
      }`);
      assert.equal(below, beside, "a single row has the same room below as beside");
      await editor.until("Opened rooms.svg", () => editor.click("Open rooms.svg"));
      assert.ok((await editor.picture()).equals(rooms));
      await editor.kept();
      assert.equal(await (await session.reopen(editor.tab)).name(), "rooms.svg", "it was open last");

      await list(editor);
      await editor.tab.evaluate(`window.confirm = () => false`);
      await editor.click("Delete Apple");
      await editor.tab.evaluate(`window.confirm = () => true`);
      await editor.click("Delete Apple");
      await editor.tab.waitFor(`document.querySelectorAll("#recent li").length === 1`);
      await editor.click("Close");
      assert.deepEqual(await list(editor), ["Open rooms.svg"]);
      assert.deepEqual(editor.tab.faults, []);
    });

    test("a drawing that was left before it had a picture has the page's sign in the list", async () => {
      const editor = await scribbled();
      await editor.openSample("Apple");
      // The picture is made as the drawing is left, and may come later than what is there in its place.
      const cleared = `(async () => {
        for (let tries = 0; tries < 500; tries++) {
          if (await ${CLEAR_PICTURES}) return true;
          await new Promise((wake) => setTimeout(wake, 20));
        }
      })()`;
      assert.ok(await editor.tab.evaluate(cleared));
      await list(editor);
      await editor.tab.waitFor(`document.querySelector("#recent img").naturalWidth > 0`);
      assert.match(await editor.tab.evaluate(`document.querySelector("#recent img").src`), /icon\.svg$/);
      assert.deepEqual(editor.tab.faults, []);
    });

    test("a drawing goes on in the file that it was saved to", async () => {
      const editor = await scribbled();
      const dialog = `
        window.asked = 0;
        window.showSaveFilePicker = async ({ suggestedName }) => {
          window.asked++;
          return (await navigator.storage.getDirectory()).getFileHandle(suggestedName, { create: true });
        };`;
      await editor.tab.evaluate(`{ ${dialog} }`);
      await editor.until("Saved rooms.scumble", () => editor.click("Save"));
      await editor.kept();
      await session.reopen(editor.tab);
      assert.equal(await editor.tab.evaluate("document.title"), "rooms.scumble – Scumble");
      await editor.tab.evaluate(`{ ${dialog} }`);
      await editor.scribble(IN_RIGHT_ROOM, ROOMS);
      await editor.until("Saved rooms.scumble", () => editor.click("Save"));
      assert.equal(await editor.tab.evaluate("window.asked"), 0);
      assert.deepEqual(editor.tab.faults, []);
    });

    if (browser === "firefox") return;

    test("a page that is left has its drawing in the next tab", async () => {
      const editor = await scribbled();
      const picture = await editor.picture();
      const tab = await editor.tab.beside();
      await editor.tab.close();
      const again = await session.reopen(tab);
      assert.equal(await again.name(), "rooms.svg");
      assert.ok((await again.picture()).equals(picture));
    });

    test("a sample that nobody has touched is not kept; one that somebody has is", async () => {
      const editor = await session.open("cpu");
      await editor.openSample("Apple");
      assert.equal(await (await session.reopen(editor.tab)).name(), "Goldfish");
      await editor.openSample("Apple");
      await editor.scribble(IN_APPLE, APPLE);
      await editor.kept();
      assert.equal(await (await session.reopen(editor.tab)).name(), "Apple");
    });

    test("damaged work is told of once and put aside, whatever is wrong with it", async () => {
      const editor = await session.open("cpu");
      for (let i = 0; i < DAMAGES.length; i++) {
        await editor.openDrawing("rooms");
        await editor.kept();
      }
      await editor.tab.evaluate(tamper(DAMAGES.map((damage, i) => `damage(ids[${i}], ${damage});`).join("")));
      await editor.tab.goto(`${session.url}?renderer=cpu`);
      await editor.tab.waitFor(`document.getElementById("drawing").textContent === "Goldfish"`);
      await editor.tab.waitFor(`!document.getElementById("alert").hidden`);
      assert.match(await editor.message(), /kept is damaged or from a newer Scumble/);
      await session.reopen(editor.tab);
      assert.equal(await editor.name(), "Goldfish");
      assert.equal((await list(editor)).length, 2 * DAMAGES.length);
      const notes = await editor.tab.evaluate(`[...document.querySelectorAll("#recent small")].map((note) => note.textContent)`);
      assert.deepEqual(notes, DAMAGES.map(() => "Damaged, or from a newer Scumble"));
      await editor.tab.evaluate(`document.querySelector("#recent li button").click()`);
      await editor.tab.waitFor(`!document.getElementById("alert").hidden`);
      assert.equal(await editor.name(), "Goldfish");
      assert.deepEqual(editor.tab.faults, []);
    });

    test("an untouched drawing that stops the page is not opened by itself again", async () => {
      const editor = await scribbled();
      await session.reopen(editor.tab);
      await editor.kept();
      await editor.tab.evaluate(`window.dispatchEvent(
        new ErrorEvent("error", { error: new WebAssembly.RuntimeError("unreachable"), cancelable: true }))`);
      await editor.tab.waitFor(`!document.getElementById("alert").hidden`);
      assert.equal(await (await session.reopen(editor.tab)).name(), "Goldfish");
    });
  });
}
