// The drawings that the browser keeps: a dialog of their pictures, to go on with or to be deleted. It has nothing of the page but
// what is handed to it, so that it is a file of its own.

import { button } from "./buttons.js";
import { makeDialog, openDialog } from "./dialogs.js";
import { make } from "./elements.js";

/** @typedef {import("./storage.js").Entry} Entry */

/**
 * @typedef {object} Shell what the dialog has of the page
 * @property {(key: string, values?: any) => string} say
 * @property {(root: ParentNode) => void} label puts words into elements, by their `data-text` and `data-label`
 * @property {(control: HTMLElement, label: string) => void} name
 * @property {() => Promise<Entry[]>} entries what the browser keeps
 * @property {(id: string) => Promise<Uint8Array<ArrayBuffer> | undefined>} picture
 * @property {(id: string) => unknown} open
 * @property {(id: string) => Promise<boolean>} remove deletes a drawing, and says whether it is gone
 */

const CONTENT = `
  <ul role="list"></ul>
  <p class="none credit" data-text="recent-none" hidden></p>`;

export class Recent {
  #shell;
  #dialog;
  #list;
  #none;

  /** @param {Shell} shell */
  constructor(shell) {
    this.#shell = shell;
    this.#dialog = makeDialog("recent", CONTENT, {}, shell.label);
    this.#list = /** @type {HTMLUListElement} */ (this.#dialog.querySelector("ul"));
    this.#none = /** @type {HTMLElement} */ (this.#dialog.querySelector(".none"));
  }

  /**
   * Shows what there is.
   * @param {string | undefined} shown the drawing that is open
   */
  async show(shown) {
    this.#list.replaceChildren(...(await this.#shell.entries()).map((entry) => this.#item(entry, entry.id === shown)));
    this.#none.hidden = this.#list.childElementCount > 0;
    openDialog(this.#dialog);
  }

  /**
   * @param {Entry} entry
   * @param {boolean} isShown
   */
  #item(entry, isShown) {
    const { say, open } = this.#shell;
    const item = make("li", {});
    const image = new Image();
    image.alt = "";
    this.#showPicture(image, entry.id);
    const choice = this.#named(say("open-kept", entry), () => {
      this.#dialog.close();
      if (!isShown) open(entry.id);
    });
    choice.append(image, make("span", {}, entry.name));
    item.append(choice, make("small", {}, this.#note(entry, isShown)));
    if (!isShown) item.append(this.#removal(entry, item));
    return item;
  }

  /**
   * @param {Entry} entry
   * @param {HTMLElement} item
   */
  #removal(entry, item) {
    const { say, remove } = this.#shell;
    const removal = this.#named(say("delete", entry), async () => {
      if (!confirm(say("delete-really", entry))) return;
      const isDone = await remove(entry.id).catch(() => false);
      if (!isDone) return removal.after(make("small", {}, say("delete-not")));
      const next = item.nextElementSibling ?? item.previousElementSibling ?? this.#dialog;
      item.remove();
      this.#none.hidden = this.#list.childElementCount > 0;
      next.querySelector("button")?.focus();
    });
    removal.className = "icon delete";
    removal.append(/** @type {Node} */ (this.#dialog.querySelector("header svg")?.cloneNode(true)));
    return removal;
  }

  /**
   * @param {Entry} entry
   * @param {boolean} isShown
   */
  #note(entry, isShown) {
    const { say } = this.#shell;
    if (isShown) return say("open-now");
    return entry.isAside ? say("damaged") : new Date(entry.seen).toLocaleString(document.documentElement.lang);
  }

  /**
   * @param {string} label
   * @param {() => void} act
   */
  #named(label, act) {
    const made = button("", act);
    this.#shell.name(made, label);
    return made;
  }

  /**
   * Shows a drawing's picture, or the page's own sign where there is none, as of a drawing that was left while it came up.
   * @param {HTMLImageElement} image
   * @param {string} id
   */
  async #showPicture(image, id) {
    const picture = await this.#shell.picture(id).catch(() => undefined);
    if (!picture) {
      image.className = "stand-in";
      image.src = /** @type {HTMLImageElement} */ (document.querySelector("h1 img")).src;
      return;
    }
    image.src = URL.createObjectURL(new Blob([picture], { type: "image/png" }));
    image.addEventListener("load", () => URL.revokeObjectURL(image.src), { once: true });
  }
}
