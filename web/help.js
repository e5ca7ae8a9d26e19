// The dialog of "Help": how to begin, and every shortcut. It has nothing of the page but what is handed to it, so that it is a
// file of its own.

import { make } from "./elements.js";

/**
 * @typedef {object} Shell what the dialog has of the page
 * @property {(key: string) => string} say
 * @property {() => void} label names all controls anew: tooltips have the shortcuts that are on
 * @property {(dialog: HTMLDialogElement) => void} openDialog
 * @property {Record<string, Record<string, string[]>>} shortcuts groups of actions with their chords
 * @property {(chord: string) => string} written
 * @property {() => boolean} haveSingles
 * @property {(on: boolean) => void} setSingles
 */

export class Help {
  #dialog = /** @type {HTMLDialogElement} */ (document.getElementById("help"));
  #list = /** @type {HTMLElement} */ (document.getElementById("shortcuts"));
  #singles = /** @type {HTMLInputElement} */ (document.getElementById("single-keys"));
  #shell;

  /** @param {Shell} shell */
  constructor(shell) {
    this.#shell = shell;
    this.#singles.addEventListener("change", () => {
      shell.setSingles(this.#singles.checked);
      shell.label();
    });
  }

  show() {
    const { haveSingles, shortcuts, openDialog } = this.#shell;
    this.#singles.checked = haveSingles();
    this.#list.replaceChildren(...Object.entries(shortcuts).map((group) => this.#group(group)));
    openDialog(this.#dialog);
  }

  /** @param {[string, Record<string, string[]>]} group its name, and its actions with their chords */
  #group([name, actions]) {
    const { say, written } = this.#shell;
    const rows = Object.entries(actions).map(([action, chords]) => {
      const keys = chords.map((chord) => make("kbd", {}, written(chord)));
      return make("div", {}, make("dt", {}, say(action)), make("dd", {}, ...keys));
    });
    return make("section", {}, make("h3", {}, say(name)), make("dl", {}, ...rows));
  }
}
