// The dialog of "Export": the picture as a file for other programs, or as pixels on the clipboard.

import { openDialog } from "./dialogs.js";
import { download } from "./files.js";
import { formats } from "./formats.js";
import { say } from "./messages.js";
import { pngOf } from "./png.js";
import { done } from "./toolbar.js";

/** Pixels of the longer side at 1×. */
const ONE_PX = 1024;

/** Those of the shades in an SVG: as of the whole, within this range, which is `RASTER_PX` of `scumble-export`. */
const RASTER_PX = { least: 2048, most: 4096 };

/** Painting that takes longer than this shows how far it is, and can be stopped. */
const PATIENCE_MS = 100;

/** @typedef {"png" | "svg" | "pdf"} Format */

const TYPES = { png: "image/png", svg: "image/svg+xml", pdf: "application/pdf" };

const part = (/** @type {string} */ id) => /** @type {HTMLElement} */ (document.getElementById(id));
const input = (/** @type {string} */ id) => /** @type {HTMLInputElement} */ (part(id));
const dialog = /** @type {HTMLDialogElement} */ (part("export"));

/** Ends the work that is going on. @type {AbortController | undefined} */
let job;

/** Whether lines were shown as the dialog was opened last: what is chosen in it holds until that changes. @type {boolean | undefined} */
let linesBefore;

dialog.addEventListener("close", cancelExport);
dialog.addEventListener("input", judge);

/** @param {boolean} lines whether they are shown */
export function showExport(lines) {
  if (lines !== linesBefore) input("export-lines").checked = linesBefore = lines;
  judge();
  openDialog(dialog);
}

export function cancelExport() {
  job?.abort();
}

/** @param {number} times */
export function setSize(times) {
  input("export-size").valueAsNumber = times * ONE_PX;
  judge();
}

/** Says what is wrong with what is chosen, if anything is. */
function judge() {
  tell(hasSize() ? "" : say("export-size-fault"));
  input("export-size").setAttribute("aria-invalid", String(!hasSize()));
  showChoice();
}

function hasSize() {
  return input("export-size").validity.valid;
}

/** Only pixels can be copied, and only where the page may. */
function showChoice() {
  part("copy-picture").hidden = format() !== "png" || !navigator.clipboard?.write;
  for (const id of ["save-export", "copy-picture"]) {
    /** @type {HTMLButtonElement} */ (part(id)).disabled = job !== undefined || !hasSize();
  }
}

/** @returns {Format} */
function format() {
  return /** @type {any} */ (dialog.querySelector("[name=format]:checked")).value;
}

/**
 * @param {import("./engine.js").Engine} engine
 * @param {string} stem of the file's name
 */
export async function saveExport(engine, stem) {
  const name = `${stem}.${format()}`;
  const file = await worked(() => made(engine, format()));
  if (!file) return;
  download(name, file);
  dialog.close();
  done(say("exported", { name }));
}

/** @param {import("./engine.js").Engine} engine */
export async function copyPicture(engine) {
  // Some browsers take only what is handed to them in the click itself.
  const copied = await worked(async () => {
    await navigator.clipboard.write([new ClipboardItem({ [TYPES.png]: made(engine, "png") })]);
    return true;
  });
  if (copied) tell(say("copied"));
}

/**
 * Works on something that can be stopped, and says what goes wrong.
 * @template T
 * @param {() => Promise<T>} act
 * @returns {Promise<T | undefined>}
 */
async function worked(act) {
  const { signal } = (job = new AbortController());
  showChoice();
  try {
    return await act();
  } catch (fault) {
    // The engine stops where its module has.
    if (fault instanceof WebAssembly.RuntimeError) throw fault;
    tell(say(signal.aborted ? "export-stopped" : "failed", { sentence: sentence(fault) }));
    return undefined;
  } finally {
    job = undefined;
    part("export-progress").hidden = true;
    showChoice();
  }
}

/** What went wrong, for people: of memory and of clipboards browsers speak in their own words. @param {unknown} fault */
function sentence(fault) {
  console.warn(fault);
  return fault?.constructor === Error ? /** @type {Error} */ (fault).message : say("error-export");
}

/** @param {string} text */
function tell(text) {
  part("export-status").textContent = text;
}

/**
 * The picture of the drawing as it is.
 * @param {import("./engine.js").Engine} engine
 * @param {Format} kind
 */
async function made(engine, kind) {
  const size_px = input("export-size").valueAsNumber;
  const [lines, transparent] = ["export-lines", "export-transparent"].map((id) => input(id).checked);
  const isPng = kind === "png";
  const raster_px = Math.min(Math.max(size_px, RASTER_PX.least), RASTER_PX.most);
  const picture = engine.export(isPng ? size_px : raster_px, isPng && lines);
  const work = engine.work();
  if (!picture || !work) throw new Error(say("error-export"));
  try {
    if (isPng) return await painted(picture, transparent);
    const wanted = /** @type {const} */ ([work, picture.field(), size_px, lines, transparent]);
    if (kind === "pdf") return new Blob([await formats.pdf(...wanted)], { type: TYPES.pdf });
    const raster = await painted(picture, transparent).then((png) => png.arrayBuffer());
    return new Blob([await formats.svg(...wanted, new Uint8Array(raster))], { type: TYPES.svg });
  } finally {
    picture.free();
  }
}

/**
 * @param {import("./engine.js").Export} picture
 * @param {boolean} transparent
 */
function painted(picture, transparent) {
  const { width, height } = picture;
  const [signal, start] = [job?.signal, performance.now()];
  return pngOf({ width, height, rows: (y, count) => picture.rows(y, count, transparent) }, async (share) => {
    part("export-progress").hidden = performance.now() - start < PATIENCE_MS;
    /** @type {HTMLProgressElement} */ (part("export-share")).value = share;
    // Clicks come in between.
    await new Promise((wake) => setTimeout(wake));
    signal?.throwIfAborted();
  });
}
