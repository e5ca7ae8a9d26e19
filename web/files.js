// Files in and out: opened, dropped or pasted ones, and those to keep.

import { say } from "./messages.js";
import { tell } from "./toolbar.js";

/** @typedef {{name: string, bytes: Promise<Uint8Array>, handle?: any}} Coming a file that is being read */
/** @typedef {{name: string, handle?: any}} Place where a file was kept; of a download only the name is known */

/** Files of ours, as the browser's dialogs name them. */
const OURS = { description: "Scumble", accept: { "application/x-scumble": [".scumble"] } };
/** What can be opened: drawings, diffusion curves, palettes, pictures to trace. */
const OPENED = {
  description: "Scumble, SVG, XML, PNG, JPEG, GPL, ASE, HEX",
  accept: {
    ...OURS.accept,
    "image/svg+xml": [".svg"],
    "text/xml": [".xml"],
    "image/png": [".png"],
    "image/jpeg": [".jpg", ".jpeg"],
    "text/plain": [".gpl", ".ase", ".hex"],
  },
};

/** Larger files cannot be opened, as `MAX_FILE_BYTES` in `scumble-io` says. */
const MOST_BYTES = 20_000_000;

/** The answer of who lets a file be written to. */
const GRANTED = "granted";

/** Browsers may ask first where a download goes, or whether it is wanted, and take it only then. */
const DOWNLOAD_MS = 60_000;

const browser = /** @type {any} */ (window);
const input = () => /** @type {HTMLInputElement} */ (document.getElementById("file"));

/**
 * Takes files from the file dialog, from drops on the page and from the clipboard, which may also hold text.
 * @param {(coming: Coming) => Promise<unknown>} open gives what went wrong, if anything did
 * @param {(text: string) => void} openText
 */
export function receive(open, openText) {
  const first = async (/** @type {File} */ file, /** @type {number} */ count) => {
    const fault = await open(reading(file));
    if (count > 1 && !fault) tell(say("opened-first", { name: file.name }));
  };
  const take = (/** @type {DataTransfer | null} */ data) => {
    const file = data?.files[0];
    const text = data?.getData("text/plain") ?? "";
    if (file) first(file, data?.files.length ?? 1);
    else if (text.trim() !== "") openText(text);
  };
  input().addEventListener("change", () => {
    const file = input().files?.[0];
    if (file) open(reading(file));
    input().value = "";
  });
  window.addEventListener("paste", ({ target, clipboardData }) => {
    // What can be written in takes it itself.
    if (!(/** @type {Element} */ (target).matches?.(":read-write"))) take(clipboardData);
  });
  receiveDrops(take);
}

/** @param {(data: DataTransfer | null) => void} take */
function receiveDrops(take) {
  const stage = document.getElementById("stage");
  const mark = (/** @type {boolean} */ on) => stage?.classList.toggle("drop", on);
  window.addEventListener("dragover", (event) => {
    event.preventDefault();
    mark(true);
  });
  window.addEventListener("dragleave", (event) => {
    if (event.relatedTarget === null) mark(false);
  });
  window.addEventListener("drop", (event) => {
    event.preventDefault();
    mark(false);
    take(event.dataTransfer);
  });
}

/**
 * Shows the browser's dialog for files. One of ours that is opened through it can be saved to again.
 * @param {(coming: Coming) => void} open
 */
export async function choose(open) {
  if (!browser.showOpenFilePicker) return input().click();
  const [handle] = (await asked(() => browser.showOpenFilePicker({ types: [OPENED] }))) ?? [];
  if (!handle) return;
  const isOurs = handle.name.toLowerCase().endsWith(".scumble");
  open({ ...reading(await handle.getFile()), handle: isOurs ? handle : undefined });
}

/**
 * Reads no more of a file than shows that there is too much of it: a film may have been dropped.
 * @param {File} file
 * @returns {Coming}
 */
export function reading(file) {
  const bytes = file.slice(0, MOST_BYTES + 1).arrayBuffer().then(
    (buffer) => new Uint8Array(buffer),
    () => Promise.reject(new Error(say("error-read"))),
  );
  return { name: file.name, bytes };
}

/**
 * Keeps a file in its old place, or where the user says, or with the downloads where the browser has no such dialog.
 * @param {Place} place the file's name, and its old place if there is one
 * @param {() => Promise<Uint8Array<ArrayBuffer>>} content
 * @returns {Promise<Place | undefined>} nothing where the user thought otherwise
 */
export async function keep({ name, handle }, content) {
  if (!browser.showSaveFilePicker) {
    download(name, new Blob([await content()], { type: "application/json" }));
    return { name };
  }
  // Dialogs come first: browsers show them only right after a click, and the content may take its time.
  if (handle) await ask(handle);
  else handle = await asked(() => browser.showSaveFilePicker({ suggestedName: name, types: [OURS] }));
  if (!handle) return undefined;
  await write(handle, await content());
  return { name: handle.name, handle };
}

/** Asks whether a file that was opened, or kept when the page was here before, may be written to. @param {any} handle */
async function ask(handle) {
  const answer = (await handle.requestPermission?.({ mode: "readwrite" }).catch(String)) ?? GRANTED;
  if (answer !== GRANTED) throw unwritten(answer);
}

/**
 * @param {any} handle
 * @param {Uint8Array} bytes
 */
async function write(handle, bytes) {
  try {
    const file = await handle.createWritable();
    await file.write(bytes);
    await file.close();
  } catch (fault) {
    throw unwritten(fault);
  }
}

/** @param {unknown} fault */
function unwritten(fault) {
  console.warn(fault);
  return new Error(say("error-write"));
}

/**
 * The answer to a dialog, or nothing where it was closed.
 * @template T
 * @param {() => Promise<T>} ask
 */
async function asked(ask) {
  try {
    return await ask();
  } catch (fault) {
    if (/** @type {any} */ (fault).name === "AbortError") return undefined;
    throw fault;
  }
}

/**
 * Hands a file to the browser to keep.
 * @param {string} name
 * @param {Blob} file
 */
export function download(name, file) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(file);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), DOWNLOAD_MS);
}
