// The way to the panels of colours, which are fetched when the first of them is opened. They have nothing of the page but
// what is handed to them, so that they are files of their own.

import { download, reading } from "./files.js";
import { formats } from "./formats.js";
import { haveRest } from "./lazy.js";
import { say } from "./messages.js";
import { currentColor, nameOf, swatches, used } from "./swatches.js";
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
 * @property {(swatch: Swatch) => string} nameOf
 * @property {(command: string, args?: unknown) => void} command
 * @property {(text: string) => void} done says what was done
 * @property {(file: File) => void} open
 * @property {(swatches: Swatch[], extension: string) => Promise<void>} save
 */

export class Colors {
  #engine;
  #open;
  /** @type {Promise<import("./color_panels.js").Panels> | undefined} */
  #loading;
  /** @type {import("./color_panels.js").Panels | undefined} */
  #panels;

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
  async show(id) {
    const button = /** @type {HTMLButtonElement} */ (document.getElementById(id));
    if (this.#panels) return;
    try {
      this.#panels = await (this.#loading ??= this.#load());
      this.#panels.open(button);
    } catch (fault) {
      console.warn(fault);
      this.#loading = undefined;
      failed(new Error(say("error-panel")));
    }
  }

  /** Another colour, or another palette. */
  follow() {
    this.#panels?.follow();
  }

  /** A scribble was drawn with the colour of the moment. */
  used() {
    used();
    this.#panels?.used();
  }

  /** Has the panels made anew when they are opened next, in the language of the page. */
  forget() {
    this.#panels?.remove();
    this.#panels = this.#loading = undefined;
  }

  async #load() {
    const [{ Panels }] = await Promise.all([import("./color_panels.js"), haveRest()]);
    return new Panels(this.#shell());
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
      nameOf,
      command: (command, args) => engine.command(command, args),
      done,
      open: (file) => this.#open(reading(file)),
      save: async (palette, extension) => {
        const list = palette.flatMap((swatch) => [swatch.color, nameOf(swatch)]);
        const file = await formats.palette(list, extension).catch(failed);
        if (!file) return;
        const name = `${say("palette")}.${extension}`;
        download(name, new Blob([file]));
        done(say("exported", { name }));
      },
    };
  }
}
