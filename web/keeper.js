// Keeps drawings in the browser's storage after each gesture. One that another tab has written meanwhile is gone on
// with as a copy, so that no tab writes over another's work.

import { hold } from "./hold.js";
import { say } from "./messages.js";
import * as storage from "./storage.js";

/** @typedef {import("./drawings.js").Drawing} Drawing */
/** @typedef {{work: Uint8Array, revision: number}} State a drawing as it is to be written */

/** After a failure it is tried again this much later. */
const RETRY_MS = 5_000;

/** A drawing's picture is made once nothing has been done for so long. */
const REST_MS = 1_000;

const ID_BYTES = 16;

/** Where a tab remembers its drawing while the page is loaded again. */
const SHOWN = "scumble-shown";

/**
 * @typedef {object} Page
 * @property {() => Uint8Array | undefined} work the exact bytes of the drawing that is shown
 * @property {() => Promise<Blob | undefined>} picture a small picture of it
 * @property {(drawing: Drawing) => void} kept called when a drawing was written
 * @property {(drawing: Drawing, before: string) => void} copied called when a drawing goes on as a copy of another
 * @property {(fails: boolean) => void} failing called when keeping begins to fail, and when it works again
 */

export class Keeper {
  #page;
  /** @type {Map<Drawing, State>} What is still to be written. */
  #late = new Map();
  /** @type {Set<Drawing>} Those that are being written. */
  #writing = new Set();
  #fails = false;
  /** @type {Drawing | undefined} The one that is shown, where its picture is not as it is. */
  #unpictured;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #retry;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #rest;

  /** @param {Page} page */
  constructor(page) {
    this.#page = page;
  }

  /**
   * Writes the drawing that is shown.
   * @param {Drawing} drawing
   */
  keep(drawing) {
    const work = this.#page.work();
    if (!work) return;
    this.#late.set(drawing, { work, revision: drawing.revision });
    this.#unpictured = drawing;
    clearTimeout(this.#rest);
    this.#rest = setTimeout(() => this.pictureNow(), REST_MS);
    this.#write(drawing);
  }

  /** Does at once what was to be done later: the page may go away. */
  hurry() {
    for (const drawing of this.#late.keys()) this.#write(drawing);
    this.pictureNow();
  }

  /** Makes the picture of the drawing that is shown, as before another is. */
  async pictureNow() {
    clearTimeout(this.#rest);
    const drawing = this.#unpictured;
    this.#unpictured = undefined;
    if (!drawing) return;
    try {
      const picture = await this.#page.picture();
      if (picture && drawing.id) await storage.writePicture(drawing.id, new Uint8Array(await picture.arrayBuffer()));
    } catch (fault) {
      console.warn(fault);
    }
  }

  /** @param {Drawing} drawing */
  async #write(drawing) {
    if (this.#writing.has(drawing)) return;
    this.#writing.add(drawing);
    try {
      for (let state; (state = this.#late.get(drawing)); ) {
        await this.#writeOnce(drawing, state);
        if (this.#late.get(drawing) === state) this.#late.delete(drawing);
        drawing.kept = state.revision;
        sessionStorage.setItem(SHOWN, drawing.id ?? "");
        this.#page.kept(drawing);
      }
      this.#tell(false);
    } catch (fault) {
      console.warn(fault);
      this.#tell(true);
      clearTimeout(this.#retry);
      this.#retry = setTimeout(() => this.hurry(), RETRY_MS);
    }
    this.#writing.delete(drawing);
  }

  /** @param {boolean} fails */
  #tell(fails) {
    if (this.#fails !== fails) this.#page.failing(fails);
    this.#fails = fails;
  }

  /**
   * @param {Drawing} drawing
   * @param {State} state
   */
  async #writeOnce(drawing, { work, revision }) {
    const id = (drawing.id ??= claimed());
    const edition = (drawing.edition ?? 0) + 1;
    const { name, handle, saved } = drawing;
    const entry = { id, name, edition, seen: Date.now(), isUnsaved: revision !== saved, handle };
    if (await storage.write(entry, work)) {
      drawing.edition = edition;
      return;
    }
    Object.assign(drawing, { id: undefined, edition: undefined, ...copyOf(name) });
    this.#page.copied(drawing, name);
    await this.#writeOnce(drawing, { work, revision });
  }
}

/** What a drawing has of another that it is a copy of: not the file, which it would write over. @param {string} name */
function copyOf(name) {
  return { name: say("copy", { name }), handle: undefined };
}

/** A new drawing's id, held for this tab. */
function claimed() {
  const bytes = crypto.getRandomValues(new Uint8Array(ID_BYTES));
  const id = [...bytes].map((byte) => byte.toString(16).padStart(2, "0")).join("");
  hold(id);
  return id;
}

/**
 * Drawings to begin with, best first: the one that this tab had before the page was loaded again, then those that were
 * seen last. What could not be opened is not among them.
 */
export async function lastIds() {
  const own = sessionStorage.getItem(SHOWN);
  const ids = (await storage.entries()).filter(({ isAside }) => !isAside).map(({ id }) => id);
  return ids.sort((a, b) => Number(b === own) - Number(a === own));
}

/**
 * A drawing to go on with: itself, or a copy of one that another tab has.
 * @param {string} id
 * @returns {Promise<{drawing: Partial<Drawing> & {name: string}, work: unknown} | undefined>} nothing where it is gone
 */
export async function take(id) {
  const isOurs = await hold(id);
  // Only what is read under the lock is what was written last.
  const { entry, work } = await storage.drawing(id);
  if (!entry) return undefined;
  const { name, edition, handle, isUnsaved } = entry;
  const identity = isOurs ? { id, name, edition, handle, kept: 0 } : copyOf(name);
  return { drawing: { ...identity, saved: isUnsaved ? -1 : 0 }, work };
}
