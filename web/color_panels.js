// The two panels of colours: the picker of the colour to scribble with, and the palette.

import { button, make } from "./elements.js";
import { PaletteEditor } from "./palette.js";
import { Picker } from "./picker.js";

/** @typedef {import("./colors.js").Shell} Shell */

export class Panels {
  #shell;
  #picker;
  #palette;
  /** What the picker has given and nobody has scribbled with takes the place of itself, so that X goes back to the one before. */
  #given = "";
  #add;
  #pickerPanel;
  #palettePanel;

  /** @param {Shell} shell */
  constructor(shell) {
    this.#shell = shell;
    this.#picker = new Picker(shell, (color) => this.#give(color), () => shell.command("settle"));
    this.#palette = new PaletteEditor(shell);
    this.#add = button(shell.say("add-swatch"), () => this.#palette.add());
    this.#pickerPanel = panel("color-panel", "color", shell.say("colour"), shell.say("close"), () => this.#begin());
    this.#pickerPanel.append(this.#picker.element, make("div", { className: "line" }, this.#add));
    this.#palettePanel = panel("palette-panel", "edit-palette", shell.say("palette"), shell.say("close"), () => this.#palette.begin());
    this.#palettePanel.append(this.#palette.element);
  }

  /** @param {HTMLButtonElement} opener */
  open(opener) {
    const panel = opener.id === "color" ? this.#pickerPanel : this.#palettePanel;
    panel.showPopover();
  }

  remove() {
    this.#pickerPanel.remove();
    this.#palettePanel.remove();
  }

  follow() {
    this.#showColor();
    this.#palette.follow();
  }

  used() {
    this.#given = "";
  }

  #begin() {
    this.#given = "";
    this.#picker.begin(this.#shell.color());
    this.#showColor();
  }

  /** A tone, or none, is no colour for a swatch. */
  #showColor() {
    const color = this.#shell.color();
    this.#picker.show(color);
    this.#add.disabled = !color.startsWith("#");
  }

  /** @param {string} color */
  #give(color) {
    const isOnItsWay = this.#given !== "" && this.#given === this.#shell.color();
    this.#given = color;
    this.#shell.command(isOnItsWay ? "tune-color" : "color-sought", color);
  }
}

/**
 * A panel that a button opens and closes.
 * @param {string} id
 * @param {string} opener its id
 * @param {string} label
 * @param {string} close what the button is called that closes it
 * @param {() => void} begin called before it is shown
 */
function panel(id, opener, label, close, begin) {
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
