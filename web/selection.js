// What is selected, over the canvas: its frame with handles, the rectangle that selects, and the bar of what can be done.

import { name, say } from "./messages.js";

const element = (/** @type {string} */ id) => /** @type {HTMLElement} */ (document.getElementById(id));
const [frame, marquee, bar, count] = ["frame", "marquee", "selected", "selected-count"].map(element);
const button = (/** @type {string} */ action) =>
  /** @type {HTMLElement} */ (bar.querySelector(`[data-action="${action}"]`));

/** A rectangle: left, top, width and height in CSS pixels of the canvas. @typedef {Float64Array | undefined} Box */

/**
 * @typedef {object} Selection
 * @property {number} scribbles how many are selected
 * @property {number} lines likewise
 * @property {boolean} hidden whether these lines are
 * @property {Box} frame around it
 * @property {number} handles of the frame: corners, then sides
 * @property {Box} marquee in which things are being selected
 */

/** @type {Selection | undefined} */
let shown;

/** @param {Selection} state */
export function showSelection(state) {
  const { scribbles, lines, handles } = (shown = state);
  lay(frame, state.frame);
  frame.dataset.handles = String(handles);
  lay(marquee, state.marquee);
  for (const action of ["backward", "forward", "duplicate"]) button(action).hidden = scribbles === 0;
  button("hide").hidden = lines === 0;
  labelSelection();
  showBar(scribbles + lines > 0);
}

/** Says what is selected, and what can be done with it, in the page's language. */
export function labelSelection() {
  if (!shown) return;
  const { scribbles, lines, hidden } = shown;
  name(button("hide"), say(hidden ? "unhide" : "hide"));
  count.textContent = say("things", { scribbles, lines });
}

/**
 * @param {HTMLElement} element
 * @param {Box} box
 */
function lay(element, box) {
  element.hidden = !box;
  if (!box) return;
  const [x, y, width, height] = box;
  Object.assign(element.style, { transform: `translate(${x}px, ${y}px)`, width: `${width}px`, height: `${height}px` });
}

/** Whether a press adds to what is selected, as one with Shift does: fingers have no Shift. */
export function selectsMore() {
  return button("select-more").ariaPressed === "true";
}

/** From now on, or no longer; a bar that goes ends it. */
export function toggleMore() {
  setMore(!selectsMore());
}

/** @param {boolean} isMore */
function setMore(isMore) {
  button("select-more").setAttribute("aria-pressed", String(isMore));
}

/** A bar that goes leaves the focus to the canvas. @param {boolean} isShown */
function showBar(isShown) {
  if (!isShown) {
    setMore(false);
    if (bar.contains(document.activeElement)) element("canvas").focus();
  }
  bar.hidden = !isShown;
}
