// Buttons that scripts make, with words or symbols on them; only what is fetched later has such.

import { make } from "./elements.js";

/**
 * A symbol of the page's.
 * @param {string} name
 */
function icon(name) {
  const space = "http://www.w3.org/2000/svg";
  const svg = document.createElementNS(space, "svg");
  const use = document.createElementNS(space, "use");
  svg.setAttribute("aria-hidden", "true");
  use.setAttribute("href", `#i-${name}`);
  svg.append(use);
  return svg;
}

/**
 * @param {string} text
 * @param {() => void} act
 * @param {string} [symbol] shown in place of the text
 */
export function button(text, act, symbol) {
  const content = symbol ? icon(symbol) : text;
  const made = make("button", { type: "button", title: symbol ? text : "", className: symbol ? "icon" : "" }, content);
  if (symbol) made.ariaLabel = text;
  made.addEventListener("click", act);
  return made;
}
