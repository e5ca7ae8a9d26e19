// The drawings that come with the page: a dialog of thumbnails.

/** @typedef {{ file: string, name: string, credit: string }} Sample */

const FOLDER = new URL("../samples/", import.meta.url);

export class Samples {
  #dialog = /** @type {HTMLDialogElement} */ (document.getElementById("samples"));
  #open;
  #failed;

  /**
   * @param {import("./files.js").Open} open
   * @param {() => void} failed called where a sample cannot be fetched
   */
  constructor(open, failed) {
    this.#open = open;
    this.#failed = failed;
    this.#dialog.addEventListener("click", (event) => {
      if (event.target === this.#dialog) this.#dialog.close();
    });
  }

  /** Fetches the list and opens its first drawing. */
  async start() {
    const response = await fetch(new URL("index.json", FOLDER)).catch(() => null);
    if (!response?.ok) return this.#failed();
    const samples = /** @type {Sample[]} */ (await response.json());
    this.#dialog.querySelector("ul")?.replaceChildren(...samples.map((sample) => this.#item(sample)));
    if (samples[0]) await this.#choose(samples[0]);
  }

  show() {
    this.#dialog.showModal();
  }

  close() {
    this.#dialog.close();
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
    button.append(image, name, credit);
    button.addEventListener("click", () => this.#choose(sample));
    item.append(button);
    return item;
  }

  /** @param {Sample} sample */
  async #choose(sample) {
    this.#dialog.close();
    const response = await fetch(new URL(sample.file, FOLDER)).catch(() => null);
    if (!response?.ok) return this.#failed();
    this.#open(sample.name, new Uint8Array(await response.arrayBuffer()));
  }
}
