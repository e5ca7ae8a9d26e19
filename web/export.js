// The dialog of "Export": the picture as a file for other programs, or as pixels on the clipboard. It has nothing of the
// page but what is handed to it, so that it is a file of its own.

import { makeDialog, openDialog } from "./dialogs.js";
import { pngOf } from "./png.js";

/** Pixels of the longer side at 1×. */
const ONE_PX = 1024;

/** Those of the shades in an SVG: as of the whole, within this range, which is `RASTER_PX` of `scumble-export`. */
const RASTER_PX = { least: 2048, most: 4096 };

/** Curves bend in SVG and PDF as in a picture of so many pixels: those of 1024 du at `PX_PER_DU` of `scumble-export`. */
const BENT_PX = 16_384;

/** Work that takes longer than this shows that it goes on, and can be stopped. */
const PATIENCE_MS = 100;

/** @typedef {"png" | "svg" | "pdf"} Format */
/** @typedef {"pixels" | "shapes"} Kind of what a picture is made of */

const TYPES = { png: "image/png", svg: "image/svg+xml", pdf: "application/pdf" };

/**
 * @typedef {object} Shell what the dialog has of the page
 * @property {import("./engine.js").Engine} engine
 * @property {typeof import("./formats.js").formats} formats
 * @property {(key: string, values?: Record<string, unknown>) => string} say
 * @property {(root: ParentNode) => void} label puts words into elements, by their `data-text` and `data-label`
 * @property {(text: string) => void} done
 * @property {() => string} drawing the name of the drawing
 * @property {(name: string) => string} stem a name without its ending
 * @property {(name: string, file: Blob) => void} download
 */

const part = (/** @type {string} */ id) => /** @type {HTMLElement} */ (document.getElementById(id));
const input = (/** @type {string} */ id) => /** @type {HTMLInputElement} */ (part(id));

const CONTENT = `
  <div class="body">
    <div class="kinds" role="radiogroup" data-label="format">
      <label class="kind"><input type="radio" name="format" value="png" checked><span>PNG</span></label>
      <label class="kind"><input type="radio" name="format" value="svg"><span>SVG</span></label>
      <label class="kind"><input type="radio" name="format" value="pdf"><span>PDF</span></label>
    </div>
    <p class="size"><label for="export-size" data-text="export-size"></label>
      <input type="number" id="export-size" aria-describedby="export-status" min="1" max="16384" value="1024" required>
      <button type="button" data-action="export-1">1×</button>
      <button type="button" data-action="export-2">2×</button>
      <button type="button" data-action="export-4">4×</button></p>
    <p class="size"><label class="check"><input type="checkbox" id="export-lines"><span data-text="lines"></span></label>
      <label class="check"><input type="checkbox" id="export-transparent"><span data-text="transparent"></span></label></p>
    <p class="size"><button type="button" class="main first" data-action="save-export" id="save-export" data-text="save-export"></button>
      <button type="button" class="main" data-action="copy-picture" id="copy-picture" data-text="copy-picture"></button></p>
    <p id="export-progress" hidden><progress id="export-share" data-label="painting"></progress>
      <button type="button" data-action="cancel-export" data-text="cancel"></button></p>
    <p id="export-status" role="status"></p>
  </div>`;

export class Export {
  #shell;
  #dialog;
  /** Ends the work that is going on. @type {AbortController | undefined} */
  #job;
  /** Whether lines were shown as the dialog was opened last: what is chosen in it holds until that changes. @type {boolean | undefined} */
  #linesBefore;
  /** The sizes that were chosen: of pixels for good, of shapes for the drawing as the dialog was opened. @type {{[kind in Kind]?: string}} */
  #sizes = {};
  /** Done once the size is known. @type {Promise<void>} */
  #sized = Promise.resolve();
  /** Stands for the last size that was asked for. */
  #asked = {};

  /** @param {Shell} shell */
  constructor(shell) {
    this.#shell = shell;
    this.#dialog = makeDialog("export", CONTENT, this.#acts(), shell.label);
    this.#dialog.addEventListener("close", () => this.#cancel());
    this.#dialog.addEventListener("input", ({ target }) => {
      if (target === input("export-size")) this.#sizes[kind()] = input("export-size").value;
      if (/** @type {HTMLInputElement} */ (target).name === "format") this.#sized = this.#showSize();
      this.#judge();
    });
  }

  /** @param {boolean} lines whether they are shown */
  open(lines) {
    if (lines !== this.#linesBefore) input("export-lines").checked = this.#linesBefore = lines;
    delete this.#sizes.shapes;
    this.#sized = this.#showSize();
    this.#judge();
    openDialog(this.#dialog);
  }

  /** What the buttons do. @returns {Record<string, () => unknown>} */
  #acts() {
    return {
      "export-1": () => this.#setSize(1),
      "export-2": () => this.#setSize(2),
      "export-4": () => this.#setSize(4),
      "save-export": () => this.#save(),
      "copy-picture": () => this.#copy(),
      "cancel-export": () => this.#cancel(),
    };
  }

  #cancel() {
    this.#job?.abort();
  }

  /** @param {number} times */
  #setSize(times) {
    input("export-size").value = this.#sizes[kind()] = String(times * ONE_PX);
    this.#judge();
  }

  async #save() {
    const { download, done, say } = this.#shell;
    const name = this.#fileName();
    const file = await this.#worked((signal) => this.#made(format(), signal));
    if (!file) return;
    download(name, file);
    this.#dialog.close();
    done(say("exported", { name }));
  }

  /** The drawing's name, but not that of its own file, whose place this one is not to take. */
  #fileName() {
    const drawing = this.#shell.drawing();
    const stem = this.#shell.stem(drawing);
    const own = `${stem}.${format()}`;
    return own.toLowerCase() === drawing.toLowerCase() ? `${stem} (Scumble).${format()}` : own;
  }

  async #copy() {
    // Some browsers take only what is handed to them in the click itself.
    const copied = await this.#worked(async (signal) => {
      await navigator.clipboard.write([new ClipboardItem({ [TYPES.png]: this.#made("png", signal) })]);
      return true;
    });
    if (copied) tell(this.#shell.say("copied"));
  }

  /** Shows the size that was chosen; shapes are else as large as the page that the drawing came with. */
  async #showSize() {
    const { engine, formats } = this.#shell;
    const asked = (this.#asked = {});
    const isOpen = () => asked === this.#asked && kind() === "shapes" && this.#sizes.shapes === undefined;
    input("export-size").value = this.#sizes[kind()] ?? String(ONE_PX);
    const work = isOpen() && engine.work();
    // Where that cannot be told, it is told as the file is made.
    const page_px = work && (await formats.pagePx(work).catch(() => undefined));
    if (!page_px || !isOpen()) return;
    input("export-size").value = String(page_px);
    this.#judge();
  }

  /** Says what is wrong with what is chosen, if anything is. */
  #judge() {
    tell(hasSize() ? "" : this.#shell.say("export-size-fault"));
    input("export-size").setAttribute("aria-invalid", String(!hasSize()));
    this.#showChoice();
  }

  /** Only pixels can be copied, and only where the page may. */
  #showChoice() {
    part("copy-picture").hidden = format() !== "png" || !navigator.clipboard?.write;
    for (const id of ["save-export", "copy-picture"]) {
      /** @type {HTMLButtonElement} */ (part(id)).disabled = this.#job !== undefined || !hasSize();
    }
  }

  /**
   * Works on something that can be stopped, and says what goes wrong.
   * @template T
   * @param {(signal: AbortSignal) => Promise<T>} act
   * @returns {Promise<T | undefined>}
   */
  async #worked(act) {
    const { signal } = (this.#job = new AbortController());
    const button = /** @type {HTMLElement} */ (document.activeElement);
    this.#showChoice();
    try {
      return await act(signal);
    } catch (fault) {
      // The engine stops where its module has.
      if (fault instanceof WebAssembly.RuntimeError) throw fault;
      const { say } = this.#shell;
      tell(signal.aborted ? say("export-stopped") : say("failed", { sentence: this.#sentence(fault) }));
      return undefined;
    } finally {
      this.#job = undefined;
      part("export-progress").hidden = true;
      this.#showChoice();
      // It has lost the focus, as it could not be pressed.
      if (document.activeElement === document.body) button.focus();
    }
  }

  /** What went wrong, for people: of memory and of clipboards browsers speak in their own words. @param {unknown} fault */
  #sentence(fault) {
    console.warn(fault);
    return fault?.constructor === Error ? /** @type {Error} */ (fault).message : this.#shell.say("error-export");
  }

  /**
   * The picture of the drawing as it is.
   * @param {Format} format
   * @param {AbortSignal} signal
   */
  async #made(format, signal) {
    await written(stoppable(this.#sized, signal));
    const size_px = input("export-size").valueAsNumber;
    const [lines, transparent] = ["export-lines", "export-transparent"].map((id) => input(id).checked);
    await written(stoppable(this.#shell.engine.made(), signal));
    const look = { size_px, lines, transparent, signal };
    if (format !== "png") return this.#drawn(format, look);
    return this.#with(size_px, lines, signal, (picture) => painted(picture, transparent, signal));
  }

  /**
   * The same as a file of shapes; in SVG its shades are pixels.
   * @param {"svg" | "pdf"} format
   * @param {{size_px: number, lines: boolean, transparent: boolean, signal: AbortSignal}} look
   */
  async #drawn(format, { size_px, lines, transparent, signal }) {
    const { engine, formats, say } = this.#shell;
    const field = await this.#with(BENT_PX, false, signal, async (picture) => picture.field());
    const work = engine.work();
    if (!work) throw new Error(say("error-export"));
    const wanted = /** @type {const} */ ([work, field, size_px, lines, transparent]);
    if (format === "pdf") return new Blob([await written(formats.pdf(signal, ...wanted))], { type: TYPES.pdf });
    const raster_px = Math.min(Math.max(size_px, RASTER_PX.least), RASTER_PX.most);
    const raster = await this.#with(raster_px, false, signal, (shades) => painted(shades, transparent, signal));
    const svg = formats.svg(signal, ...wanted, new Uint8Array(await raster.arrayBuffer()));
    return new Blob([await written(svg)], { type: TYPES.svg });
  }

  /**
   * Uses a picture of the drawing as it is.
   * @template T
   * @param {number} size_px
   * @param {boolean} lines
   * @param {AbortSignal} signal
   * @param {(picture: import("./engine.js").Export) => Promise<T>} use
   */
  async #with(size_px, lines, signal, use) {
    // It may take its time, all at once: what has been clicked comes before.
    await breath();
    signal.throwIfAborted();
    const { engine, say } = this.#shell;
    const picture = engine.export(size_px, lines);
    if (!picture) throw new Error(say("error-export"));
    try {
      return await use(picture);
    } finally {
      picture.free();
    }
  }
}

function hasSize() {
  return input("export-size").validity.valid;
}

/** @returns {Format} */
function format() {
  return /** @type {any} */ (part("export").querySelector("[name=format]:checked")).value;
}

/** @returns {Kind} */
function kind() {
  return format() === "png" ? "pixels" : "shapes";
}

/** @param {string} text */
function tell(text) {
  part("export-status").textContent = text;
}

/**
 * @param {import("./engine.js").Export} picture
 * @param {boolean} transparent
 * @param {AbortSignal} signal
 */
function painted(picture, transparent, signal) {
  const start = performance.now();
  return pngOf(picture, transparent, async (share) => {
    part("export-progress").hidden = performance.now() - start < PATIENCE_MS;
    /** @type {HTMLProgressElement} */ (part("export-share")).value = share;
    await breath();
    signal.throwIfAborted();
  });
}

/** Lets clicks come in between. */
function breath() {
  return new Promise((wake) => setTimeout(wake));
}

/**
 * What is waited for, unless that is stopped before.
 * @template T
 * @param {Promise<T>} coming
 * @param {AbortSignal} signal
 * @returns {Promise<T>}
 */
function stoppable(coming, signal) {
  const stopped = new Promise((_, reject) => signal.addEventListener("abort", () => reject(signal.reason), { once: true }));
  return Promise.race([coming, stopped]);
}

/**
 * Shows that something is waited for, as a file that is being written, if it takes long.
 * @template T
 * @param {Promise<T>} file
 */
async function written(file) {
  const timer = setTimeout(() => {
    // How far it is nobody knows.
    part("export-share").removeAttribute("value");
    part("export-progress").hidden = false;
  }, PATIENCE_MS);
  return file.finally(() => clearTimeout(timer));
}
