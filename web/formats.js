// The way to the second wasm module, which knows files, links and pictures for other programs, in a worker. It is fetched
// when it is first needed: most visits never do. Work goes in and out as its exact bytes. What fails says so in a sentence
// for people; what takes long can be ended by a signal.

import { say } from "./messages.js";

/**
 * @typedef {object} Opened see `crates/scumble-files/src/lib.rs`
 * @property {Uint8Array<ArrayBuffer>} work empty for what is no work
 * @property {string} notes what was left out, in words
 * @property {string} [lacks] the sample whose lines are to be put into it
 * @property {string[]} [palette] colours as #rrggbb and names, in turn
 * @property {Uint8Array<ArrayBuffer>} [image] the file of the picture under the lines, or, without work, of one to be laid there
 * @typedef {[work: Uint8Array, field: Uint8Array, size_px: number, lines: boolean, transparent: boolean]} Wanted a picture
 */

/** What is said where the module cannot answer. */
const FAILURES = { missing: "error-formats", stopped: "error-too-hard" };

/** A worker that has nothing to do. @type {Worker | undefined} */
let idle;

export const formats = {
  /** A drawing of ours or of another program, a palette, or a picture to trace. @type {(file: Uint8Array, name: string, signal: AbortSignal) => Promise<Opened>} */
  open: (file, name, signal) => call(signal, "open", file, name),
  /** A link. @type {(link: string, signal: AbortSignal) => Promise<Opened>} */
  openLink: (link, signal) => call(signal, "openLink", link),
  /** Work with the lines of a sample. @type {(work: Uint8Array, sample: Uint8Array) => Promise<Uint8Array<ArrayBuffer>>} */
  onSample: (work, sample) => call(undefined, "onSample", work, sample),
  /** The part of a link from `#` on; nothing for work that is too large. @type {(work: Uint8Array) => Promise<string | undefined>} */
  link: (work) => call(undefined, "link", work),
  /** @type {(text: string) => Promise<import("./share.js").Code | undefined>} */
  qrCode: (text) => call(undefined, "qrCode", text),
  /** The `.scumble` file that keeps some work, and the picture under its lines. @type {(work: Uint8Array, image?: Uint8Array) => Promise<Uint8Array<ArrayBuffer>>} */
  save: (work, image) => call(undefined, "save", work, image),
  /** A file of a palette, whose colours and names come in turn, of the kind of an extension. @type {(swatches: string[], extension: string) => Promise<Uint8Array<ArrayBuffer>>} */
  palette: (swatches, extension) => call(undefined, "palette", swatches, extension),
  /** The longer side of the page that some work came with, in pixels. @type {(work: Uint8Array) => Promise<number | undefined>} */
  pagePx: (work) => call(undefined, "pagePx", work),
  /** A picture as SVG, with the work in it, and a PNG of its field. @type {(signal: AbortSignal | undefined, ...wanted: [...Wanted, raster: Uint8Array]) => Promise<Uint8Array<ArrayBuffer>>} */
  svg: (signal, ...wanted) => call(signal, "svg", ...wanted),
  /** A picture as PDF. @type {(signal: AbortSignal | undefined, ...wanted: Wanted) => Promise<Uint8Array<ArrayBuffer>>} */
  pdf: (signal, ...wanted) => call(signal, "pdf", ...wanted),
};

/** Whether a text ends in a link, or is one's part from `#` on. @param {string} text */
export function isLink(text) {
  return !text.includes("<") && /^#\d+\.\S*\s*$/.test(text.slice(text.lastIndexOf("#")));
}

/**
 * Asks a worker, which has nothing else to do.
 * @param {AbortSignal | undefined} signal ends it
 * @param {string} name of a function of the module
 * @param {unknown[]} args
 */
async function call(signal, name, ...args) {
  signal?.throwIfAborted();
  const worker = idle ?? new Worker(new URL("formats_worker.js", import.meta.url), { type: "module" });
  idle = undefined;
  try {
    const answer = await answered(worker, { name, args }, signal);
    if ("failure" in answer) throw new Error(say(FAILURES[answer.failure]));
    idle ??= worker;
    if ("sentence" in answer) throw new Error(answer.sentence);
    return /** @type {any} */ (answer.result);
  } finally {
    if (worker !== idle) worker.terminate();
  }
}

/**
 * @param {Worker} worker
 * @param {import("./formats_worker.js").Question} question
 * @param {AbortSignal | undefined} signal
 * @returns {Promise<import("./formats_worker.js").Answer>}
 */
function answered(worker, question, signal) {
  return new Promise((resolve, reject) => {
    signal?.addEventListener("abort", () => reject(signal.reason), { once: true });
    worker.onmessage = ({ data }) => resolve(data);
    worker.onerror = (event) => {
      event.preventDefault();
      reject(new Error(say(FAILURES.missing)));
    };
    worker.postMessage(question);
  });
}
