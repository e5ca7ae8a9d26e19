// The page without a connection, and what becomes of it when its host has another version: one whole version at a time.
import assert from "node:assert/strict";
import { createHash } from "node:crypto";
import { appendFile, cp, mkdtemp, readFile, readdir, rename, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, afterEach, before, beforeEach, describe, test } from "node:test";
import { launch } from "./browsers.mjs";
import { DIST, Editor, version } from "./harness.mjs";
import { hex } from "./picture.mjs";
import { serve } from "./static_server.mjs";

/** @typedef {import("./browsers.mjs").Tab} Tab */
/** @typedef {[number, number]} Point */

/** The longer side of the viewBox of `drawings/rooms.svg`, a way in its left room, and a place there. */
const ROOMS = 200;
const IN_LEFT_ROOM = /** @type {Point[]} */ ([[30, 30], [50, 60], [70, 40]]);
const LEFT_ROOM = /** @type {Point} */ ([20, 80]);

const RED = "#e5484d";

/** What the scripts of the other version leave behind, and its name. */
const MARK = "globalThis.isOther = true;";
const OTHER = "v-0123456789abcdef";

/** A host, whose folder can be given another version. */
class Host {
  static async start() {
    const folder = await mkdtemp(join(tmpdir(), "scumble-host-"));
    await cp(DIST, folder, { recursive: true });
    return new Host(folder, await serve(folder, { base: "/some/where/", isKept: true }));
  }

  /**
   * @param {string} folder
   * @param {Awaited<ReturnType<typeof serve>>} served
   */
  constructor(folder, { server, url }) {
    this.folder = folder;
    this.server = server;
    this.url = `${url}?renderer=cpu`;
  }

  /** The connection is gone. */
  stop() {
    this.server.close();
    this.server.closeAllConnections();
  }

  /** Puts another version in the place of the one that is there; the last file of it comes whole only with `finish`. */
  async replace() {
    const old = await version();
    const files = join(this.folder, OTHER);
    await rename(join(this.folder, old), files);
    const lazy = (await readdir(join(files, "web"))).filter((file) => file.startsWith("color_panels"));
    const scripts = ["pkg/files/scumble_files.js", ...lazy.map((file) => `web/${file}`)];
    for (const name of ["index.html", "worker.js"]) await this.#rewrite(name, (text) => text.replaceAll(old, OTHER));
    for (const path of scripts) await this.#change(join(OTHER, path));
    await this.#change("index.html", "");
    const last = join(files, scripts[0]);
    const whole = await readFile(last);
    await writeFile(last, "");
    return { finish: () => writeFile(last, whole) };
  }

  /**
   * Marks a file, and tells the worker of it.
   * @param {string} path
   * @param {string} [mark]
   */
  async #change(path, mark = MARK) {
    const file = join(this.folder, path);
    await appendFile(file, mark);
    const integrity = `sha256-${createHash("sha256").update(await readFile(file)).digest("base64")}`;
    const key = JSON.stringify(path === "index.html" ? "" : path);
    await this.#rewrite("worker.js", (text) => text.replace(new RegExp(`${key}:"[^"]*"`), () => `${key}:"${integrity}"`));
  }

  /**
   * @param {string} name
   * @param {(text: string) => string} edit
   */
  async #rewrite(name, edit) {
    const file = join(this.folder, name);
    await writeFile(file, edit(await readFile(file, "utf8")));
  }

  async close() {
    this.stop();
    await rm(this.folder, { recursive: true, force: true });
  }
}

/** @param {Tab} tab @returns {Promise<string>} the version that a page is of */
const versionOf = (tab) => tab.evaluate(`document.querySelector("script[src]").src.match(/v-[0-9a-f]+/)[0]`);

/** @param {Tab} tab @returns {Promise<string[]>} the versions that are kept */
const keptVersions = (tab) => tab.evaluate(`caches.keys().then((names) => names.map((name) => name.match(/v-[0-9a-f]+/)[0]))`);

/** Has the page look for another version, as it does when it comes into view. @param {Tab} tab */
const look = (tab) => tab.evaluate(`void document.dispatchEvent(new Event("visibilitychange"))`);

/** @param {Tab} tab */
const isReady = (tab) => tab.waitFor(`!document.getElementById("update").hidden`);

/**
 * Waits until the other version has taken over, in a page of the host's that is of no version: Chromium may wait without
 * end for one that is asked for while the worker before is being stopped.
 * @param {Tab} tab
 * @param {string} url the page's
 */
const isTaken = async (tab, url) => {
  await tab.goto(new URL("/", url).href);
  const isSo = () =>
    tab.evaluate(`navigator.serviceWorker.getRegistration("${url}").then(({ active, waiting }) => !waiting && active.state === "activated")`);
  for (let tries = 0; tries < 600 && !(await isSo()); tries++) await new Promise((wake) => setTimeout(wake, 100));
};

/** Has files fetched that the page does without until then, and tells whether they are the other version's. @param {Editor} editor */
const areLazyFilesOther = async (editor) => {
  await editor.openDrawing("shading");
  await editor.click("Colour");
  await editor.tab.waitFor(`document.querySelector(".colors:popover-open") !== null`);
  await editor.tab.press("Escape");
  return /** @type {Promise<boolean>} */ (editor.tab.evaluate(`globalThis.isOther === true`));
};

for (const browser of /** @type {const} */ (["chromium", "firefox"])) {
  describe(`versions of the page in ${browser}`, () => {
    /** @type {import("./browsers.mjs").Browser} */
    let program;
    /** @type {Host} */
    let host;
    before(async () => {
      program = await launch(browser);
    });
    after(() => program.close());
    beforeEach(async () => {
      host = await Host.start();
    });
    afterEach(() => host.close());

    /** A page whose version is kept. */
    const open = async () => {
      const editor = await Editor.open(await program.open(), host.url, "cpu");
      await editor.tab.waitFor(`navigator.serviceWorker.controller !== null`);
      return editor;
    };

    /**
     * Opens the page again and again: the browser takes a moment to see that others are closed.
     * @param {Tab} tab
     * @param {() => Promise<boolean>} isSo
     */
    const openUntil = async (tab, isSo) => {
      for (let tries = 0; tries < 50; tries++) {
        await Editor.open(tab, host.url, "cpu");
        if (await isSo()) return;
        await tab.goto("about:blank");
        await new Promise((wake) => setTimeout(wake, 100));
      }
    };

    /** @param {Editor} editor */
    const paint = async (editor) => {
      await editor.openDrawing("rooms");
      await editor.click("Red");
      await editor.scribble(IN_LEFT_ROOM, ROOMS);
      await editor.kept();
    };

    /** @param {Editor} editor */
    const colorOfRoom = async (editor) => {
      const [[x, y]] = await editor.place([LEFT_ROOM], ROOMS);
      return hex((await editor.picture()).at(x, y));
    };

    test("without a connection after the first load, drawings are opened, coloured, shared and kept", async () => {
      const editor = await open();
      host.stop();
      await paint(editor);
      assert.equal(await colorOfRoom(editor), RED);
      await editor.click("Share");
      await editor.tab.waitFor(`document.getElementById("share")?.open`);
      const link = await editor.tab.evaluate(`document.getElementById("link").value`);
      await editor.tab.press("Escape");
      const again = await Editor.open(editor.tab, host.url, "cpu");
      assert.equal(await colorOfRoom(again), RED);
      await again.openSample("Apple");
      const address = host.url + /** @type {string} */ (link).slice(String(link).indexOf("#"));
      const linked = await Editor.open(await editor.tab.beside(), address, "cpu");
      assert.equal(await linked.name(), "Shared drawing");
      assert.equal(await colorOfRoom(linked), RED);
      assert.deepEqual([...editor.tab.faults, ...linked.tab.faults], []);
    });

    if (browser === "chromium") {
      test("without a connection after the first load, pictures are exported", async () => {
        const editor = await open();
        host.stop();
        await paint(editor);
        for (const format of ["PNG", "SVG", "PDF"]) {
          await editor.click("Export");
          await editor.tab.click("radio", format);
          const path = await editor.tab.download(() => editor.tab.click("button", "Save file"));
          assert.ok((await readFile(path)).length > 500, format);
          await editor.tab.press("Escape");
        }
        assert.deepEqual(editor.tab.faults, []);
      });
    }

    test("another version comes whole, when it is asked for, and the drawing stays", async () => {
      const editor = await open();
      const old = await versionOf(editor.tab);
      await paint(editor);
      await (await host.replace()).finish();
      await look(editor.tab);
      await isReady(editor.tab);
      const beside = await Editor.open(await editor.tab.beside(), host.url, "cpu");
      assert.equal(await versionOf(beside.tab), old, "a page that is opened before");
      await editor.tab.click("button", "Reload");
      await editor.tab.waitFor(`document.querySelector("script[src]").src.includes("${OTHER}")`);
      await editor.tab.waitFor(`document.getElementById("status").textContent !== ""`);
      await editor.tab.toFront();
      assert.equal(await colorOfRoom(editor), RED);
      assert.equal(await areLazyFilesOther(editor), true, "files of the new page");
      assert.equal(await areLazyFilesOther(beside), false, "files of the page from before");
      assert.deepEqual((await keptVersions(editor.tab)).sort(), [OTHER, old].sort());
      assert.deepEqual([...editor.tab.faults, ...beside.tab.faults], []);

      await beside.tab.close();
      await openUntil(editor.tab, async () => (await keptVersions(editor.tab)).length === 1);
      assert.deepEqual(await keptVersions(editor.tab), [OTHER]);
      host.stop();
      const again = await Editor.open(editor.tab, host.url, "cpu");
      assert.equal(await versionOf(again.tab), OTHER);
    });

    test("another version is there once all pages are closed, and until then nothing of it", async () => {
      const editor = await open();
      const old = await versionOf(editor.tab);
      await (await host.replace()).finish();
      await look(editor.tab);
      await isReady(editor.tab);
      await editor.tab.click("button", "Not now");
      assert.equal(await areLazyFilesOther(editor), false);
      const again = await Editor.open(editor.tab, host.url, "cpu");
      assert.equal(await versionOf(again.tab), old);
      await isReady(again.tab);
      const blank = await editor.tab.beside();
      await editor.tab.close();
      await isTaken(blank, host.url);
      await openUntil(blank, async () => (await keptVersions(blank)).length === 1);
      assert.equal(await versionOf(blank), OTHER);
      // As a page that was asked for before and gets its script only now.
      await blank.evaluate(`{
        window.isBefore = true;
        const script = Object.assign(document.createElement("script"), { type: "module", src: "${old}/web/main.js" });
        script.setAttribute("onerror", "askAnew()");
        document.head.append(script);
      }`);
      await blank.waitFor(`!window.isBefore && document.getElementById("canvas")?.dataset.renderer`);
      assert.equal(await versionOf(blank), OTHER);
    });

    test("a version of which the host has only a part is not taken", async () => {
      const editor = await open();
      const { finish } = await host.replace();
      await editor.tab.evaluate(`navigator.serviceWorker.ready.then(async (registration) => {
        await registration.update().catch(() => {});
        const coming = registration.installing;
        if (coming) await new Promise((done) => coming.addEventListener("statechange", done));
      })`);
      assert.equal(await editor.tab.evaluate(`document.getElementById("update").hidden`), true);
      await paint(editor);
      assert.equal(await editor.tab.evaluate(`globalThis.isOther`), undefined);
      await finish();
      await look(editor.tab);
      await isReady(editor.tab);
    });

    test("where the host keeps failing, the page is asked for anew once, and says so", async () => {
      const { tab } = await open();
      await host.replace();
      // All scripts but the first, so that it is there and what it imports is not.
      const folder = join(host.folder, OTHER, "web");
      const imported = (await readdir(folder)).filter((file) => file.startsWith("chunk-"));
      await Promise.all(imported.map((file) => rm(join(folder, file))));
      await tab.evaluate(`caches.keys().then((names) => Promise.all(names.map((name) => caches.delete(name))))`);
      await tab.goto(host.url);
      await tab.waitFor(`document.body.textContent.includes("could not be loaded")`);
      assert.equal(await tab.evaluate(`performance.getEntriesByType("navigation")[0].type`), "reload");
    });

    test("the page can be installed", async () => {
      const editor = await open();
      const { start, scope, display, icons } = await editor.tab.evaluate(`{
        const { href } = document.querySelector("link[rel=manifest]");
        const size = async ({ src, purpose = "any" }) => {
          const image = new Image();
          image.src = new URL(src, href);
          await image.decode();
          return [image.naturalWidth, image.naturalHeight, purpose].join(" ");
        };
        (async () => {
          const manifest = await (await fetch(href)).json();
          const [start, scope] = [manifest.start_url, manifest.scope].map((url) => new URL(url, href).href);
          const icons = await Promise.all(manifest.icons.filter(({ type }) => type === "image/png").map(size));
          return { start, scope, display: manifest.display, icons };
        })();
      }`);
      const page = host.url.split("?")[0];
      assert.deepEqual({ start, scope, display }, { start: page, scope: page, display: "standalone" });
      assert.deepEqual(icons, ["192 192 any", "512 512 any", "512 512 maskable"]);
    });
  });
}
