// Which drawings of the storage are this tab's: it holds a lock on each, for as long as there is the tab, unless it has not
// come to show it. None is deleted that another tab holds.

import { remove } from "./storage.js";

/** A tab that is closed or loaded again takes a moment to let go. */
const TRIES = 5;
const PAUSE_MS = 100;

/** @type {Map<string, () => void>} What lets go of each drawing that is held. */
const held = new Map();

/**
 * Takes a drawing for this tab. Where the browser has no locks every tab gets it, and the one that got it last
 * writes it.
 * @param {string} id
 * @returns {Promise<boolean>} whether it is this tab's
 */
export async function hold(id) {
  for (let left = TRIES; left > 0; left--) {
    if (held.has(id) || !navigator.locks || (await isGiven(id))) return true;
    await new Promise((wake) => setTimeout(wake, PAUSE_MS));
  }
  return false;
}

/**
 * @param {string} id
 * @returns {Promise<boolean>}
 */
function isGiven(id) {
  return new Promise((resolve) => {
    const keep = (/** @type {Lock | null} */ lock) => {
      resolve(lock !== null);
      return lock && new Promise((letGo) => held.set(id, () => letGo(undefined)));
    };
    navigator.locks.request(`scumble ${id}`, { ifAvailable: true }, keep).catch(() => resolve(true));
  });
}

/** Leaves a drawing to other tabs. @param {string} id */
export function letGo(id) {
  held.get(id)?.();
  held.delete(id);
}

/**
 * Deletes a drawing, unless another tab has it.
 * @param {string} id
 * @returns {Promise<boolean>} whether it is gone
 */
export async function removed(id) {
  let isUsed = held.has(id);
  if (!(await hold(id))) return false;
  try {
    await remove(id);
    isUsed = false;
  } finally {
    if (!isUsed) letGo(id);
  }
  return true;
}
