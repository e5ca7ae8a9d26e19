// The two panels of colours: the picker of the colour to scribble with, and the palette.

import { button } from "./buttons.js";
import { make } from "./elements.js";
import { panel } from "./panel.js";
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

  /** @param {string} opener the id of its button */
  open(opener) {
    const panel = opener === "color" ? this.#pickerPanel : this.#palettePanel;
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
