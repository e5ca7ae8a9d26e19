// What takes long on the whole page: it is shown, and can be stopped.

const bar = /** @type {HTMLElement} */ (document.getElementById("busy"));
const words = /** @type {HTMLElement} */ (bar.querySelector("p"));

/** What takes longer than this is shown. */
const PATIENCE_MS = 100;

/** In this time what has changed is painted, in a page that is seen; one that is not has no frames to wait for. */
const PAINTED_MS = 32;

/** @type {ReturnType<typeof setTimeout> | undefined} */
let timer;

/** @param {string} text what goes on from now on */
export function begin(text) {
  end();
  words.textContent = text;
  timer = setTimeout(show, PATIENCE_MS);
}

/** It will take long: it is seen from now on. */
export async function expectLong() {
  show();
  await new Promise((wake) => setTimeout(wake, PAINTED_MS));
}

function show() {
  bar.hidden = false;
}

/** Whether it is seen. */
export function isBusy() {
  return !bar.hidden;
}

export function end() {
  clearTimeout(timer);
  bar.hidden = true;
}
