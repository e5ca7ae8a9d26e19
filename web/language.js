// The language of the page: what somebody chose under "Settings", or else the first of the browser's that there is.

import { say, speak } from "./messages.js";
import { remember, remembered } from "./remember.js";
import { failed } from "./toolbar.js";

/** Where the browser keeps what was chosen. */
const CHOSEN = "scumble-language";

const LANGUAGES = ["en", "de"];

/** What leaves it to the browser. */
const AUTO = "auto";

const list = /** @type {HTMLSelectElement} */ (document.getElementById("language"));

/**
 * Has the page speak the language that it is to, and others that are chosen from now on.
 * @param {() => void} labelAll says everything that is there in another language
 */
export async function connectLanguage(labelAll) {
  list.value = LANGUAGES.find((language) => language === remembered(CHOSEN)) ?? AUTO;
  list.addEventListener("change", async () => {
    remember(CHOSEN, list.value);
    await follow();
    labelAll();
  });
  await follow();
}

async function follow() {
  try {
    await speak(wanted());
  } catch (fault) {
    console.warn(fault);
    // So that it can be chosen again.
    list.value = document.documentElement.lang;
    failed(new Error(say("error-language")));
  }
}

function wanted() {
  if (list.value !== AUTO) return list.value;
  const tags = navigator.languages.map((tag) => tag.split("-")[0]);
  return tags.find((language) => LANGUAGES.includes(language)) ?? "en";
}
