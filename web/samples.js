// The drawings that come with the page: a dialog of thumbnails.

/** @typedef {{ file: string, name: string, credit: string, scribbles?: string }} Sample */

const FOLDER = new URL("../samples/", import.meta.url);

export class Samples {
  #dialog = /** @type {HTMLDialogElement} */ (document.getElementById("samples"));
  #open;
  #failed;
  /** Counts what has been asked for: an answer that comes after a later question is dropped. */
  #choices = 0;

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
    const samples = /** @type {Sample[] | null} */ (await fetched("index.json", (response) => response.json()));
    if (!samples) return this.#failed();
    this.#dialog.querySelector("ul")?.replaceChildren(...samples.map((sample) => this.#item(sample)));
    if (samples[0] && this.#choices === 0) await this.#choose(samples[0]);
  }

  /** Something else is opened: what is still on its way comes too late. */
  overtake() {
    this.#choices++;
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
    const choice = ++this.#choices;
    const [bytes, work] = await Promise.all([
      fetched(sample.file, (response) => response.arrayBuffer()),
      sample.scribbles ? fetched(sample.scribbles, (response) => response.json()) : { scribbles: [] },
    ]);
    if (choice !== this.#choices) return;
    if (bytes && work) this.#open(sample.name, new Uint8Array(bytes), work.scribbles);
    else this.#failed();
  }
}

/**
 * A file of the samples' folder, or null where it cannot be had.
 * @template T
 * @param {string} file
 * @param {(response: Response) => Promise<T>} read
 */
async function fetched(file, read) {
  try {
    const response = await fetch(new URL(file, FOLDER));
    return response.ok ? await read(response) : null;
  } catch {
    return null;
  }
}
