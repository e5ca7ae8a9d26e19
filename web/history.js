// The panel of what was done to the drawing, one step after the other, to look at and to go back and forth in. It has nothing
// of the page but what is handed to it, so that it is a file of its own.

import { make } from "./elements.js";
import { panel } from "./panel.js";

/**
 * @typedef {object} Shell what the panel has of the page
 * @property {(key: string, values?: Record<string, unknown>) => string} say
 * @property {(color: string) => string} nameOf a colour, #rrggbb or none
 * @property {(text: string) => void} done says what was done
 * @property {() => {steps: string[], place: number} | undefined} history what was done, as keys of messages, and in which colours, in turn; and how many of these steps are not taken back
 * @property {(place: number) => void} go to where so many of them are not
 */

/** So many steps a key goes up or down in the list. @type {Record<string, number>} */
const WAYS = { ArrowUp: -1, ArrowDown: 1, PageUp: -10, PageDown: 10, Home: -Infinity, End: Infinity };

export class History {
  #shell;
  #panel;
  #list = make("ul", { className: "steps", role: "listbox" });
  /** @type {string[]} What is in the list after its beginning: keys and colours. */
  #steps = [];
  /** How many of them are not taken back. */
  #place = 0;

  /** @param {Shell} shell */
  constructor(shell) {
    this.#shell = shell;
    this.#list.ariaLabel = shell.say("history");
    this.#list.addEventListener("keydown", (event) => this.#key(event));
    this.#list.addEventListener("click", ({ target }) => this.#go(/** @type {Element} */ (target).closest("li")));
    this.#panel = panel("history-panel", "history", shell.say("history"), shell.say("close"), () => this.#render());
    this.#panel.append(this.#list);
  }

  open() {
    this.#panel.showPopover();
  }

  remove() {
    this.#panel.remove();
  }

  /** Something was done, or taken back. */
  follow() {
    if (this.#panel.matches(":popover-open")) this.#render();
  }

  #render() {
    const { steps, place } = this.#shell.history() ?? { steps: [], place: 0 };
    const isSame = String(steps) === String(this.#steps) && this.#list.childElementCount > 0;
    const hadFocus = this.#list.contains(document.activeElement);
    if (!isSame) this.#fill(steps);
    // Others are marked already.
    const options = this.#options();
    const [from, to] = isSame ? [Math.min(place, this.#place), Math.max(place, this.#place)] : [0, options.length - 1];
    for (let i = from; i <= to; i++) this.#mark(options[i], i - place);
    this.#place = place;
    options[place].scrollIntoView({ block: "nearest" });
    if (hadFocus && !isSame) options[place].focus();
  }

  /** @param {string[]} steps */
  #fill(steps) {
    this.#steps = steps;
    const options = ["history-start", "", ...steps].flatMap((key, i, all) => (i % 2 === 0 ? [this.#option(key, all[i + 1])] : []));
    this.#list.replaceChildren(...options);
  }

  /**
   * @param {string} key
   * @param {string} color with which it was done, if there is one
   */
  #option(key, color) {
    const { say, nameOf } = this.#shell;
    const option = make("li", { role: "option" }, say(key));
    if (color) {
      const chip = make("i", { className: color === "none" ? "swatch none" : "swatch", title: nameOf(color) });
      chip.style.setProperty("--swatch", color);
      option.append(chip);
    }
    return option;
  }

  /**
   * @param {HTMLElement} option
   * @param {number} after how many steps it comes after where the drawing is
   */
  #mark(option, after) {
    option.ariaSelected = String(after === 0);
    option.tabIndex = after === 0 ? 0 : -1;
    option.classList.toggle("later", after > 0);
    const chip = option.querySelector("i");
    const text = chip ? `${option.textContent}, ${chip.title}` : option.textContent;
    option.ariaLabel = after > 0 ? this.#shell.say("step-undone", { text }) : text;
  }

  #options() {
    return /** @type {HTMLElement[]} */ ([...this.#list.children]);
  }

  /** @param {HTMLElement | null} option */
  #go(option) {
    if (!option) return;
    const { say, done, go } = this.#shell;
    const place = this.#options().indexOf(option);
    go(place);
    done(say("went-to", { text: option.textContent }));
    this.#options()[place]?.focus();
  }

  /** @param {KeyboardEvent} event */
  #key(event) {
    const option = /** @type {HTMLElement} */ (event.target);
    const way = WAYS[event.key];
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key === "Enter" || event.key === " ") this.#go(option);
    else if (way !== undefined) this.#look(this.#options().indexOf(option) + way);
    else return;
    event.preventDefault();
  }

  /** @param {number} place of the option that is given the focus */
  #look(place) {
    const options = this.#options();
    options[Math.min(Math.max(place, 0), options.length - 1)].focus();
  }
}
