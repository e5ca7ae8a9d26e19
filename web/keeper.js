// Keeps drawings in the browser's storage after each gesture. One that another tab has written meanwhile is gone on
// with as a copy, so that no tab writes over another's work.

import { isKept, isWork } from "./drawings.js";
import { hold } from "./hold.js";
import { say } from "./messages.js";
import { remember, remembered } from "./remember.js";
import * as storage from "./storage.js";

/** @typedef {import("./drawings.js").Drawing} Drawing */
/** @typedef {import("./storage.js").Image} Image */
/** @typedef {{work: Uint8Array, image?: Image, revision: number}} State a drawing as it is to be written */
/** @typedef {"" | "image" | "all"} Failing what cannot be kept: pictures under lines alone, or anything */

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
 * @property {() => Image | undefined} image the picture under its lines
 * @property {() => Drawing} shown that drawing
 * @property {() => Promise<Blob | undefined>} picture a small picture of it
 * @property {() => boolean} isMaking whether that would have to wait for the picture on the canvas
 * @property {(drawing: Drawing) => void} kept called when a drawing was written
 * @property {(drawing: Drawing, before: string) => void} copied called when a drawing goes on as a copy of another
 * @property {(fails: Failing) => void} failing called when keeping begins to fail, and when it works again
 */

export class Keeper {
  #page;
  /** @type {Map<Drawing, State>} The last states of drawings, as long as they are not written. */
  #late = new Map();
  /** The last states of drawings that have brought another image to the storage. @type {WeakMap<Drawing, State>} */
  #bringing = new WeakMap();
  /** Files of images that the storage has not taken: they are too large to be sent again with each stroke. @type {WeakSet<Uint8Array>} */
  #unfit = new WeakSet();
  /** @type {Failing} */
  #fails = "";
  /** @type {Drawing | undefined} The one that was shown last, where its picture is not as it is. */
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
   * Keeps the drawing that is shown, if there is something to keep.
   * @param {Drawing} drawing
   */
  follow(drawing) {
    if (isKept(drawing) && !this.#late.has(drawing)) this.#see(drawing);
    else if (isWork(drawing)) this.keep(drawing);
  }

  /**
   * Writes a drawing that has been saved, of one that is not shown any more that it was: its work is there.
   * @param {Drawing} drawing
   */
  saved(drawing) {
    const { id, name, handle, revision, saved } = drawing;
    if (drawing === this.#page.shown()) this.keep(drawing);
    else if (id) storage.note(id, { name, handle, isUnsaved: revision !== saved }).catch(console.warn);
  }

  /**
   * Writes the drawing that is shown.
   * @param {Drawing} drawing
   */
  keep(drawing) {
    const work = this.#page.work();
    if (!work) return;
    const state = { work, image: this.#page.image(), revision: drawing.revision };
    this.#late.set(drawing, state);
    this.#pictureLater(drawing);
    this.#write(drawing, state);
  }

  /** Leaves drawings that were deleted as they are. @param {Drawing[]} drawings */
  drop(drawings) {
    for (const drawing of drawings) this.#late.delete(drawing);
    this.#recover();
    // There is more room.
    this.hurry();
  }

  /** Does at once what was to be done later: the page may go away. */
  hurry() {
    this.#unfit = new WeakSet();
    if (this.#fails) for (const [drawing, state] of this.#late) this.#write(drawing, state);
    if (!this.#page.isMaking()) this.pictureNow();
  }

  /** Makes the picture of the drawing that is shown, as before another is; but where that is still made, it is done without. */
  async pictureNow() {
    clearTimeout(this.#rest);
    const drawing = this.#unpictured;
    this.#unpictured = undefined;
    // It may have gone without a word, as one whose picture is not waited for.
    if (drawing !== this.#page.shown() || this.#page.isMaking()) return;
    try {
      const picture = await this.#page.picture();
      if (picture && drawing.id) await storage.writePicture(drawing.id, new Uint8Array(await picture.arrayBuffer()));
    } catch (fault) {
      console.warn(fault);
    }
  }

  /**
   * Notes that a drawing is shown, which is kept as it is.
   * @param {Drawing} drawing
   */
  #see(drawing) {
    if (!drawing.id) return;
    remember(SHOWN, drawing.id, "sessionStorage");
    storage.note(drawing.id, { seen: Date.now() }).catch(console.warn);
    this.#pictureLater(drawing);
  }

  /** @param {Drawing} drawing */
  #pictureLater(drawing) {
    this.#unpictured = drawing;
    clearTimeout(this.#rest);
    this.#rest = setTimeout(() => (this.#page.isMaking() ? this.#pictureLater(drawing) : this.pictureNow()), REST_MS);
  }

  /**
   * Each state is sent to the storage as it comes, whatever has become of the one before: a page that is busy hears of
   * that late. Only the last one tells whether the drawing is kept.
   * @param {Drawing} drawing
   * @param {State} state
   */
  async #write(drawing, state) {
    const entry = entryOf(drawing, state.revision);
    const isOther = this.#isOther(drawing, state);
    const written = storage.write(entry, state.work, isOther);
    const brought = !isOther || this.#bring(entry, state);
    try {
      const isOurs = await written;
      const isWhole = await brought;
      if (isOurs && isOther) this.#brought(drawing, state, isWhole);
      if (this.#late.get(drawing) !== state) return;
      if (!isOurs) this.#copy(drawing, state);
      else if (isWhole) this.#kept(drawing, state);
      else this.#failed("image");
    } catch (fault) {
      console.warn(fault);
      if (this.#late.get(drawing) === state) this.#failed("all");
    }
  }

  /**
   * Whether the storage has another image than a state: it is large, and goes there only then. Until that is known to be
   * there, all states bring it.
   * @param {Drawing} drawing
   * @param {State} state
   */
  #isOther(drawing, state) {
    if (state.image?.number === drawing.keptImage) return false;
    drawing.keptImage = NaN;
    this.#bringing.set(drawing, state);
    return true;
  }

  /**
   * Sends a state's image by itself: one that there is no room for keeps no stroke out.
   * @param {storage.Entry} entry
   * @param {State} state
   * @returns whether the storage has it
   */
  async #bring(entry, { image }) {
    if (!image) return true;
    if (this.#unfit.has(image.bytes)) return false;
    return storage.writeImage(entry, image).catch((fault) => (console.warn(fault), false));
  }

  /**
   * @param {Drawing} drawing
   * @param {State} state
   * @param {boolean} isThere whether the storage has its image; otherwise it has none
   */
  #brought(drawing, state, isThere) {
    if (!isThere && state.image) this.#unfit.add(state.image.bytes);
    if (this.#bringing.get(drawing) === state) drawing.keptImage = isThere ? state.image?.number : undefined;
  }

  /**
   * @param {Drawing} drawing
   * @param {State} state
   */
  #kept(drawing, { revision }) {
    this.#late.delete(drawing);
    drawing.kept = revision;
    this.#page.kept(drawing);
    this.#recover();
  }

  /**
   * @param {Drawing} drawing
   * @param {State} state
   */
  #copy(drawing, state) {
    const before = drawing.name;
    Object.assign(drawing, { id: undefined, writer: undefined, keptImage: undefined, ...copyOf(before) });
    this.#page.copied(drawing, before);
    this.#write(drawing, state);
  }

  /** @param {Failing} fails */
  #failed(fails) {
    this.#tell(fails);
    clearTimeout(this.#retry);
    if (fails === "all") this.#retry = setTimeout(() => this.hurry(), RETRY_MS);
  }

  /** Nothing fails any more once nothing is left to be written. */
  #recover() {
    if (this.#late.size === 0) this.#tell("");
  }

  /** @param {Failing} fails */
  #tell(fails) {
    if (this.#fails !== fails) this.#page.failing(fails);
    this.#fails = fails;
  }
}

/**
 * What the storage's list says of a drawing.
 * @param {Drawing} drawing
 * @param {number} revision of it that is written
 * @returns {storage.Entry}
 */
function entryOf(drawing, revision) {
  const id = (drawing.id ??= claimed());
  const { name, handle, saved, writer = 0 } = drawing;
  remember(SHOWN, id, "sessionStorage");
  return { id, name, writer, seen: Date.now(), isUnsaved: revision !== saved, handle };
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
  const own = remembered(SHOWN, "sessionStorage");
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
  const writer = isOurs ? await storage.claim(id).catch(goOnWhereHeld) : undefined;
  // What is read now is what was written last: nobody else writes it any more.
  const { entry, work, image } = await storage.drawing(id);
  if (!entry) return undefined;
  const { name, handle, isUnsaved } = entry;
  const images = imagesOf(image);
  const [keptImage] = images.keys();
  const identity = isOurs ? { id, name, writer: writer ?? entry.writer, handle, kept: 0, keptImage } : copyOf(name);
  return { drawing: { ...identity, images, saved: isUnsaved ? -1 : 0 }, work };
}

/**
 * A storage that is full gives drawings out all the same: the lock alone says whose they are.
 * @param {unknown} fault
 */
function goOnWhereHeld(fault) {
  if (!navigator.locks) throw fault;
  console.warn(fault);
  return undefined;
}

/**
 * The picture under the lines, as far as the storage has one that can be used.
 * @param {any} image
 * @returns {import("./drawings.js").Images}
 */
function imagesOf(image) {
  const isSound = image?.bytes instanceof Uint8Array && Number.isInteger(image.number);
  return new Map(isSound ? [[image.number, image.bytes]] : []);
}
