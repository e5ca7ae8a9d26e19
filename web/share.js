// The dialog of "Share": a link that holds the drawing, how long it is, and ways to hand it on.

import { openDialog } from "./dialogs.js";
import { say } from "./messages.js";

/** Links up to these lengths, in characters, are taken by nearly everything, by many programs, by some. */
const LENGTHS = { fine: 2_000, most: 8_000, some: 32_000 };

/** @typedef {{size: number, path: string}} Code a QR code: modules of a side, and the dark ones as SVG path data */

const part = (/** @type {string} */ id) => /** @type {HTMLElement} */ (document.getElementById(id));
const dialog = /** @type {HTMLDialogElement} */ (part("share"));
const field = /** @type {HTMLInputElement} */ (part("link"));

/** Whether a text ends in a link, or is one's part from `#` on. @param {string} text */
export function isLink(text) {
  return /#\d+\.\S*\s*$/.test(text) && !text.includes("<");
}

/**
 * Shows a link.
 * @param {string} fragment from `#` on; empty where the drawing is too large for one
 * @param {boolean} isTraced whether there is a picture under the lines, which no link has
 * @param {(link: string) => Promise<Code | undefined>} codeOf
 */
export async function showLink(fragment, isTraced, codeOf) {
  const link = location.origin + location.pathname + fragment;
  const length = fragment === "" ? Infinity : link.length;
  field.value = link;
  /** @type {HTMLMeterElement} */ (part("length")).value = Math.min(length, LENGTHS.some + 1);
  part("length-text").textContent = say(`link-${fit(length)}`, { length });
  part("as-link").hidden = length > LENGTHS.some;
  part("send-link").hidden = !("share" in navigator);
  part("share-tracing").hidden = !isTraced;
  part("share-status").textContent = "";
  part("code").toggleAttribute("hidden", true);
  openDialog(dialog);
  if (length <= LENGTHS.fine) drawCode(await codeOf(link));
}

/** @param {number} length */
function fit(length) {
  if (length > LENGTHS.some) return "too-long";
  return length > LENGTHS.most ? "long" : length > LENGTHS.fine ? "middling" : "short";
}

/** @param {Code | undefined} code */
function drawCode(code) {
  if (!code) return;
  const svg = part("code");
  svg.setAttribute("viewBox", `0 0 ${code.size} ${code.size}`);
  svg.querySelector("path")?.setAttribute("d", code.path);
  svg.toggleAttribute("hidden", false);
}

/** Copies the link. Where the page may not, it stays selected for the user to copy. */
export async function copyLink() {
  field.select();
  // A page that did not come over HTTPS has no clipboard.
  const copied = await navigator.clipboard?.writeText(field.value).then(() => true, () => false);
  part("share-status").textContent = say(copied ? "copied" : "copy-yourself");
}

/** Hands the link to the system's share sheet, which the user may close. */
export async function sendLink() {
  await navigator.share({ url: field.value }).catch(() => undefined);
}
