// The dialog of the drawings that come with the page: a gallery of their colourings, by kind. It has nothing of the page but what
// is handed to it, so that it is a file of its own.

import { button } from "./buttons.js";
import { makeDialog, openDialog } from "./dialogs.js";
import { make } from "./elements.js";

/** @typedef {import("./samples.js").Sample} Sample */

/**
 * @typedef {object} Shell what the dialog has of the page
 * @property {(key: string, values?: Record<string, unknown>) => string} say
 * @property {(root: ParentNode) => void} label puts words into elements, by their `data-text` and `data-label`
 * @property {(control: HTMLElement, label: string) => void} name
 * @property {() => Promise<Sample[]>} list
 * @property {(sample: Sample) => string} nameOf
 * @property {URL} folder where they are, with a picture of the colouring of each
 * @property {(sample: Sample, isColored: boolean) => unknown} open
 */

const CONTENT = `
  <div></div>
  <p class="credit" data-text="samples-credit"></p>`;

export class Gallery {
  #shell;
  #dialog;
  #gallery;

  /** @param {Shell} shell */
  constructor(shell) {
    this.#shell = shell;
    this.#dialog = makeDialog("samples", CONTENT, {}, shell.label);
    this.#gallery = /** @type {HTMLElement} */ (this.#dialog.querySelector("div"));
  }

  /** Fetches the list, the first time, and shows it. */
  async show() {
    if (!this.#gallery.hasChildNodes()) {
      const samples = await this.#shell.list();
      const kinds = [...new Set(samples.map(({ kind }) => kind))];
      this.#gallery.replaceChildren(...kinds.flatMap((kind) => this.#shelf(kind, samples)));
    }
    openDialog(this.#dialog);
  }

  /** The page speaks another language from now on. */
  forget() {
    this.#gallery.replaceChildren();
  }

  /**
   * @param {string} kind
   * @param {Sample[]} samples
   */
  #shelf(kind, samples) {
    const items = samples.filter((sample) => sample.kind === kind).map((sample) => this.#item(sample));
    const title = this.#shell.say(`kind-${kind}`);
    return [make("h3", {}, title), make("ul", { role: "list", ariaLabel: title }, ...items)];
  }

  /** @param {Sample} sample */
  #item(sample) {
    const { say, nameOf, folder } = this.#shell;
    const name = nameOf(sample);
    const src = new URL(sample.file.replace(/svg$/, "png"), folder).href;
    const colored = this.#choice(name, sample, true);
    colored.append(make("img", { alt: "", loading: "lazy", src }), make("span", {}, name));
    const lines = this.#choice(say("lines-of", { name }), sample, false);
    lines.append(say("lines-only"));
    return make("li", {}, colored, make("small", {}, sample.credit), lines);
  }

  /**
   * @param {string} name
   * @param {Sample} sample
   * @param {boolean} isColored
   */
  #choice(name, sample, isColored) {
    const choice = button("", () => {
      this.#dialog.close();
      this.#shell.open(sample, isColored);
    });
    this.#shell.name(choice, name);
    return choice;
  }
}
