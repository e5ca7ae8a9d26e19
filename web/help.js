// The dialog of "Help": how to begin, and every shortcut.

import { openDialog } from "./dialogs.js";
import { SHORTCUTS, haveSingles, setSingles, written } from "./keys.js";
import { label, say } from "./messages.js";

const dialog = /** @type {HTMLDialogElement} */ (document.getElementById("help"));
const list = /** @type {HTMLElement} */ (document.getElementById("shortcuts"));
const singles = /** @type {HTMLInputElement} */ (document.getElementById("single-keys"));

singles.addEventListener("change", () => {
  setSingles(singles.checked);
  // Tooltips name what is on.
  label(document);
});

export function showHelp() {
  singles.checked = haveSingles();
  list.replaceChildren(...Object.entries(SHORTCUTS).map(group));
  openDialog(dialog);
}

/** @param {[string, Record<string, string[]>]} group its name, and its actions with their chords */
function group([name, actions]) {
  const rows = Object.entries(actions).map(([action, chords]) => {
    const keys = chords.map((chord) => element("kbd", written(chord)));
    return element("div", element("dt", say(action)), element("dd", ...keys));
  });
  return element("section", element("h3", say(name)), element("dl", ...rows));
}

/**
 * @param {string} tag
 * @param {(string | Element)[]} content
 */
function element(tag, ...content) {
  const element = document.createElement(tag);
  element.append(...content);
  return element;
}
