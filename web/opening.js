// The ways by which a drawing comes into the page: files, links, samples, and those that the browser has kept; and, with
// files, what belongs to the one that is shown: palettes, pictures to trace.

import { begin, end, expectLong, isBusy } from "./busy.js";
import { formats, isLink } from "./formats.js";
import { letGo, removed } from "./hold.js";
import { lastIds, take } from "./keeper.js";
import { say } from "./messages.js";
import { FIRST, sampleName, sampleWork } from "./samples.js";
import { putAside } from "./storage.js";
import { done, failed, tell, warn } from "./toolbar.js";
import { checkImage } from "./tracing.js";

/** The number by which work from a file knows the picture under its lines, as in `work_file.rs`. */
const FILE_IMAGE = 1;

/** What the page is seen to be busy with. */
const OPENING = "opening";

/** Work of more bytes than this takes a while. */
const LARGE_BYTES = 100_000;

/** @typedef {Partial<import("./drawings.js").Drawing> & {name: string}} Coming what is known of a drawing before it is there */
/** @typedef {import("./formats.js").Opened} Opened */

export class Opening {
  #engine;
  #drawings;
  #keeper;
  #tracing;
  /** What is being taken from the storage: one that is asked for again is there twice. @type {string[]} */
  #taking = [];
  /** Counts what has been asked for: what comes after something else was asked for is dropped. */
  #asked = 0;
  /** Ends what is on its way. */
  #job = new AbortController();

  /**
   * @param {import("./engine.js").Engine} engine
   * @param {import("./drawings.js").Drawings} drawings
   * @param {import("./keeper.js").Keeper} keeper
   * @param {import("./tracing.js").Tracing} tracing
   */
  constructor(engine, drawings, keeper, tracing) {
    this.#engine = engine;
    this.#drawings = drawings;
    this.#keeper = keeper;
    this.#tracing = tracing;
  }

  /** @param {import("./files.js").Coming} file a drawing, or a palette or a picture to trace for the one that is shown */
  file({ name, bytes, handle }) {
    return this.#open({ name, handle, isBrought: true }, async (signal) => formats.open(await bytes, name, signal));
  }

  /** @param {string} text a link, SVG, a colour, or colours for the palette */
  text(text) {
    if (isLink(text)) return this.#link(text);
    const color = text.trim().toLowerCase();
    if (/^#([\da-f]{3}){1,2}$/.test(color)) return this.#color(color);
    // SVG begins with the first, lists of colours have the last.
    if (!/^\s*(<|GIMP Palette)|#[\da-f]{3}/i.test(text)) return warn(say("no-drawing"));
    return this.file({ name: text.includes("<") ? "SVG" : say("text"), bytes: Promise.resolve(new TextEncoder().encode(text)) });
  }

  /** @param {string} digits # and three or six, of which each of three stands for two */
  #color(digits) {
    const color = digits.length === 4 ? digits.replace(/\w/g, "$&$&") : digits;
    this.#engine.command("color", color);
    done(say("picked", { color }));
  }

  /**
   * @param {{name: string, file: string}} sample
   * @param {boolean} isColored whether with its scribbles
   */
  sample(sample, isColored) {
    return this.#open({ name: sampleName(sample) }, async () => ({ work: await sampleWork(sample.file, isColored), notes: "" }));
  }

  /**
   * Opens the link in the address, which is then the page's own again: its drawing may become another.
   * @returns what went wrong, if anything did; the page has been told
   */
  async address() {
    const link = location.hash;
    history.replaceState(null, "", location.pathname + location.search);
    const fault = await this.#link(link);
    // A reload may bring the version that can open it.
    if (fault && isLink(link) && !location.hash) history.replaceState(null, "", link);
    return fault;
  }

  /**
   * Goes on with a drawing that the browser has kept, or with a copy where another tab has it.
   * @param {string} id
   * @returns what went wrong, if anything did; the page has been told
   */
  async kept(id) {
    return this.#doing("", async (signal) => {
      // A page that has stopped shows no drawing, however sound.
      if (!this.#engine.isRunning) throw new Error(say("error-stopped"));
      this.#taking.push(id);
      try {
        await this.#go(id, signal);
      } finally {
        this.#taking.splice(this.#taking.indexOf(id), 1);
        if (!this.#taking.includes(id) && !this.#drawings.have(id)) letGo(id);
      }
    });
  }

  /**
   * @param {string} id
   * @param {AbortSignal} signal
   */
  async #go(id, signal) {
    const { drawing, work } = await taken(id);
    signal.throwIfAborted();
    if (!(work instanceof Uint8Array) || !(await this.#show(drawing, work, "", signal))) throw await damaged(id);
    if (!drawing.id) tell(say("opened-copy", drawing));
  }

  /** Whether what is on its way is seen to take long. */
  get isLong() {
    return isBusy(OPENING);
  }

  /** Stops what is on its way. */
  stop() {
    this.#drop();
    end(OPENING);
    return this.stopped("opening-stopped");
  }

  /**
   * What was on its way is not any more. Where nothing has been there before, a sample is.
   * @param {string} message
   */
  async stopped(message) {
    if (!this.#drawings.isBlank) tell(say(message));
    else if (!(await this.sample(FIRST, false))) tell(say("start"));
  }

  /** Stops the making of a picture. A drawing that has none yet goes with it. */
  stopMaking() {
    const { shown } = this.#drawings;
    this.#engine.command("stop-making");
    if (shown !== this.#drawings.shown) this.#discard(shown);
  }

  /**
   * What was opened turned out to have no picture: it stays out of the way of the page's start.
   * @param {import("./drawings.js").Drawing | undefined} drawing
   * @param {string} sentence why
   */
  async unopened(drawing, sentence) {
    if (drawing) this.#keeper.drop([drawing]);
    if (drawing?.id && !this.#discard(drawing)) putAside(drawing.id).catch(console.warn);
    if (this.#drawings.isBlank) await this.sample(FIRST, false);
    else if (drawing) tell(say("unopened", drawing));
    failed(new Error(sentence));
  }

  /**
   * Has the browser keep a drawing no longer that came to nothing.
   * @param {import("./drawings.js").Drawing} drawing
   * @returns whether it came only now, and nobody has worked on it
   */
  #discard({ id, isBrought, revision }) {
    if (!id || !isBrought || revision > 0) return false;
    this.#keeper.drop(this.#drawings.forget(id));
    removed(id).catch(console.warn);
    return true;
  }

  /** Drops what is on its way; gives the number of what is asked for now. */
  #drop() {
    this.#job.abort();
    this.#engine.command("stop-preparing");
    return ++this.#asked;
  }

  /**
   * Opens the link in the address, or else what was open last, or else a sample; unless something has been opened
   * meanwhile.
   * @param {() => void} isNew called where it was a sample, as nobody has worked here
   */
  async begin(isNew) {
    const fault = location.hash ? await this.address() : undefined;
    if (this.#asked > 0 && !fault) return;
    const ticket = this.#asked;
    // A storage that does not work is told of when there is something to keep.
    const ids = await lastIds().catch((fault) => (console.warn(fault), []));
    if (ticket === this.#asked) await this.#first(ids, fault, isNew);
  }

  /**
   * Opens the first drawing that can be opened, or else a sample.
   * @param {string[]} ids
   * @param {unknown} fault what has gone wrong before
   * @param {() => void} isNew
   */
  async #first(ids, fault, isNew) {
    for (const id of ids) {
      const own = await this.kept(id);
      if (!own) return fault && failed(fault);
      fault ??= own;
      if (!this.#engine.isRunning) return undefined;
    }
    const own = await this.sample(FIRST, false);
    if (fault) return failed(fault);
    if (own) return undefined;
    isNew();
    return tell(say("start"));
  }

  /**
   * Opens a link beside the work that is there.
   * @param {string} link
   */
  async #link(link) {
    const before = this.#drawings.shown;
    const fault = await this.#open({ name: say("shared-drawing"), isBrought: true }, (signal) => formats.openLink(link, signal));
    if (this.#drawings.shown !== before && before.revision > 0) tell(say("opened-beside", { before: before.name }));
    return fault;
  }

  /**
   * Opens something.
   * @param {Coming} drawing
   * @param {(signal: AbortSignal) => Promise<Opened>} come
   * @returns what went wrong, if anything did; the page has been told
   */
  #open(drawing, come) {
    return this.#doing(drawing.name, async (signal) => {
      const { work, notes, palette, image } = await whole(come(signal));
      const isToTrace = image && work.length === 0;
      if (isToTrace) await checkImage(image);
      signal.throwIfAborted();
      if (palette) this.#take(palette, drawing.name, notes);
      else if (isToTrace) this.#trace(image, drawing.name);
      else await this.#show({ ...drawing, images: new Map(image && [[FILE_IMAGE, image]]) }, work, notes, signal);
    });
  }

  /**
   * Does what can be stopped and, where it takes long, is seen to go on. What was on its way before is dropped.
   * @param {string} name of what is to be opened
   * @param {(signal: AbortSignal) => Promise<void>} act
   * @returns what went wrong, if anything did; the page has been told
   */
  async #doing(name, act) {
    const ticket = this.#drop();
    this.#job = new AbortController();
    // What stops it is not to be covered.
    closeOpen();
    begin(OPENING, say("opening", { name }));
    try {
      await act(this.#job.signal);
      return undefined;
    } catch (fault) {
      return ticket === this.#asked ? told(fault) : undefined;
    } finally {
      if (ticket === this.#asked) end(OPENING);
    }
  }

  /**
   * Gives the drawing that is shown another palette.
   * @param {string[]} palette
   * @param {string} name of its file
   * @param {string} notes
   */
  #take(palette, name, notes) {
    this.#engine.command("palette", palette);
    done(say("palette-taken", { name, notes }));
  }

  /**
   * Lays a picture under the lines of the drawing that is shown.
   * @param {Uint8Array<ArrayBuffer>} image
   * @param {string} name of its file
   */
  #trace(image, name) {
    this.#tracing.lay(image);
    done(say("traced", { name }));
  }

  /**
   * @param {Coming} drawing
   * @param {Uint8Array} work
   * @param {string} notes
   * @param {AbortSignal} signal
   * @returns whether the module could open it
   */
  async #show(drawing, work, notes, signal) {
    if (work.length > LARGE_BYTES) await expectLong();
    await this.#engine.prepare(work, signal);
    // What the pen, a slider or an arrow key has done so far is kept with the drawing that goes.
    this.#engine.pointer("up", new Float32Array());
    this.#engine.command("settle");
    this.#keeper.pictureNow();
    const expected = this.#drawings.expect(drawing);
    this.#engine.command("open", { work, notes });
    return this.#drawings.shown === expected;
  }
}

/**
 * Work with its lines, which come from a sample where it has only the name of that.
 * @param {Promise<Opened>} coming
 * @returns {Promise<Opened>}
 */
async function whole(coming) {
  const opened = await coming;
  const { work, notes, lacks, image } = opened;
  if (!lacks) return opened;
  return { work: await formats.onSample(work, await sampleWork(lacks)), notes, image };
}

function closeOpen() {
  // What was asked for twice may be there one over the other.
  const open = document.querySelector("dialog:focus-within") ?? document.querySelector("dialog[open]");
  /** @type {HTMLDialogElement | null} */ (open)?.close();
}

/** @param {unknown} fault */
function told(fault) {
  failed(fault);
  return fault;
}

/** @param {string} id */
async function taken(id) {
  const taken = await take(id).catch((fault) => {
    console.warn(fault);
    throw new Error(say("error-storage"));
  });
  if (!taken) throw new Error(say("error-gone"));
  return taken;
}

/**
 * Keeps what cannot be opened out of the way of the page's start.
 * @param {string} id
 */
async function damaged(id) {
  await putAside(id).catch(console.warn);
  return new Error(say("error-kept"));
}
