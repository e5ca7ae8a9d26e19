// The drawings that come with the page: a dialog of thumbnails.

import { openDialog } from "./dialogs.js";
import { say } from "./messages.js";

/** @typedef {{ file: string, name: string, credit: string }} Sample */

const FOLDER = new URL("../samples/", import.meta.url);

export class Samples {
  #dialog = /** @type {HTMLDialogElement} */ (document.getElementById("samples"));
  #open;
  /** As the list has them, in English. @type {Sample[]} */
  #samples = [];

  /** @param {(sample: Sample) => unknown} open */
  constructor(open) {
    this.#open = open;
  }

  /**
   * Fetches the list.
   * @returns {Promise<Sample[]>}
   */
  async list() {
    this.#samples = /** @type {Sample[]} */ (await fetched("index.json", (response) => response.json()));
    return this.label();
  }

  /** Shows them by their names in the language of the page. */
  label() {
    const samples = this.#samples.map((sample) => ({ ...sample, name: say(`sample-${sample.name}`) }));
    this.#dialog.querySelector("ul")?.replaceChildren(...samples.map((sample) => this.#item(sample)));
    return samples;
  }

  show() {
    openDialog(this.#dialog);
  }

  /** @param {Sample} sample */
  #item(sample) {
    const item = document.createElement("li");
    const button = document.createElement("button");
    const [image, name, credit] = [new Image(), document.createElement("span"), document.createElement("small")];
    button.type = "button";
    button.setAttribute("aria-label", sample.name);
    image.src = new URL(sample.file, FOLDER).href;
    image.alt = "";
    image.loading = "lazy";
    name.textContent = sample.name;
    credit.textContent = sample.credit;
    button.append(image, name);
    button.addEventListener("click", () => {
      this.#dialog.close();
      this.#open(sample);
    });
    item.append(button, credit);
    return item;
  }
}

/**
 * A sample as work.
 * @param {string} file
 */
export async function sampleWork(file) {
  const buffer = await fetched(file.replace(/\.svg$/, ".work"), (response) => response.arrayBuffer());
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
