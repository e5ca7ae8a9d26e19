// What a hand draws is what is kept, however fast it is.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { describe, test } from "node:test";
import { useSession } from "./harness.mjs";

/** The longer side of a page, in du. */
const PAGE_DU = 1024;

/** As a pen reports. */
const RATE_HZ = 240;

/** A second of hatching, of which each sample is an end. @type {[number, number][]} */
const HATCHING = Array.from({ length: RATE_HZ }, (_, i) => [300 + 2 * i, 500 + (i % 2) * 30]);

/**
 * How far a place is from a way, at the least.
 * @param {[number, number]} place
 * @param {[number, number][]} way
 */
function distance([x, y], way) {
  const distances = way.slice(1).map(([x1, y1], i) => {
    const [x0, y0] = way[i];
    const [dx, dy] = [x1 - x0, y1 - y0];
    const part = Math.max(0, Math.min(1, ((x - x0) * dx + (y - y0) * dy) / (dx * dx + dy * dy)));
    return Math.hypot(x0 + part * dx - x, y0 + part * dy - y);
  });
  return Math.min(...distances);
}

/** Notes, in the page, how many samples the pointer's moves bring at once, at the most. */
const NOTE = `
  window.atOnce = 0;
  addEventListener("pointermove", (event) => void (window.atOnce = Math.max(window.atOnce, event.getCoalescedEvents().length)), true);`;

describe("strokes", () => {
  const session = useSession("chromium");

  test("a stroke goes through every sample of a pen at 240 Hz", async () => {
    const editor = await session.open("cpu");
    await editor.tab.evaluate(NOTE);
    const way = await editor.place(HATCHING, PAGE_DU);
    await editor.until("Scribble added", () => editor.trace(way, RATE_HZ));
    assert.ok((await editor.tab.evaluate("window.atOnce")) > 1, "more than one between two frames");
    const file = await readFile(await editor.tab.download(() => editor.click("Save")), "utf8");
    /** @type {{scribbles: {points: [number, number][]}[]}} */
    const { scribbles: [{ points }] } = JSON.parse(file);
    const worst = Math.max(...HATCHING.map((place) => distance(place, points)));
    // A mouse reports whole pixels here.
    assert.ok(worst < 2, `${worst} du`);
    assert.deepEqual(editor.tab.faults, []);
  });
});
