// What a key has chosen, in words: who does not see the page hears it, where it says nothing of it by itself. It has nothing of
// the page but what is handed to it, so that it is a file of its own.

/** @typedef {(key: string, values?: Record<string, unknown>) => string} Say the text of a message */

/** What is said of actions, by how their names begin. @type {[RegExp, (say: Say, action: string) => string | null | undefined][]} */
const WORDS = [
  [/^tool-/, () => called("#tools :checked")],
  [/^other-kind$/, () => called("[name=kind]:checked")],
  [/^swatch-/, (_, action) => called(`#palette [data-shortcut="${action}"]`)],
  [/^swap-colors$/, color],
  [/^brush-/, (say) => say("now-at", { name: say("brush-size"), value: find("#brush-size")?.value })],
  [/^zoom-|^fit$/, () => called("#zoom")],
  [/^show-/, (say, action) => say(isShown(action) ? "now-on" : "now-off", { name: say(action) })],
];

/**
 * @param {string} action what a key has done
 * @param {Say} say
 * @returns what to say of it, if anything
 */
export function wordsOf(action, say) {
  const [, words] = WORDS.find(([actions]) => actions.test(action)) ?? [];
  return words?.(say, action);
}

/** @param {string} selector */
function find(selector) {
  return /** @type {HTMLInputElement | null} */ (document.querySelector(selector));
}

/** What a control is called. @param {string} selector */
function called(selector) {
  return find(selector)?.ariaLabel;
}

function color() {
  const { color } = find("#color")?.dataset ?? {};
  return called(`:is(#tones, #palette) [data-color="${color}"]`) ?? color;
}

/** @param {string} action */
function isShown(action) {
  return find(`[data-setting="${action.replace("show-", "")}"]`)?.checked;
}
