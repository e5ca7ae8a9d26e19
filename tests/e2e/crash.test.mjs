// A browser that is killed at any moment comes up with the drawing as it was, short of the stroke in hand at most.
// KILLS=100 in the environment asks for more kills than the usual few; SEED for other moments.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { launchIn } from "./browsers.mjs";
import { DIST, Editor, makeFolder } from "./harness.mjs";
import { serve } from "./static_server.mjs";

/** Firefox takes longer to come up. */
const FEW = { chromium: 4, firefox: 2 };
const SEED = Number(process.env.SEED ?? 1);

/** The longer side of the viewBox of the drawing. */
const ROOMS = 200;
/** A kill comes at most this long after the page has come up, or has been asked for. */
const LATEST_MS = 1500;
/** One in so many kills comes while the page is coming up. */
const EARLY = 4;
/** A drawing with more scribbles than this is left for a fresh one. */
const MOST_SCRIBBLES = 60;

/** Numbers in 0..1 that a seed tells (mulberry32). @param {number} seed */
const numbers = (seed) => () => {
  seed = (seed + 0x6d2b79f5) | 0;
  let t = Math.imul(seed ^ (seed >>> 15), 1 | seed);
  t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
  return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32;
};

/** @param {number} ms */
const pause = (ms) => new Promise((wake) => setTimeout(wake, ms));

for (const browser of /** @type {const} */ (["chromium", "firefox"])) {
  describe(`${browser}, killed`, () => {
    const kills = Number(process.env.KILLS ?? FEW[browser]);
    /** @type {Awaited<ReturnType<typeof serve>>} */
    let served;
    const folder = makeFolder();
    before(async () => {
      served = await serve(DIST);
    });
    after(() => void served.server.close());

    /** Adds a stroke and tells how many there are. @param {Editor} editor */
    const strokes = async (editor) => {
      await editor.scribble([[30, 30], [50, 60]], ROOMS);
      return Number(/added, (\d+) in/.exec(await editor.status())?.[1]);
    };

    /**
     * Strokes until the browser is gone.
     * @param {Editor} editor
     * @param {() => number} random
     * @param {{begun: number, done: number}} count
     */
    const strokeOn = async (editor, random, count) => {
      for (;;) {
        const way = await editor.place([[20 + 60 * random(), 30], [20 + 60 * random(), 80]], ROOMS);
        count.begun++;
        await editor.drag(way);
        count.done++;
      }
    };

    test(`${kills} kills at moments of seed ${SEED}`, async (t) => {
      const random = numbers(SEED);
      const url = `${served.url}?renderer=cpu`;
      /** Strokes that there must be, and that there may be. */
      let [least, most] = [0, 0];
      let lost = 0;
      for (let kill = 0; kill < kills; kill++) {
        const { tab, kill: end } = await launchIn(browser, folder.path);
        t.after(end);
        if (kill % EARLY === EARLY - 1) {
          tab.goto(url).catch(() => undefined);
          await pause(LATEST_MS * random());
          await end();
          continue;
        }
        const editor = await Editor.open(tab, url, "cpu");
        if (kill > 0) {
          assert.equal(await editor.name(), "rooms.svg", `kill ${kill}`);
          const found = (await strokes(editor)) - 1;
          assert.ok(least <= found && found <= most, `kill ${kill}: ${found} of ${least} to ${most} strokes`);
          lost += found === least ? 1 : 0;
        }
        if (kill === 0 || most > MOST_SCRIBBLES) await editor.openDrawing("rooms");
        const before = await strokes(editor);
        await editor.kept();
        const count = { begun: 0, done: 0 };
        const stroking = strokeOn(editor, random, count).catch(() => undefined);
        await pause(LATEST_MS * random());
        await end();
        await stroking;
        // The last one that is done may be in hand still: it has just been let go.
        [least, most] = [before + Math.max(0, count.done - 1), before + count.begun];
        t.diagnostic(`kill ${kill}: ${count.done} of ${count.begun} strokes were done`);
      }
      t.diagnostic(`${lost} times the last stroke was lost`);
    });
  });
}
