// A picture to trace: it lies faded under the lines and the colours, in step with them, comes and goes with undo, and is
// kept with the drawing and in its file. What is no such picture leaves the drawing alone.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { readFile } from "node:fs/promises";
import { describe, test } from "node:test";
import { PNG } from "pngjs";
import { TARGETS, makeFolder, useSession } from "./harness.mjs";
import { Picture, distance, hex } from "./picture.mjs";

/** @typedef {import("./harness.mjs").Editor} Editor */
/** @typedef {[number, number]} Point */

/** The longer side of the viewBox of `drawings/rooms.svg`, whose page is half as high. */
const ROOMS = 200;
const IN_LEFT_ROOM = /** @type {Point[]} */ ([[30, 30], [50, 60], [70, 40]]);

/** Places that a picture of 4:3 covers with its left and its right half, and one beside it, all outside of the rooms. */
const LEFT = /** @type {Point} */ ([45, 4]);
const RIGHT = /** @type {Point} */ ([155, 4]);
const BESIDE = /** @type {Point} */ ([20, 4]);
/** Behind the red of the left room, and on its upper line. */
const COLORED = /** @type {Point} */ ([80, 80]);
const ON_LINE = /** @type {Point} */ ([60, 10]);

/** A picture of 4:3, blue on the left and green on the right. */
const HALVES = (() => {
  const png = new PNG({ width: 40, height: 30 });
  for (let i = 0; i < 40 * 30; i++) png.data.set(i % 40 < 20 ? [0, 0, 255, 255] : [0, 160, 0, 255], 4 * i);
  return PNG.sync.write(png);
})();

const JPEG = new URL("../../crates/scumble-io/tests/foreign/sketch.jpg", import.meta.url);

/** A JPEG that says of its frame that it is larger. @param {Buffer} jpeg */
const huge = (jpeg) => jpeg.fill("\x40", jpeg.indexOf("ffc0", "hex") + 5, jpeg.indexOf("ffc0", "hex") + 9);

/** A JPEG whose table of codes has more codes than there can be. @param {Buffer} jpeg */
const uncoded = (jpeg) => jpeg.fill(16, jpeg.indexOf("ffc4", "hex") + 5, jpeg.indexOf("ffc4", "hex") + 21);

/** The colours of places of the page. @param {Editor} editor @param {Point[]} places */
const colorsAt = async (editor, ...places) => {
  const picture = await editor.picture();
  return (await editor.place(places, ROOMS)).map(([x, y]) => hex(picture.at(x, y)));
};

/** Drops a file on the page. @param {Editor} editor @param {string} name @param {Uint8Array} content */
const drop = (editor, name, content) =>
  editor.tab.evaluate(`{
    const data = new DataTransfer();
    data.items.add(new File([new Uint8Array([${[...content]}])], ${JSON.stringify(name)}));
    document.getElementById("canvas").dispatchEvent(new DragEvent("drop", { dataTransfer: data, bubbles: true }));
  }`);

/** @param {Editor} editor */
const lay = (editor) => editor.until("sea.png lies under", () => drop(editor, "sea.png", HALVES));

/** @param {Editor} editor @returns {Promise<boolean>} whether there is a picture, shown or not */
const hasControls = (editor) => editor.tab.evaluate(`document.getElementById("tracing-button").checkVisibility()`);

for (const { browser, renderer } of TARGETS) {
  describe(`a picture to trace, ${renderer} in ${browser}`, () => {
    const session = useSession(browser, { hasGpu: renderer !== "cpu" });

    test("it lies under colours and lines, faded as it is said, and goes where the page goes", async () => {
      const editor = await session.open(renderer);
      await editor.openDrawing("rooms");
      await editor.click("Red");
      await editor.scribble(IN_LEFT_ROOM, ROOMS);
      assert.equal(await hasControls(editor), false);
      await lay(editor);
      const faded = ["#8080ff", "#80d080", "#ffffff", "#e5484d", "#000000"];
      const places = [LEFT, RIGHT, BESIDE, COLORED, ON_LINE];
      assertNear(await colorsAt(editor, ...places), faded);

      const { x, y } = await editor.box();
      await editor.tab.mouse.move(x + 200, y + 200);
      await editor.tab.wheel(40, 30);
      assertNear(await colorsAt(editor, ...places), faded);
      await editor.click("Zoom out");
      await editor.click("Zoom out");
      assertNear(await colorsAt(editor, ...places), faded);

      await editor.slide("tracing-opacity", 100, async () => {
        assertNear(await colorsAt(editor, LEFT, RIGHT, COLORED), ["#0000ff", "#00a000", "#e5484d"]);
      });
      await editor.until("Undone", () => editor.click("Undo"));
      assertNear(await colorsAt(editor, ...places), faded);
      await editor.toggle("Show tracing image");
      assertNear(await colorsAt(editor, LEFT, RIGHT, COLORED), ["#ffffff", "#ffffff", "#e5484d"]);
      await editor.toggle("Show tracing image");
      assertNear(await colorsAt(editor, ...places), faded);
      assert.deepEqual(editor.tab.faults, []);
    });

    test("undo takes it away and brings it back, and it can be replaced", async () => {
      const editor = await session.open(renderer);
      await editor.openDrawing("rooms");
      await lay(editor);
      await editor.until("Tracing image removed", () => editor.click("Remove tracing image"));
      assert.equal(await hasControls(editor), false);
      assertNear(await colorsAt(editor, LEFT), ["#ffffff"]);
      await editor.until("Undone", () => editor.click("Undo"));
      assertNear(await colorsAt(editor, LEFT), ["#8080ff"]);
      const jpeg = await readFile(JPEG);
      await editor.until("photo.jpg lies under", () => drop(editor, "photo.jpg", jpeg));
      assertNear(await colorsAt(editor, LEFT, RIGHT), ["#9dc1fb", "#fbe4a4"]);
      await editor.until("Undone", () => editor.click("Undo"));
      assertNear(await colorsAt(editor, LEFT), ["#8080ff"]);
      await editor.until("Undone", () => editor.click("Undo"));
      assert.equal(await hasControls(editor), false);
      await editor.until("Redone", () => editor.click("Redo"));
      assertNear(await colorsAt(editor, LEFT), ["#8080ff"]);
      assert.deepEqual(editor.tab.faults, []);
    });
  });
}

/**
 * Browsers round colours that they blend, and JPEGs that they decode, as they like.
 * @param {string[]} actual
 * @param {string[]} expected
 */
function assertNear(actual, expected) {
  const rgb = (/** @type {string} */ text) =>
    /** @type {[number, number, number]} */ ([1, 3, 5].map((i) => parseInt(text.slice(i, i + 2), 16)));
  const isNear = (/** @type {string} */ color, /** @type {number} */ i) => distance(rgb(color), rgb(expected[i])) <= 4;
  assert.ok(actual.every(isNear), `${actual} for ${expected}`);
}

for (const browser of /** @type {const} */ (["chromium", "firefox"])) {
  describe(`a picture to trace, kept in ${browser}`, () => {
    const session = useSession(browser);
    const folder = makeFolder();

    const traced = async () => {
      const editor = await session.open("cpu");
      await editor.openDrawing("rooms");
      await lay(editor);
      return editor;
    };

    /** How often pictures have been written to the storage. @param {Editor} editor @returns {Promise<number>} */
    const writes = (editor) => editor.tab.evaluate("window.writes");
    const COUNT_WRITES = `{
      window.writes = 0;
      const { put } = IDBObjectStore.prototype;
      IDBObjectStore.prototype.put = function (...args) {
        if (this.name === "images") window.writes++;
        return put.apply(this, args);
      };
    }`;

    test("the page comes up with it, and it is written only where it is another", async () => {
      const editor = await session.open("cpu");
      await editor.tab.evaluate(COUNT_WRITES);
      await editor.openDrawing("rooms");
      await editor.kept();
      assert.equal(await writes(editor), 0);
      await lay(editor);
      await editor.kept();
      assert.equal(await writes(editor), 1);
      await editor.scribble(IN_LEFT_ROOM, ROOMS);
      await editor.slide("tracing-opacity", 100);
      await editor.kept();
      assert.equal(await writes(editor), 1);

      const again = await session.reopen(editor.tab);
      assertNear(await colorsAt(again, LEFT, RIGHT), ["#0000ff", "#00a000"]);
      await again.tab.evaluate(COUNT_WRITES);
      await again.scribble(IN_LEFT_ROOM, ROOMS);
      await again.kept();
      assert.equal(await writes(again), 0);
      await again.click("Remove tracing image");
      await again.kept();
      await session.reopen(editor.tab);
      assert.equal(await hasControls(again), false);
      assertNear(await colorsAt(again, LEFT), ["#ffffff"]);
      assert.deepEqual(editor.tab.faults, []);
    });

    test("what undo has brought back is what is kept", async () => {
      const editor = await traced();
      await editor.until("photo.jpg", async () => drop(editor, "photo.jpg", await readFile(JPEG)));
      await editor.until("Undone", () => editor.click("Undo"));
      await editor.kept();
      await session.reopen(editor.tab);
      assertNear(await colorsAt(editor, LEFT, RIGHT), ["#8080ff", "#80d080"]);
      assert.deepEqual(editor.tab.faults, []);
    });

    test("it moves in the same frame as the canvas", async () => {
      const editor = await traced();
      const [desk, page] = await editor.tab.evaluate(`new Promise((done) => {
        const canvas = document.getElementById("canvas");
        canvas.dispatchEvent(new WheelEvent("wheel", { deltaX: -37, deltaY: -23, bubbles: true, cancelable: true }));
        requestAnimationFrame(() => {
          const { e: left, f: top } = new DOMMatrix(getComputedStyle(document.getElementById("under")).transform);
          const alpha = (x, y) => canvas.getContext("2d").getImageData(x, y, 1, 1).data[3];
          done([alpha(left - 1, top + 1), alpha(left + 1, top + 1)]);
        });
      })`);
      assert.deepEqual([desk, page], [255, 0], "the desk ends where the page begins");
    });

    test("another drawing is without it, and it is there again with its own", async () => {
      const editor = await traced();
      await editor.openSample("Apple");
      assert.equal(await hasControls(editor), false);
      await editor.until("Undone", () => editor.click("Undo"));
      assertNear(await colorsAt(editor, LEFT), ["#8080ff"]);
    });

    test("a drawing that was deleted is kept anew, with it, once undo comes back to it", async () => {
      const editor = await traced();
      await editor.kept();
      await editor.openSample("Apple");
      await editor.click("Recent drawings");
      await editor.tab.evaluate(`window.confirm = () => true`);
      await editor.click("Delete rooms.svg");
      await editor.tab.waitFor(`document.querySelectorAll("#recent li").length === 0`);
      await editor.click("Close");
      assert.equal(await editor.leaves(), true, "nobody misses it");
      await editor.until("Undone", () => editor.click("Undo"));
      await editor.kept();
      await editor.scribble(IN_LEFT_ROOM, ROOMS);
      await editor.kept();
      await session.reopen(editor.tab);
      assert.equal(await editor.name(), "rooms.svg");
      assertNear(await colorsAt(editor, LEFT), ["#8080ff"]);
      await editor.until("Scribble added, 2 in", () => editor.scribble(IN_LEFT_ROOM, ROOMS));
      assert.deepEqual(editor.tab.faults, []);
    });

    test("where it is too much for the storage, all else is kept, and it is told of until it is kept, too", async () => {
      const tab = await session.newTab();
      await tab.prepare(`{
        const { put } = IDBObjectStore.prototype;
        IDBObjectStore.prototype.put = function (...args) {
          const request = put.apply(this, args);
          if (this.name === "images" && args[0].bytes.length === ${HALVES.length}) this.transaction.abort();
          return request;
        };
      }`);
      const editor = await session.reopen(tab);
      await editor.openDrawing("rooms");
      await lay(editor);
      const isTold = () => tab.evaluate(`!document.getElementById("unkept").hidden`);
      await tab.waitFor(`!document.getElementById("unkept").hidden`);
      assert.match(await tab.evaluate(`document.getElementById("unkept").textContent`), /cannot keep the tracing image.*Save as a file/s);
      assert.equal(await editor.leaves(), false, "the page asks before it goes");
      await editor.scribble(IN_LEFT_ROOM, ROOMS);
      await tab.evaluate(`window.addEventListener("beforeunload", (event) => event.stopImmediatePropagation(), true)`);
      await session.reopen(tab);
      assert.equal(await editor.name(), "rooms.svg");
      assertNear(await colorsAt(editor, LEFT), ["#ffffff"]);
      await editor.until("Scribble added, 2 in", () => editor.scribble(IN_LEFT_ROOM, ROOMS));

      await lay(editor);
      await tab.waitFor(`!document.getElementById("unkept").hidden`);
      await editor.until("photo.jpg lies", async () => drop(editor, "photo.jpg", await readFile(JPEG)));
      await editor.kept();
      assert.equal(await isTold(), false, "this one fits");
      await session.reopen(tab);
      assertNear(await colorsAt(editor, LEFT), ["#9dc1fb"]);
      assert.deepEqual(tab.faults, []);
    });

    test("a picture of which the storage has lost the file leaves the drawing as it is", async () => {
      const editor = await traced();
      await editor.kept();
      await editor.tab.evaluate(`new Promise((done) => {
        indexedDB.open("scumble").onsuccess = ({ target: { result } }) => {
          const transaction = result.transaction("images", "readwrite");
          transaction.objectStore("images").clear();
          transaction.oncomplete = () => (result.close(), done());
        };
      })`);
      await session.reopen(editor.tab);
      assert.equal(await editor.name(), "rooms.svg");
      assertNear(await colorsAt(editor, LEFT), ["#ffffff"]);
      await editor.until("Scribble added", () => editor.scribble(IN_LEFT_ROOM, ROOMS));
      await lay(editor);
      assertNear(await colorsAt(editor, LEFT), ["#8080ff"]);
      await editor.click("Remove tracing image");
      await editor.kept();
      assert.equal(await hasControls(editor), false);
      assert.deepEqual(editor.tab.faults, []);
    });

    test("drawings that a page without such pictures has kept come up in this one", async () => {
      const bytes = await readFile(new URL("../../crates/scumble-io/tests/fixtures/v1.0/rooms-2.work", import.meta.url));
      // Beside a picture that is a page of its own a browser asks for an icon, sooner or later: so it has a tab of its own.
      const before = await session.newTab();
      await before.goto(`${session.url}web/icon.svg`);
      await before.evaluate(`new Promise((done, fail) => {
        const request = indexedDB.open("scumble", 1);
        request.onupgradeneeded = () => {
          request.result.createObjectStore("entries", { keyPath: "id" });
          for (const name of ["works", "pictures", "ended"]) request.result.createObjectStore(name);
        };
        request.onsuccess = () => {
          const transaction = request.result.transaction(["entries", "works"], "readwrite");
          transaction.objectStore("entries").put({ id: "a", name: "old rooms", writer: 0, seen: 1, isUnsaved: true });
          transaction.objectStore("works").put(new Uint8Array([${[...bytes]}]), "a");
          transaction.oncomplete = () => (request.result.close(), done());
          transaction.onabort = fail;
        };
        request.onerror = fail;
      })`);
      const tab = await before.beside();
      const editor = await session.reopen(tab);
      assert.equal(await editor.name(), "old rooms");
      await lay(editor);
      await editor.kept();
      await session.reopen(tab);
      assert.equal(await editor.name(), "old rooms");
      assert.equal(await editor.tab.evaluate(`document.querySelector("#under img").naturalWidth`), 40);
      assert.deepEqual(tab.faults, []);
    });

    for (const [name, content, message] of /** @type {[string, () => Uint8Array, RegExp][]} */ ([
      ["cut.png", () => HALVES.subarray(0, HALVES.length - 20), /end is missing; save or download it again/],
      ["broken.png", () => Buffer.from(HALVES).fill(7, 41, 60), /a part of it was changed; save or download it again/],
      ["broken.jpg", () => uncoded(readFileSync(JPEG)), /damaged, or coded as this browser does not know it; save it again/],
      ["huge.jpg", () => huge(readFileSync(JPEG)), /16,448 × 16,448 pixels; scale it down to 16,384 a side/],
      ["moving.gif", () => Buffer.from("GIF89a, and so on"), /GIF pictures cannot be opened; save the picture as PNG or JPEG/],
      ["nothing.jpg", () => new Uint8Array(9), /no PNG or JPEG picture/],
      ["large.jpg", () => Buffer.alloc((8 << 20) + 1, "\xff\xd8\xff", "latin1"), /larger than 8 MiB; save it with fewer pixels/],
    ])) {
      test(`${name}, which cannot be traced, says so and leaves the drawing as it is`, async () => {
        const editor = await session.open("cpu");
        await editor.openDrawing("rooms");
        await editor.scribble(IN_LEFT_ROOM, ROOMS);
        const before = await editor.picture();
        const path = await folder.write(name, content());
        await editor.tab.chooseFiles([path]);
        await editor.tab.waitFor(`!document.getElementById("alert").hidden`);
        assert.match(await editor.message(), message);
        await editor.click("Dismiss");
        assert.ok((await editor.picture()).equals(before));
        assert.equal(await hasControls(editor), false);
        await editor.until("Undone", () => editor.click("Undo"));
        assert.deepEqual(editor.tab.faults, []);
      });
    }

    test("no link has it, and the page says so", async () => {
      const editor = await traced();
      const isTold = () => editor.tab.evaluate(`document.getElementById("share-tracing").checkVisibility()`);
      await editor.click("Share");
      await editor.tab.waitFor(`document.getElementById("share")?.open`);
      assert.equal(await isTold(), true);
      const link = String(await editor.tab.evaluate(`document.getElementById("link").value`));
      await editor.click("Close");
      await editor.until("Opened the link", () => editor.tab.evaluate(`location.hash = ${JSON.stringify(new URL(link).hash)}`));
      assert.equal(await hasControls(editor), false);
      await editor.click("Share");
      await editor.tab.waitFor(`document.getElementById("share")?.open`);
      assert.equal(await isTold(), false);
      assert.deepEqual(editor.tab.faults, []);
    });

    if (browser === "firefox") return;

    test("its file has it, and exported pictures have not", async () => {
      const editor = await traced();
      await editor.slide("tracing-opacity", 100);
      const path = await editor.tab.download(() => editor.click("Save"));
      const file = JSON.parse(await readFile(path, "utf8"));
      assert.deepEqual([file.version, file.tracing_image, file.tracing_opacity], ["1.1", HALVES.toString("base64"), 1]);
      await editor.openSample("Apple");
      const copy = await folder.write("again.scumble", await readFile(path));
      await editor.until("Opened again.scumble", () => editor.tab.chooseFiles([copy]));
      assertNear(await colorsAt(editor, LEFT, RIGHT), ["#0000ff", "#00a000"]);

      for (const format of ["PNG", "SVG"]) {
        await editor.click("Export");
        await editor.tab.click("radio", format);
        const picture = await readFile(await editor.tab.download(() => editor.click("Save file")));
        await editor.tab.waitFor(`!document.getElementById("export").open`);
        if (format === "SVG") assert.ok(!picture.includes("tracing"), "nor the work in an SVG");
        else assert.deepEqual(Picture.decode(picture).colors([0, 0], [1023, 30]), ["#ffffff"]);
      }
      assert.deepEqual(editor.tab.faults, []);
    });

    test("a tab that goes on with a copy has it there", async () => {
      const editor = await traced();
      await editor.kept();
      const beside = await session.reopen(await editor.tab.beside());
      assert.equal(await beside.name(), "Copy of rooms.svg");
      await beside.scribble(IN_LEFT_ROOM, ROOMS);
      await beside.kept();
      await editor.tab.close();
      await session.reopen(beside.tab);
      assert.equal(await beside.name(), "Copy of rooms.svg");
      assertNear(await colorsAt(beside, LEFT), ["#8080ff"]);
      assert.deepEqual(beside.tab.faults, []);
    });
  });
}
