// The drawings that the browser keeps: a dialog of their pictures, to go on with or to be deleted.

import { openDialog } from "./dialogs.js";
import { button, make } from "./elements.js";
import { hold, letGo } from "./hold.js";
import { name, say } from "./messages.js";
import * as storage from "./storage.js";

export class Recent {
  #dialog = /** @type {HTMLDialogElement} */ (document.getElementById("recent"));
  #list = /** @type {HTMLUListElement} */ (this.#dialog.querySelector("ul"));
  #none = /** @type {HTMLElement} */ (this.#dialog.querySelector(".none"));
  #open;
  #removed;

  /**
   * @param {(id: string) => void} open
   * @param {(id: string) => void} removed called when a drawing was deleted
   */
  constructor(open, removed) {
    this.#open = open;
    this.#removed = removed;
  }

  /**
   * Shows what there is.
   * @param {string | undefined} shown the drawing that is open
   */
  async show(shown) {
    const entries = await storage.entries();
    this.#list.replaceChildren(...entries.map((entry) => this.#item(entry, entry.id === shown)));
    this.#none.hidden = entries.length > 0;
    openDialog(this.#dialog);
  }

  /**
   * @param {storage.Entry} entry
   * @param {boolean} isShown
   */
  #item(entry, isShown) {
    const item = make("li", {});
    const image = new Image();
    image.alt = "";
    showPicture(image, entry.id);
    const open = named(say("open-kept", entry), () => {
      this.#dialog.close();
      if (!isShown) this.#open(entry.id);
    });
    open.append(image, make("span", {}, entry.name));
    item.append(open, make("small", {}, note(entry, isShown)));
    if (!isShown) item.append(this.#removal(entry, item));
    return item;
  }

  /**
   * @param {storage.Entry} entry
   * @param {HTMLElement} item
   */
  #removal(entry, item) {
    const remove = named(say("delete", entry), async () => {
      if (!confirm(say("delete-really", entry))) return;
      const isDone = await removed(entry.id).catch(() => false);
      if (!isDone) return remove.after(make("small", {}, say("delete-not")));
      this.#removed(entry.id);
      const next = item.nextElementSibling ?? item.previousElementSibling ?? this.#dialog;
      item.remove();
      this.#none.hidden = this.#list.childElementCount > 0;
      next.querySelector("button")?.focus();
    });
    remove.className = "icon delete";
    remove.append(/** @type {Node} */ (this.#dialog.querySelector("header svg")?.cloneNode(true)));
    return remove;
  }
}

/**
 * Deletes a drawing, unless another tab has it.
 * @param {string} id
 * @returns {Promise<boolean>} whether it is gone
 */
export async function removed(id) {
  if (!(await hold(id))) return false;
  await storage.remove(id);
  letGo(id);
  return true;
}

/**
 * @param {storage.Entry} entry
 * @param {boolean} isShown
 */
function note(entry, isShown) {
  if (isShown) return say("open-now");
  return entry.isAside ? say("damaged") : new Date(entry.seen).toLocaleString(document.documentElement.lang);
}

/**
 * @param {string} label
 * @param {() => void} act
 */
function named(label, act) {
  const made = button("", act);
  name(made, label);
  return made;
}

/**
 * @param {HTMLImageElement} image
 * @param {string} id
 */
async function showPicture(image, id) {
  const picture = await storage.picture(id).catch(() => undefined);
  if (!picture) return;
  image.src = URL.createObjectURL(new Blob([picture], { type: "image/png" }));
  image.addEventListener("load", () => URL.revokeObjectURL(image.src), { once: true });
}
