// The way to the panels of colours, which are fetched when the first of them is opened. They have nothing of the page but
// what is handed to them, so that they are files of their own.

import { download, reading } from "./files.js";
import { formats } from "./formats.js";
import { lazily } from "./lazy.js";
import { say } from "./messages.js";
import { MOST_SWATCHES, currentColor, nameOf, swatches, used } from "./swatches.js";
import { done, failed } from "./toolbar.js";

/** @typedef {import("./swatches.js").Swatch} Swatch */
/** @typedef {"colour" | "edit-palette"} Which panel, by what its button does */

/**
 * @typedef {object} Shell what the panels have of the page
 * @property {(key: string, values?: Record<string, unknown>) => string} say
 * @property {(model: string, numbers: number[]) => Uint32Array} colors of numbers, three each: 0xrrggbb, and 1 << 24 for those beyond sRGB
 * @property {(model: string, color: string) => number[]} numbers of a colour #rrggbb
 * @property {() => string} color what is scribbled with: #rrggbb, none, or a tone
 * @property {() => Swatch[]} swatches
 * @property {number} most of them that are shown
 * @property {(swatch: Swatch) => string} nameOf
 * @property {(command: string, args?: unknown) => void} command
 * @property {(text: string) => void} done says what was done
 * @property {(file: File) => void} open
 * @property {typeof formats.palette} file a palette, by its colours and their names in turn
 * @property {typeof download} download
 * @property {(fault: unknown) => void} failed
 */

export class Colors {
  #engine;
  #open;
  #panels = lazily(
    () => import("./color_panels.js"),
    ({ Panels }) => new Panels(this.#shell()),
  );

  /**
   * @param {import("./engine.js").Engine} engine
   * @param {(file: {name: string, bytes: Promise<Uint8Array>}) => void} open a palette
   */
  constructor(engine, open) {
    this.#engine = engine;
    this.#open = open;
  }

  /**
   * Opens a panel for the first time: from then on its button does.
   * @param {string} id of the button
   */
  show(id) {
    if (!this.#panels.now) this.#panels.use((panels) => panels.open(id));
  }

  /** Another colour, or another palette. */
  follow() {
    this.#panels.now?.follow();
  }

  /** A scribble was drawn with the colour of the moment. */
  used() {
    used();
    this.#panels.now?.used();
  }

  /** Has the panels made anew when they are opened next, in the language of the page. */
  forget() {
    this.#panels.forget();
  }

  /** @returns {Shell} */
  #shell() {
    const engine = this.#engine;
    return {
      say,
      colors: (model, numbers) => engine.colors(model, numbers),
      numbers: (model, color) => engine.colorNumbers(model, color),
      color: currentColor,
      swatches,
      most: MOST_SWATCHES,
      nameOf,
      command: (command, args) => engine.command(command, args),
      done,
      open: (file) => this.#open(reading(file)),
      file: formats.palette,
      download,
      failed,
    };
  }
}
