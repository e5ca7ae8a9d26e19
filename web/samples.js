// The drawings that come with the page: a gallery of their colourings, by kind.

import { openDialog } from "./dialogs.js";
import { button, make } from "./elements.js";
import { name as label, say } from "./messages.js";

/** @typedef {{ kind: string, file: string, name: string, credit: string }} Sample its kind and its name in English, as `index.json` has them */

const FOLDER = new URL("../samples/", import.meta.url);

/** What a page begins with where nobody has worked. */
export const FIRST = { file: "goldfish.svg", name: "Goldfish" };

/** @param {{name: string}} sample */
export const sampleName = ({ name }) => say(`sample-${name}`);

export class Samples {
  #dialog = /** @type {HTMLDialogElement} */ (document.getElementById("samples"));
  #gallery = /** @type {HTMLElement} */ (this.#dialog.querySelector("div"));
  #open;

  /** @param {(sample: Sample, isColored: boolean) => unknown} open */
  constructor(open) {
    this.#open = open;
  }

  /** Fetches the list, the first time, and shows it. */
  async show() {
    if (!this.#gallery.hasChildNodes()) {
      const samples = /** @type {Sample[]} */ (await fetched("index.json", (response) => response.json()));
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
    const title = say(`kind-${kind}`);
    return [make("h3", {}, title), make("ul", { role: "list", ariaLabel: title }, ...items)];
  }

  /** @param {Sample} sample */
  #item(sample) {
    const name = sampleName(sample);
    const src = new URL(sample.file.replace(/svg$/, "png"), FOLDER).href;
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
      this.#open(sample, isColored);
    });
    label(choice, name);
    return choice;
  }
}

/**
 * A sample as work: its lines alone, or with scribbles.
 * @param {string} file
 * @param {boolean} [isColored]
 */
export async function sampleWork(file, isColored = false) {
  const ending = isColored ? "colored.work" : "work";
  const buffer = await fetched(file.replace(/svg$/, ending), (response) => response.arrayBuffer());
  return new Uint8Array(buffer);
}

/**
 * A file of the samples' folder.
 * @template T
 * @param {string} file
 * @param {(response: Response) => Promise<T>} read
 */
async function fetched(file, read) {
  try {
    const response = await fetch(new URL(file, FOLDER));
    if (response.ok) return await read(response);
  } catch (fault) {
    console.warn(fault);
  }
  throw new Error(say("error-samples"));
}
