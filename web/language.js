// The language of the page: what somebody chose under "Settings", or else the first of the browser's that there is.

/** Where the browser keeps what was chosen. */
const CHOSEN = "scumble-language";

const LANGUAGES = ["en", "de"];

/** What was chosen; "auto" leaves it to the browser. */
export function chosenLanguage() {
  try {
    return LANGUAGES.find((language) => language === localStorage.getItem(CHOSEN)) ?? "auto";
  } catch {
    return "auto";
  }
}

/** @param {string} language */
export function chooseLanguage(language) {
  try {
    localStorage.setItem(CHOSEN, language);
  } catch (fault) {
    // A page that may keep nothing has it until it is closed.
    console.warn(fault);
  }
}

/** @param {string} chosen */
export function languageOf(chosen) {
  if (chosen !== "auto") return chosen;
  const wanted = navigator.languages.map((tag) => tag.split("-")[0]);
  return wanted.find((language) => LANGUAGES.includes(language)) ?? "en";
}
