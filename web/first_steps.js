// The guide of the first visit: three steps beside the drawing, each of which goes on when it is done. Nothing waits for
// it, and who does a later thing first has done the earlier ones.

import { say } from "./messages.js";
import { remember, remembered } from "./remember.js";

/** Where the browser keeps that it was shown. */
const SHOWN = "scumble-first-steps";

/** What there is to do, and the effects of the module that tell that it was done. */
const STEPS = [
  ["color", "scribble-added"],
  ["scribble-added"],
  ["scribble-added", "scribbles-erased", "scribbles-rubbed", "undone"],
];

const bar = /** @type {HTMLElement} */ (document.getElementById("steps"));
const told = /** @type {HTMLElement} */ (bar.querySelector("[role=status]"));

/** Which step it is at, from 0; none where it is not shown. */
let at = -1;

/** Shows it, unless this browser has had it, or may keep nothing: there it would be shown each time. */
export function beginFirstSteps() {
  if (remembered(SHOWN) === null) showFirstSteps();
}

export function showFirstSteps() {
  remember(SHOWN, "yes");
  bar.hidden = false;
  go(0);
}

/**
 * Puts it away.
 * @returns whether it was there
 */
export function skipFirstSteps() {
  const was = at >= 0;
  if (bar.contains(document.activeElement)) document.getElementById("canvas")?.focus();
  bar.hidden = true;
  at = -1;
  delete document.body.dataset.step;
  return was;
}

/**
 * Follows what is done.
 * @param {string} effect of the module
 * @returns whether that was the last step
 */
export function followFirstSteps(effect) {
  if (at < 0) return false;
  const isDone = (/** @type {number} */ step) => step <= Math.max(at, 1) && STEPS[step].includes(effect);
  const done = [2, 1, 0].find(isDone) ?? -1;
  if (done < at) return false;
  if (done + 1 === STEPS.length) return skipFirstSteps();
  go(done + 1);
  return false;
}

/** @param {number} step */
function go(step) {
  at = step;
  // What belongs to the step is marked by the style sheet.
  document.body.dataset.step = String(step + 1);
  for (const [i, item] of bar.querySelectorAll("li").entries()) {
    item.classList.toggle("done", i < step);
    if (i === step) item.setAttribute("aria-current", "step");
    else item.removeAttribute("aria-current");
  }
  told.textContent = say("step", { place: step + 1, text: say(`step-${step + 1}`) });
}
