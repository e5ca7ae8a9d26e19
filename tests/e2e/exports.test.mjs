// Export: pictures for other programs show what the canvas shows, and an SVG opens again as the work that it was.
import assert from "node:assert/strict";
import { describe, test } from "node:test";
import { makeFolder, useSession } from "./harness.mjs";
import { Picture, assertSame } from "./picture.mjs";

/** @typedef {import("./harness.mjs").Editor} Editor */

/** The longer side of the viewBox of `drawings/shading.svg`, and its size in pixels at 1×. */
const SHADING = 200;
/** The same of `drawings/rooms.svg`. */
const ROOMS = 200;
const SIZE = { width: 1024, height: 512 };
const SCRIBBLES = /** @type {[string, [number, number][]][]} */ ([
  ["Yellow", [[35, 45], [60, 30], [90, 28]]],
  ["Violet", [[40, 70], [80, 82], [110, 76]]],
  ["Teal", [[150, 20], [185, 40], [180, 80]]],
]);

/** Files stay in the page: `window.saved` is the address of the last one, `window.savedAs` its name. @param {Editor} editor */
const catchFiles = (editor) =>
  editor.tab.evaluate(`{
    HTMLAnchorElement.prototype.click = function () { [window.saved, window.savedAs] = [this.href, this.download]; };
  }`);

/** @param {Editor} editor @param {string} blob an expression in the page @returns {Promise<Buffer>} */
async function bytes(editor, blob) {
  const url = await editor.tab.evaluate(`Promise.resolve(${blob}).then((blob) => new Promise((done) => {
    const reader = new FileReader();
    reader.onload = () => done(reader.result);
    reader.readAsDataURL(blob);
  }))`);
  return Buffer.from(String(url).split(",")[1], "base64");
}

/**
 * @param {Editor} editor
 * @param {string} format
 * @param {() => Promise<unknown>} [choose] what else is chosen in the dialog
 */
async function exported(editor, format, choose = async () => {}) {
  await editor.click("Export");
  await editor.tab.click("radio", format);
  await choose();
  await editor.until("Exported", () => editor.click("Save file"));
  return bytes(editor, "fetch(window.saved).then((file) => file.blob())");
}

/** An SVG as the browser shows it as an image. @param {Editor} editor @param {Buffer} svg */
async function shownAsImage(editor, svg) {
  const url = `data:image/svg+xml;base64,${svg.toString("base64")}`;
  const png = await bytes(editor, `(async () => {
    const image = new Image();
    image.src = ${JSON.stringify(url)};
    await image.decode();
    const canvas = new OffscreenCanvas(image.width, image.height);
    canvas.getContext("2d").drawImage(image, 0, 0);
    return canvas.convertToBlob();
  })()`);
  return Picture.decode(png);
}

/** The whole page at 100%. @param {Editor} editor @param {{width: number, height: number}} size */
async function shown(editor, size) {
  await editor.tab.evaluate(`document.getElementById("zoom").click()`);
  const [[left, top]] = await editor.place([[0, 0]], SHADING);
  return (await editor.picture()).part(Math.round(left), Math.round(top), size);
}

for (const browser of /** @type {const} */ (["chromium", "firefox"])) {
  describe(`exports in ${browser}`, () => {
    const session = useSession(browser);
    const folder = makeFolder();

    const shaded = async () => {
      const editor = await session.open("cpu");
      await editor.openDrawing("shading");
      for (const [color, points] of SCRIBBLES) {
        await editor.click(color);
        await editor.scribble(points, SHADING);
      }
      await editor.toggle("Show scribbles");
      await catchFiles(editor);
      return editor;
    };

    test("pictures show what the canvas shows, and the SVG opens with its scribbles", async () => {
      const editor = await shaded();
      const png = Picture.decode(await exported(editor, "PNG"));
      const svg = await exported(editor, "SVG");
      assert.equal(await editor.tab.evaluate("window.savedAs"), "shading (Scumble).svg", "not that of the lines");
      const pdf = await exported(editor, "PDF");
      assert.deepEqual([png.width, png.height], [SIZE.width, SIZE.height]);
      const canvas = await shown(editor, SIZE);
      assertSame(png, canvas);
      assertSame(await shownAsImage(editor, svg), canvas);
      assert.match(pdf.toString("latin1"), /^%PDF-1\.4[^]*MediaBox \[0 0 768 384\][^]*%%EOF\n$/);

      const path = await folder.write("shading again.svg", svg);
      await editor.openSample("Pear");
      await editor.until("Opened shading again.svg", () => editor.tab.chooseFiles([path]));
      assertSame(await shown(editor, SIZE), canvas);
      const way = await editor.place([[120, 45], [126, 52]], SHADING);
      await editor.until("Scribble added, 4 in the drawing", () => editor.drag(way));
      assert.deepEqual(editor.tab.faults, []);
    });

    test("size, lines and paper are as they are chosen", async () => {
      const editor = await shaded();
      /** @type {() => Promise<void>} */
      const choose = async () => {
        await editor.click("2×");
        await editor.toggle("Lines");
        await editor.toggle("Transparent");
      };
      const png = Picture.decode(await exported(editor, "PNG", choose));
      assert.deepEqual([png.width, png.height], [2 * SIZE.width, 2 * SIZE.height]);
      assert.ok([...png.rgba].some((value, i) => i % 4 === 3 && value === 0), "some of it is clear");
      assert.deepEqual(editor.tab.faults, []);
    });

    test("shapes are as large as the page was that the drawing came with, until another size is chosen", async () => {
      const editor = await session.open("cpu");
      const svg = '<svg xmlns="http://www.w3.org/2000/svg" width="210mm" height="297mm" viewBox="0 0 210 297"><path d="M20 20H90V90Z" fill="none" stroke="#000"/></svg>';
      const path = await folder.write("a4.svg", Buffer.from(svg));
      await editor.until("Opened a4.svg", () => editor.tab.chooseFiles([path]));
      await catchFiles(editor);
      const pdf = await exported(editor, "PDF");
      assert.match(pdf.toString("latin1"), /MediaBox \[0 0 595\.276 841\.89\]/);
      assert.match((await exported(editor, "SVG")).toString(), /<svg [^>]*width="210mm" height="297mm"/);
      assert.match((await exported(editor, "SVG", () => editor.click("2×"))).toString(), /<svg [^>]*height="2048"/);
      assert.equal(Picture.decode(await exported(editor, "PNG")).height, 1024);
      assert.deepEqual(editor.tab.faults, []);
    });

    test("a print is the picture alone, as large as paper asks for", async () => {
      const editor = await session.open("cpu");
      await editor.openDrawing("rooms");
      await editor.click("Red");
      await editor.scribble([[30, 30], [50, 60], [70, 40]], ROOMS);
      const printed = () => editor.tab.evaluate(`{
        const sheet = document.getElementById("print");
        sheet && [sheet.width, sheet.height, ...sheet.getContext("2d").getImageData(${(20 / ROOMS) * 2400}, ${(80 / ROOMS) * 2400}, 1, 1).data];
      }`);
      await editor.tab.evaluate(`void window.dispatchEvent(new Event("beforeprint"))`);
      assert.deepEqual(await printed(), [2400, 1200, 0xe5, 0x48, 0x4d, 255]);
      const hidden = await editor.tab.evaluate(`{
        const rules = [...document.styleSheets].flatMap((sheet) => [...sheet.cssRules]).filter((rule) => rule.media?.mediaText === "print");
        const hides = rules.flatMap((rule) => [...rule.cssRules]).filter((rule) => rule.style.display === "none");
        [...document.body.children].filter((child) => hides.some((rule) => child.matches(rule.selectorText))).length;
      }`);
      assert.equal(hidden, (await editor.tab.evaluate(`document.body.children.length`)) - 1, "all but the picture");
      await editor.tab.evaluate(`void window.dispatchEvent(new Event("afterprint"))`);
      assert.equal(await printed(), null);
      assert.deepEqual(editor.tab.faults, []);
    });

    test("a damaged SVG opens as its lines, and says so", async () => {
      const editor = await shaded();
      const svg = (await exported(editor, "SVG")).toString().replace('"points"', '"pints"');
      const path = await folder.write("damaged.svg", svg);
      await editor.until("without the scribbles", () => editor.tab.chooseFiles([path]));
      const way = await editor.place([[120, 45], [126, 52]], SHADING);
      await editor.until("Scribble added, 1 in the drawing", () => editor.drag(way));
    });

    test("what takes long can be stopped", async () => {
      const editor = await shaded();
      await editor.click("Export");
      await editor.tab.waitFor(`document.getElementById("export")?.open`);
      await editor.tab.evaluate(`{
        const size = document.getElementById("export-size");
        size.value = "16384";
        size.dispatchEvent(new Event("input", { bubbles: true }));
      }`);
      await editor.click("Save file");
      await editor.tab.waitFor(`!document.getElementById("export-progress").hidden`);
      await editor.click("Cancel");
      await editor.tab.waitFor(`document.getElementById("export-status").textContent === "Cancelled"`);
      assert.equal(await editor.tab.evaluate("window.saved"), undefined);
      await editor.click("Close");
      assert.equal((await exported(editor, "PDF", () => editor.click("1×"))).subarray(0, 5).toString(), "%PDF-");
      assert.deepEqual(editor.tab.faults, []);
    });
  });
}

for (const browser of /** @type {const} */ (["chromium", "firefox"])) {
  describe(`the dialog of exports in ${browser}`, () => {
    const session = useSession(browser);

    const open = async () => {
      const editor = await session.open("cpu");
      await editor.openDrawing("rooms");
      await editor.tab.hold("Control", () => editor.tab.hold("Shift", () => editor.tab.press("E")));
      await editor.tab.waitFor(`document.getElementById("export")?.open`);
      return editor;
    };

    /** @param {import("./harness.mjs").Editor} editor @param {string} size */
    const setSize = async (editor, size) => {
      await editor.tab.evaluate(`{
        const size = document.getElementById("export-size");
        size.value = "${size}";
        size.dispatchEvent(new Event("input", { bubbles: true }));
      }`);
      return /** @type {Promise<{disabled: boolean, invalid: string, said: string}>} */ (editor.tab.evaluate(`({
        disabled: document.getElementById("save-export").disabled,
        invalid: document.getElementById("export-size").ariaInvalid,
        said: document.getElementById("export-status").textContent,
      })`));
    };

    test("it opens and closes by keys, begins at the first choice, and says which sizes are not made", async () => {
      const editor = await open();
      assert.equal(await editor.tab.evaluate("document.activeElement.labels[0].textContent"), "PNG");
      for (const size of ["16385", "0", "12.5", ""]) {
        const { disabled, invalid, said } = await setSize(editor, size);
        assert.deepEqual([disabled, invalid], [true, "true"], size);
        assert.match(said, /from 1 to 16,384/);
      }
      for (const size of ["16384", "1"]) {
        assert.deepEqual(await setSize(editor, size), { disabled: false, invalid: "false", said: "" });
      }
      await setSize(editor, "16385");
      await editor.click("4×");
      assert.equal(await editor.tab.evaluate(`document.getElementById("save-export").disabled`), false);
      await editor.tab.press("Escape");
      await editor.tab.waitFor(`!document.getElementById("export").open`);
      assert.deepEqual(editor.tab.faults, []);
    });

    test("what is pasted into the field of the size is no drawing", async () => {
      const editor = await open();
      /** @param {string} id */
      const paste = (id) => editor.tab.evaluate(`{
        const data = new DataTransfer();
        data.setData("text/plain", "#ff8800");
        const event = Object.assign(new Event("paste", { bubbles: true }), { clipboardData: data });
        document.getElementById("${id}").dispatchEvent(event);
      }`);
      const color = () => editor.tab.evaluate(`document.getElementById("color").dataset.color`);
      const before = await color();
      await paste("export-size");
      assert.equal(await color(), before);
      await paste("export-lines");
      assert.equal(await color(), "#ff8800", "what cannot be written in takes none");
      assert.equal(await editor.tab.evaluate(`document.getElementById("export").open`), true);
    });

    test("Lines stay as they were chosen, until those of the view change", async () => {
      const editor = await open();
      const lines = () => editor.tab.evaluate(`document.getElementById("export-lines").checked`);
      /** Opens it again, after something else. @param {() => Promise<unknown>} [between] */
      const again = async (between = async () => {}) => {
        await editor.click("Close");
        await editor.tab.waitFor(`!document.getElementById("export").open`);
        await between();
        await editor.click("Export");
        return lines();
      };
      assert.equal(await lines(), true);
      await editor.toggle("Lines");
      assert.equal(await again(), false);
      assert.equal(await again(() => editor.toggle("Show lines")), false);
      assert.equal(await again(() => editor.toggle("Show lines")), true);
    });

    test("pixels are copied", async () => {
      const editor = await open();
      await editor.tab.evaluate(`
        navigator.clipboard.write = async ([item]) => void (window.copied = await item.getType("image/png"))`);
      await editor.tab.evaluate(`document.getElementById("copy-picture").focus()`);
      await editor.tab.press("Enter");
      await editor.tab.waitFor(`document.getElementById("export-status").textContent === "Copied"`);
      await editor.tab.waitFor(`document.activeElement.id === "copy-picture"`);
      const picture = Picture.decode(await bytes(editor, "window.copied"));
      assert.equal(picture.width, 1024);
      await editor.tab.click("radio", "SVG");
      assert.equal(await editor.tab.evaluate(`document.getElementById("copy-picture").hidden`), true);
    });
  });
}
