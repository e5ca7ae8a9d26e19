// The dialog of "Help": how to begin, and every shortcut.

import { openDialog } from "./dialogs.js";
import { make } from "./elements.js";
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
    const keys = chords.map((chord) => make("kbd", {}, written(chord)));
    return make("div", {}, make("dt", {}, say(action)), make("dd", {}, ...keys));
  });
  return make("section", {}, make("h3", {}, say(name)), make("dl", {}, ...rows));
}
