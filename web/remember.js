// What the browser keeps for the page between visits, in its local storage, or for a tab until it is closed. A page that may
// keep nothing has it until it is closed.

/** @typedef {"localStorage" | "sessionStorage"} Place */

/**
 * @param {string} key
 * @param {Place} [place]
 * @returns {string | null | undefined} null for what was never remembered, undefined where the page may keep nothing
 */
export function remembered(key, place = "localStorage") {
  try {
    return window[place].getItem(key);
  } catch {
    return undefined;
  }
}

/**
 * @param {string} key
 * @param {string} value
 * @param {Place} [place]
 */
export function remember(key, value, place = "localStorage") {
  try {
    window[place].setItem(key, value);
  } catch (fault) {
    console.warn(fault);
  }
}
