// What the browser keeps for the page between visits, in its local storage. A page that may keep nothing has it until it is
// closed.

/**
 * @param {string} key
 * @returns {string | null | undefined} null for what was never remembered, undefined where the page may keep nothing
 */
export function remembered(key) {
  try {
    return localStorage.getItem(key);
  } catch {
    return undefined;
  }
}

/**
 * @param {string} key
 * @param {string} value
 */
export function remember(key, value) {
  try {
    localStorage.setItem(key, value);
  } catch (fault) {
    console.warn(fault);
  }
}
