// The dialog of "Share": a link that holds the drawing, how long it is, and ways to hand it on. It has nothing of the page
// but what is handed to it, so that it is a file of its own.

import { makeDialog, openDialog } from "./dialogs.js";

/** Links up to these lengths, in characters, are taken by nearly everything, by many programs, by some. */
const LENGTHS = { fine: 2_000, most: 8_000, some: 32_000 };

/** @typedef {{size: number, path: string}} Code a QR code: modules of a side, and the dark ones as SVG path data */

const part = (/** @type {string} */ id) => /** @type {HTMLElement} */ (document.getElementById(id));
const field = () => /** @type {HTMLInputElement} */ (part("link"));

const CONTENT = `
  <div class="body">
    <p class="length"><meter id="length" min="0" low="2000" high="8000" max="32001" optimum="0" data-label="link-length"></meter>
      <span id="length-text"></span></p>
    <div id="as-link">
      <input type="text" id="link" readonly data-label="share-link">
      <button type="button" class="main first" data-action="copy-link" data-text="copy-link"></button>
      <button type="button" class="main" data-action="send-link" id="send-link" data-text="send-link"></button>
    </div>
    <button type="button" class="main" data-action="save" data-text="as-file"></button>
    <p id="share-tracing" data-text="share-tracing" hidden></p>
    <p id="share-status" role="status"></p>
    <svg id="code" role="img" data-label="qr-code" hidden><path/></svg>
  </div>`;

/**
 * @typedef {object} Shell what the dialog has of the page
 * @property {(key: string, values?: Record<string, unknown>) => string} say
 * @property {(text: string) => Promise<Code | undefined>} codeOf
 * @property {(root: ParentNode) => void} label puts words into elements, by their `data-text` and `data-label`
 * @property {() => unknown} save keeps the drawing as a file
 */

export class Share {
  #shell;
  #dialog;

  /** @param {Shell} shell */
  constructor(shell) {
    this.#shell = shell;
    const acts = { "copy-link": () => this.#copy(), "send-link": send, save: shell.save };
    this.#dialog = makeDialog("share", CONTENT, acts, shell.label);
  }

  /**
   * Shows a link.
   * @param {string} fragment from `#` on; empty where the drawing is too large for one
   * @param {boolean} isTraced whether there is a picture under the lines, which no link has
   */
  async open(fragment, isTraced) {
    const { say, codeOf } = this.#shell;
    const link = location.origin + location.pathname + fragment;
    const length = fragment === "" ? Infinity : link.length;
    field().value = link;
    /** @type {HTMLMeterElement} */ (part("length")).value = Math.min(length, LENGTHS.some + 1);
    part("length-text").textContent = say(`link-${fit(length)}`, { length });
    part("as-link").hidden = length > LENGTHS.some;
    part("send-link").hidden = !("share" in navigator);
    part("share-tracing").hidden = !isTraced;
    part("share-status").textContent = "";
    part("code").toggleAttribute("hidden", true);
    openDialog(this.#dialog);
    if (length > LENGTHS.fine) return;
    const code = await codeOf(link);
    if (field().value === link) drawCode(code);
  }

  /** Copies the link. Where the page may not, it stays selected for the user to copy. */
  async #copy() {
    field().select();
    // A page that did not come over HTTPS has no clipboard.
    const copied = await navigator.clipboard?.writeText(field().value).then(() => true, () => false);
    part("share-status").textContent = this.#shell.say(copied ? "copied" : "copy-yourself");
  }
}

/** Hands the link to the system's share sheet, which the user may close. */
async function send() {
  await navigator.share({ url: field().value }).catch(() => undefined);
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
