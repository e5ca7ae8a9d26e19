// The dialog of "Help": how to begin, and every shortcut. It has nothing of the page but what is handed to it, so that it is a
// file of its own.

import { makeDialog, openDialog } from "./dialogs.js";
import { make } from "./elements.js";

/**
 * @typedef {object} Shell what the dialog has of the page
 * @property {(key: string) => string} say
 * @property {(root: ParentNode) => void} label puts words into elements, by their `data-text` and `data-label`
 * @property {() => void} labelNames names all controls anew: tooltips have the shortcuts that are on
 * @property {() => void} showFirstSteps
 * @property {Record<string, Record<string, string[]>>} shortcuts groups of actions with their chords
 * @property {(chord: string) => string} written
 * @property {() => boolean} haveSingles
 * @property {(on: boolean) => void} setSingles
 */

const CONTENT = `
  <div class="body">
    <ol role="list" class="guide">
      <li><svg aria-hidden="true"><use href="#i-scribble"/></svg><span data-text="guide-1"></span></li>
      <li><svg aria-hidden="true"><use href="#i-settings"/></svg><span data-text="guide-2"></span></li>
      <li><svg aria-hidden="true"><use href="#i-fit"/></svg><span data-text="guide-3"></span></li>
    </ol>
    <button type="button" class="main" data-action="first-steps" data-text="show-steps"></button>
    <label class="check"><input type="checkbox" id="single-keys"><span data-text="single-keys"></span></label>
    <div id="shortcuts"></div>
  </div>`;

export class Help {
  #shell;
  #dialog;
  #list;
  #singles;

  /** @param {Shell} shell */
  constructor(shell) {
    this.#shell = shell;
    this.#dialog = makeDialog("help", CONTENT, { "first-steps": () => this.#showFirstSteps() }, shell.label);
    this.#list = /** @type {HTMLElement} */ (this.#dialog.querySelector("#shortcuts"));
    this.#singles = /** @type {HTMLInputElement} */ (this.#dialog.querySelector("#single-keys"));
    this.#singles.addEventListener("change", () => {
      shell.setSingles(this.#singles.checked);
      shell.labelNames();
    });
  }

  show() {
    const { haveSingles, shortcuts } = this.#shell;
    this.#singles.checked = haveSingles();
    this.#list.replaceChildren(...Object.entries(shortcuts).map((group) => this.#group(group)));
    openDialog(this.#dialog);
  }

  #showFirstSteps() {
    this.#dialog.close();
    this.#shell.showFirstSteps();
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
