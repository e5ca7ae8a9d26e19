// The picture under the lines: an image below the canvas, which is transparent then where nothing is coloured. It is a
// help alone: no gesture reaches it, and no exported picture has it.

import { say } from "./messages.js";

/** @typedef {import("./drawings.js").Images} Images */
/** @typedef {{image?: number, opacity?: number, width: number, height: number}} State which one the module wants, and the page's size in du */

const page = /** @type {HTMLElement} */ (document.getElementById("under"));
const element = /** @type {HTMLImageElement} */ (page.querySelector("img"));
const box = /** @type {HTMLInputElement} */ (document.querySelector("[data-setting=tracing]"));

export class Tracing {
  #engine;
  /** @type {Images} Those of the drawing that is shown. */
  #images = new Map();
  /** @type {State} */
  #state = { width: 0, height: 0 };
  /** @type {Uint8Array | undefined} What the element shows. */
  #shown;

  /** @param {import("./engine.js").Engine} engine */
  constructor(engine) {
    this.#engine = engine;
    box.addEventListener("change", () => this.#update());
  }

  /** The picture of the drawing that is shown, whether it is seen or not. */
  get image() {
    const { image: number = 0 } = this.#state;
    const bytes = this.#images.get(number);
    return bytes && { number, bytes };
  }

  /** @param {Uint8Array<ArrayBuffer>} image for the drawing that is shown */
  lay(image) {
    // The module may know one more, of which the storage has lost the file.
    const number = 1 + Math.max(this.#state.image ?? 0, ...this.#images.keys());
    this.#images.set(number, image);
    box.checked = true;
    this.#engine.command("trace", number);
  }

  /** @param {State} state */
  follow(state) {
    this.#state = state;
    this.#update();
  }

  /** @param {Images} images of the drawing that is shown */
  show(images) {
    this.#images = images;
    this.#update();
  }

  /** @param {Float64Array} css_from_du */
  look(css_from_du) {
    page.style.transform = `matrix(${css_from_du})`;
  }

  #update() {
    const bytes = this.image?.bytes;
    this.#load(bytes);
    const { width, height, opacity } = this.#state;
    Object.assign(page.style, { width: `${width}px`, height: `${height}px` });
    element.style.opacity = String(opacity);
    const isHidden = !bytes || !box.checked;
    if (isHidden === page.hidden) return;
    page.hidden = isHidden;
    this.#engine.command("paper", isHidden);
  }

  /** @param {Uint8Array<ArrayBuffer> | undefined} bytes */
  #load(bytes) {
    if (bytes === this.#shown) return;
    this.#shown = bytes;
    URL.revokeObjectURL(element.src);
    // Browsers tell PNG and JPEG apart themselves.
    if (bytes) element.src = URL.createObjectURL(new Blob([bytes]));
    else element.removeAttribute("src");
  }
}

/**
 * Checks that the browser can show a picture.
 * @param {Uint8Array<ArrayBuffer>} bytes
 */
export async function checkImage(bytes) {
  try {
    // An image element takes also what is damaged.
    (await createImageBitmap(new Blob([bytes]))).close();
  } catch (fault) {
    console.warn(fault);
    throw new Error(say("error-image"));
  }
}
