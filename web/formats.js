// The way to the second wasm module, which knows files, links and pictures for other programs. It is fetched when it is
// first needed: most visits never do. Work goes in and out as its exact bytes. What fails says so in a sentence for people.

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

const MODULE = new URL("../pkg/files/scumble_files.js", import.meta.url);

/** @type {Promise<any> | undefined} */
let module;
/** Each attempt at the module is one of its own: the browser would give back what failed. */
let attempts = 0;

export const formats = {
  /** A drawing of ours or of another program, a palette, or a picture to trace. @type {(file: Uint8Array, name: string) => Promise<Opened>} */
  open: (file, name) => call("open", file, name),
  /** A link. @type {(link: string) => Promise<Opened>} */
  openLink: (link) => call("openLink", link),
  /** Work with the lines of a sample. @type {(work: Uint8Array, sample: Uint8Array) => Promise<Uint8Array<ArrayBuffer>>} */
  onSample: (work, sample) => call("onSample", work, sample),
  /** The part of a link from `#` on; nothing for work that is too large. @type {(work: Uint8Array) => Promise<string | undefined>} */
  link: (work) => call("link", work),
  /** @type {(text: string) => Promise<import("./share.js").Code | undefined>} */
  qrCode: (text) => call("qrCode", text),
  /** The `.scumble` file that keeps some work, and the picture under its lines. @type {(work: Uint8Array, image?: Uint8Array) => Promise<Uint8Array<ArrayBuffer>>} */
  save: (work, image) => call("save", work, image),
  /** A file of a palette, whose colours and names come in turn, of the kind of an extension. @type {(swatches: string[], extension: string) => Promise<Uint8Array<ArrayBuffer>>} */
  palette: (swatches, extension) => call("palette", swatches, extension),
  /** A picture as SVG, with the work in it, and a PNG of its field. @type {(...wanted: [...Wanted, raster: Uint8Array]) => Promise<Uint8Array<ArrayBuffer>>} */
  svg: (...wanted) => call("svg", ...wanted),
  /** A picture as PDF. @type {(...wanted: Wanted) => Promise<Uint8Array<ArrayBuffer>>} */
  pdf: (...wanted) => call("pdf", ...wanted),
};

/**
 * @param {string} name
 * @param {unknown[]} args
 */
async function call(name, ...args) {
  const functions = await loaded();
  try {
    return functions[name](...args);
  } catch (fault) {
    if (!(fault instanceof WebAssembly.RuntimeError)) throw fault;
    // What has stopped in the middle is not entered again.
    console.warn(fault);
    module = undefined;
    throw new Error(say("error-too-hard"));
  }
}

async function loaded() {
  try {
    return await (module ??= fetched());
  } catch (fault) {
    console.warn(fault);
    module = undefined;
    throw new Error(say("error-formats"));
  }
}

async function fetched() {
  const functions = await import(`${MODULE.href}?${attempts++}`);
  await functions.default();
  return functions;
}
