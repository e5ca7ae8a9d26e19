// What takes long on the whole page: it is shown, and can be stopped.

const bar = /** @type {HTMLElement} */ (document.getElementById("busy"));
const words = /** @type {HTMLElement} */ (bar.querySelector("p"));

/** What takes longer than this is shown. */
const PATIENCE_MS = 100;

/** In this time what has changed is painted, in a page that is seen; one that is not has no frames to wait for. */
const PAINTED_MS = 32;

/** Who presses where the bar was until so long ago means the bar. */
const GRACE_MS = 400;

/** Until when that holds, and where. */
let grace = { until_ms: 0, place: new DOMRect() };

/** What goes on, in words, the latest last. @type {Map<string, string>} */
const going = new Map();

/** @type {ReturnType<typeof setTimeout> | undefined} */
let timer;

/**
 * @param {string} what goes on from now on
 * @param {string} text the same, for people
 */
export function begin(what, text) {
  end(what);
  going.set(what, text);
  follow();
}

/** It will take long: it is seen from now on. */
export async function expectLong() {
  show();
  await new Promise((wake) => setTimeout(wake, PAINTED_MS));
}

/** @param {string} what has come to its end */
export function end(what) {
  if (going.delete(what)) follow();
}

/** Whether it is seen. @param {string} what */
export function isBusy(what) {
  return !bar.hidden && going.has(what);
}

function follow() {
  clearTimeout(timer);
  if (going.size === 0) return hide();
  words.textContent = [...going.values()].pop() ?? "";
  if (bar.hidden) timer = setTimeout(show, PATIENCE_MS);
}

function show() {
  bar.hidden = false;
}

function hide() {
  if (bar.hidden) return;
  grace = { until_ms: performance.now() + GRACE_MS, place: bar.getBoundingClientRect() };
  bar.hidden = true;
}

// A page that is busy hears of a press late: one on Cancel is none on what lies under it.
window.addEventListener("pointerdown", (event) => {
  const { left, right, top, bottom } = grace.place;
  const { timeStamp, clientX, clientY } = event;
  const isThere = clientX >= left && clientX <= right && clientY >= top && clientY <= bottom;
  if (isThere && timeStamp < grace.until_ms) event.stopImmediatePropagation();
}, true);
