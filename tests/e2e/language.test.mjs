// The second language: its table has what the first has, the page says all of it, and its longer words fit.
import assert from "node:assert/strict";
import { readFile, readdir } from "node:fs/promises";
import { describe, test } from "node:test";
import { DIST, Editor, makeFolder, useSession, version } from "./harness.mjs";

/** Has a browser want German. */
const GERMAN = `Object.defineProperty(navigator, "languages", { get: () => ["de-AT", "en"] })`;

/** Files that cannot be opened, and what is said of them. @type {Record<string, [content: string, said: string]>} */
const BAD_FILES = {
  "kaputt.svg": ['<svg xmlns="http://www.w3.org/2000/svg"><g></svg>', "Das ist keine SVG-Zeichnung, oder sie ist beschädigt: das Tag 'g' statt 'svg' erwartet bei 1:44; sichere sie noch einmal, oder wähle eine andere."],
  "leer.svg": ['<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9"><text>a</text></svg>', "Die Zeichnung hat keine Linien und keine Formen zum Färben (weggelassen: 1 Text)."],
  "kaputt.scumble": ['{"format": "scumble", "version": "1.0",\n"canvas": 7}', "Die Datei ist in Zeile 2 unbrauchbar, dort müsste stehen: eine Liste […]; bessere sie aus, oder sichere die Zeichnung noch einmal."],
  "bunt.hex": ["#0a0b0c\n".repeat(1001), "Die Palette hat mehr als 1.000 Farben; nimm einige heraus."],
  "kaputt.hex": ["; See\nblau\n", "Die Palette ist in Zeile 2 unbrauchbar, dort müsste stehen: eine Farbe #rrggbb; bessere sie aus, oder sichere sie noch einmal."],
};

const DAMAGED_LINK = "Der Link ist beschädigt: ein Teil davon fehlt oder ist verändert; kopiere den ganzen Link noch einmal.";

/** A square, a text and two pictures. */
const MIXED = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9"><text>a</text>${'<image href="a.png" width="9" height="9"/>'.repeat(2)}
  <path d="M1 1H8V8H1Z" fill="none" stroke="#000"/></svg>`;

/** The dialogs, by their ids, which are those of what opens them. */
const DIALOGS = ["help", "export", "share", "samples", "recent"];

const page = () => readFile(new URL("../../index.html", import.meta.url), "utf8");

const WEB = new URL("../../web/", import.meta.url);

/** @param {string} file */
const module = (file) => readFile(new URL(file, WEB), "utf8");

/** @param {Editor} editor @param {string} id */
async function openDialog(editor, id) {
  await editor.tab.evaluate(`document.querySelector('[data-action="${id}"]').click()`);
  await editor.tab.waitFor(`document.getElementById("${id}")?.open`);
}

/** The keys of labels. @param {string} markup */
const labelsOf = (markup) => [...markup.matchAll(/data-(?:text|label)="([^"$]+)"/g)].map(([, key]) => key);

test("both tables have the same keys, and every label of the page", async () => {
  // The tables tell the keys of a Mac by the browser.
  Object.assign(globalThis, { navigator: globalThis.navigator ?? { platform: "" } });
  const [first, { later }, { german }] = await Promise.all([
    import("../../web/messages.js"),
    import("../../web/later_messages.js"),
    import("../../web/german.js"),
  ]);
  const english = { ...first.english, ...later };
  assert.equal(Object.keys(english).length, Object.keys(first.english).length + Object.keys(later).length);
  assert.deepEqual(Object.keys(german).sort(), Object.keys(english).sort());
  for (const [key, text] of Object.entries(english)) assert.equal(typeof german[key], typeof text, key);
  const modules = (await readdir(WEB)).filter((file) => file.endsWith(".js")).map(module);
  const used = (await Promise.all([page(), ...modules])).flatMap(labelsOf);
  assert.ok(used.length > 100 && used.includes("recent-none"));
  assert.deepEqual(used.filter((key) => !(key in english)), []);
});

test("no word that is fetched later is said before", async () => {
  const { later } = await import("../../web/later_messages.js");
  const labels = labelsOf(await page());
  // Neither comments nor the names of a table are said.
  const code = [...(await firstModules())].map((text) => text.replace(/\/\*[^]*?\*\/|^\s*\/\/.*$|"[^"\n]+":/gm, ""));
  const said = [...labels, ...code.flatMap((text) => [...text.matchAll(/"([^"\n]+)"/g)].map(([, key]) => key))];
  assert.ok(["undo", "degrees", "step-1"].every((key) => said.includes(key)));
  assert.deepEqual(said.filter((key) => key in later), []);
});

/** The modules that the page has from the start: those that they import by name. The names in the table of keys Help alone says. */
async function firstModules(found = new Map(), file = "main.js") {
  const text = await module(file);
  found.set(file, text);
  for (const [, next] of text.matchAll(/^import .* from "\.\/(.+)";$/gm)) {
    if (!found.has(next)) await firstModules(found, next);
  }
  for (const table of ["messages.js", "keys.js"]) found.delete(table);
  return found.values();
}

test("the language that was chosen last is spoken, whichever is there first", async () => {
  const { say, speak } = await import("../../web/messages.js");
  Object.assign(globalThis, { document: { documentElement: {} } });
  await Promise.all([speak("de"), speak("en")]);
  assert.equal(say("open"), "Open");
  await Promise.all([speak("en"), speak("de")]);
  assert.equal(say("open"), "Öffnen");
  Reflect.deleteProperty(globalThis, "document");
});

test("each sample has a name in the tables", async () => {
  const [{ english }, { later }] = await Promise.all([import("../../web/messages.js"), import("../../web/later_messages.js")]);
  const samples = JSON.parse(await readFile(`${DIST}/${await version()}/samples/index.json`, "utf8"));
  for (const { name } of samples) assert.equal({ ...english, ...later }[`sample-${name}`], name);
});

for (const browser of /** @type {const} */ (["chromium", "firefox"])) {
  describe(`German in ${browser}`, () => {
    const session = useSession(browser);
    const folder = makeFolder();

    const openGerman = async () => {
      const tab = await session.newTab({ isFirst: true });
      await tab.prepare(GERMAN);
      return Editor.open(tab, `${session.url}?renderer=cpu`, "cpu");
    };

    /** @param {Editor} editor @returns {Promise<string>} */
    const lang = (editor) => editor.tab.evaluate("document.documentElement.lang");

    test("who wants it has it from the start, and every label is German", async () => {
      const editor = await openGerman();
      assert.equal(await lang(editor), "de");
      assert.equal(await editor.name(), "Goldfisch");
      for (const id of DIALOGS) {
        await openDialog(editor, id);
        await editor.tab.evaluate(`document.getElementById("${id}").close()`);
      }
      const { german } = await import("../../web/german.js");
      const labels = /** @type {[string, string][]} */ (await editor.tab.evaluate(`
        [...document.querySelectorAll("[data-text]")].map((element) => [element.dataset.text, element.textContent])
          .concat([...document.querySelectorAll("[data-label]")].map((element) => [element.dataset.label, element.ariaLabel]))`));
      const inGerman = (/** @type {string} */ key) => (key === "guide" ? /** @type {any} */ (german.guide)({ help: "?" }) : german[key]);
      for (const [key, text] of labels) assert.equal(text, inGerman(key), key);
      const names = await editor.tab.evaluate(`[...document.querySelectorAll("#palette button")].map((swatch) => swatch.title).slice(0, 2)`);
      assert.deepEqual(names, ["Rot (1)", "Orange (2)"]);
      assert.equal(await editor.tab.evaluate(`document.querySelector('[data-action="undo"]').title`), "Rückgängig (Strg+Z)");
      assert.deepEqual(editor.tab.faults, []);
    });

    test("Settings has both, and what was chosen stays", async () => {
      const tab = await session.newTab();
      /** @type {string[]} */
      const urls = [];
      tab.onRequest((url) => urls.push(url));
      const editor = await Editor.open(tab, `${session.url}?renderer=cpu`, "cpu");
      const isFetched = () => urls.some((url) => url.includes("/web/german"));
      assert.equal(await lang(editor), "en");
      assert.ok(!isFetched(), "nobody wants it");
      await editor.click("Colour");
      await tab.waitFor(`document.querySelector(".colors:popover-open") !== null`);
      await tab.press("Escape");
      await editor.openSample("Apple");
      await editor.scribble([[30, 40], [40, 45]], 72);
      await editor.until("Scribble 1 of 1 selected", () => tab.hold("Control", () => tab.press("a")));
      const selected = () => tab.evaluate(`document.getElementById("selected-count").textContent`);
      assert.equal(await selected(), "1 scribble");
      await editor.choose("Language", "de");
      await tab.waitFor(`document.documentElement.lang === "de"`);
      assert.ok(isFetched());
      assert.equal(await selected(), "1 Kritzel");
      assert.equal(await tab.evaluate(`document.querySelector("#samples h2").textContent`), "Beispiele");
      await tab.press("Escape");
      assert.equal(await tab.evaluate(`document.getElementById("zoom").textContent`).then((text) => /\d\u00a0%$/.test(String(text))), true);
      await editor.click("Farbe");
      await tab.waitFor(`document.querySelector(".colors:popover-open h2")?.textContent === "Farbe"`);
      const figures = await tab.evaluate(`[...document.querySelectorAll(".colors:popover-open output")].map((output) => output.textContent).join()`);
      assert.match(String(figures), /\b0,\d{3}\b/, "chroma has a comma");
      await tab.press("Escape");
      const again = await Editor.open(tab, `${session.url}?renderer=cpu`, "cpu");
      assert.equal(await lang(again), "de");
      await again.choose("Sprache", "en");
      await tab.waitFor(`document.documentElement.lang === "en"`);
      assert.equal(await tab.evaluate(`document.querySelector('[data-action="open"]').ariaLabel`), "Open");
      assert.deepEqual(tab.faults, []);
    });

    test("what is wrong with files and links, and what was left out, is German too", async () => {
      const editor = await openGerman();
      const { tab } = editor;
      const warned = async () => {
        await tab.waitFor(`!document.getElementById("alert").hidden`);
        const message = await editor.message();
        await tab.evaluate(`document.querySelector('[data-action="dismiss"]').click()`);
        return message;
      };
      for (const [name, [content, said]] of Object.entries(BAD_FILES)) {
        await tab.chooseFiles([await folder.write(name, content)], "Öffnen");
        assert.equal(await warned(), said);
      }
      await tab.evaluate(`location.hash = "#1.AAAA"`);
      assert.equal(await warned(), DAMAGED_LINK);
      const mixed = await folder.write("gemischt.svg", MIXED);
      await editor.until("gemischt.svg geöffnet; weggelassen: 1 Text, 2 Bilder", () => tab.chooseFiles([mixed], "Öffnen"));
      await editor.choose("Sprache", "en");
      await tab.waitFor(`document.documentElement.lang === "en"`);
      await editor.until("Opened gemischt.svg; left out: 1 text, 2 images", () => tab.chooseFiles([mixed]));
      assert.deepEqual(tab.faults, []);
    });

    test("its words fit, from a phone to a wide window", async () => {
      const editor = await openGerman();
      for (const [width, height] of /** @type {const} */ ([[320, 568], [360, 640], [600, 400], [913, 600], [1280, 800], [1333, 700], [1577, 900]])) {
        await editor.tab.resize(width, height);
        await editor.tab.evaluate(`document.getElementById("tracing-button").hidden = false`);
        assert.equal(await editor.tab.evaluate("document.documentElement.scrollWidth"), width);
        const beyond = await editor.tab.evaluate(`
          [...document.querySelectorAll(":is(body > header, #steps) *")]
            .filter((part) => part.checkVisibility() && !part.closest("svg, .unseen"))
            .filter((part) => part.getBoundingClientRect().right > innerWidth)
            .map((part) => part.outerHTML.slice(0, 80))`);
        assert.deepEqual(beyond, [], `${width} by ${height}`);
        const cut = await editor.tab.evaluate(`
          [...document.querySelectorAll("aside .kinds")].filter((group) => group.scrollWidth > group.clientWidth).map((group) => group.ariaLabel)`);
        assert.deepEqual(cut, [], `${width} by ${height}`);
        for (const id of DIALOGS) {
          await openDialog(editor, id);
          const [inner, outer] = /** @type {number[]} */ (await editor.tab.evaluate(`{
            const dialog = document.getElementById("${id}");
            const widths = [dialog.scrollWidth, dialog.clientWidth];
            dialog.close();
            widths;
          }`));
          assert.ok(outer > 0 && inner <= outer, `${id} at ${width}: ${inner} in ${outer}`);
        }
        await editor.tab.evaluate(`document.getElementById("settings").showPopover()`);
        const settings = await editor.tab.evaluate(`{
          const panel = document.getElementById("settings");
          const widths = [panel.scrollWidth <= panel.clientWidth, panel.getBoundingClientRect().left >= 0];
          panel.hidePopover();
          widths;
        }`);
        assert.deepEqual(settings, [true, true], `settings at ${width}`);
      }
      assert.deepEqual(editor.tab.faults, []);
    });
  });
}
