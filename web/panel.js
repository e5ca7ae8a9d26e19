// What the panels beside the rail have in common, which are fetched when they are opened.

import { button } from "./buttons.js";
import { make } from "./elements.js";

/**
 * A panel that a button opens and closes.
 * @param {string} id
 * @param {string} opener its id
 * @param {string} label
 * @param {string} close what the button is called that closes it
 * @param {() => void} begin called before it is shown
 */
export function panel(id, opener, label, close, begin) {
  const panel = make("div", { id, className: "panel colors", popover: "auto", role: "dialog", "aria-label": label });
  panel.append(make("header", {}, make("h2", {}, label), button(close, () => panel.hidePopover(), "close")));
  panel.addEventListener("beforetoggle", (event) => {
    if (/** @type {ToggleEvent} */ (event).newState === "open") begin();
  });
  panel.addEventListener("toggle", (event) => {
    if (/** @type {ToggleEvent} */ (event).newState === "open") first(panel)?.focus();
  });
  for (const kind of ["keydown", "paste"]) panel.addEventListener(kind, keepInField);
  document.body.append(panel);
  document.getElementById(opener)?.setAttribute("popovertarget", id);
  return panel;
}

/** @param {HTMLElement} panel */
function first(panel) {
  return /** @type {HTMLElement | null} */ (panel.querySelector("[role=option][tabindex='0'], [type=range]"));
}

/** Who writes into a field means neither the drawing's shortcuts nor its clipboard. @param {Event} event */
function keepInField(event) {
  if (event.target instanceof HTMLInputElement && event.target.type === "text") event.stopPropagation();
}
