// The drawings that have been opened: what they are called, and what of them has been saved. The module tells them apart
// by numbers, and their states by revisions.

import { say } from "./messages.js";

/** @typedef {Map<number, Uint8Array<ArrayBuffer>>} Images files of pictures to trace, by the module's numbers */

/**
 * @typedef {object} Drawing
 * @property {string} name
 * @property {any} [handle] the file that it is saved to again, where the browser gives such
 * @property {boolean} [isBrought] whether somebody's work was in it as it came
 * @property {boolean} [isDeleted] whether its user has deleted it from the browser's storage and not come back to it
 * @property {string} [id] what the browser's storage has it as, if it does
 * @property {number} [writer] whose it is there, by a number
 * @property {number} [kept] the revision that is there
 * @property {Images} images those that have lain under its lines, for undo and redo to come back to
 * @property {number} [keptImage] which of them is in the browser's storage; NaN while that is not known
 * @property {number} revision
 * @property {number} saved the revision that was opened or saved last
 */

export class Drawings {
  /** @type {Map<number, Drawing>} */
  #all = new Map();
  /** @type {Drawing} */
  #shown = { name: say("untitled"), images: new Map(), revision: 0, saved: 0 };
  #coming = this.#shown;
  #changed;

  /** @param {(drawing: Drawing) => void} changed called when another drawing is shown, or the one that is has changed */
  constructor(changed) {
    this.#changed = changed;
  }

  /** The one that is shown. */
  get shown() {
    return this.#shown;
  }

  /** Whether it is the page that is there before any is opened. */
  get isBlank() {
    return [undefined, this.#shown].includes(this.#all.get(0));
  }

  /** Whether any of them that is still wanted has been changed since it was saved, and is not kept by the browser either. */
  get areAtRisk() {
    return [...this.#all.values()].some((drawing) => isUnsaved(drawing) && !isKept(drawing) && !drawing.isDeleted);
  }

  /**
   * What belongs to the drawing that the module is about to open.
   * @param {Partial<Drawing> & {name: string}} drawing
   */
  expect(drawing) {
    this.#coming = { images: new Map(), revision: 0, saved: 0, ...drawing };
    return this.#coming;
  }

  /**
   * What the module says about the one that is shown.
   * @param {{sheet: number, revision: number}} state
   */
  follow({ sheet, revision }) {
    this.#shown = this.#all.get(sheet) ?? this.#coming;
    Object.assign(this.#shown, { revision, isDeleted: false });
    this.#all.set(sheet, this.#shown);
    this.#changed(this.#shown);
  }

  /** Lets go of what neither undo nor redo comes back to. @param {number} sheet */
  close(sheet) {
    this.#all.get(sheet)?.images.clear();
  }

  /** Whether one of them is what the browser's storage has as this. @param {string} id */
  have(id) {
    return [...this.#all.values()].some((drawing) => drawing.id === id);
  }

  /**
   * Gives up one that cannot be shown.
   * @param {number} sheet
   * @returns {Drawing | undefined}
   */
  leave(sheet) {
    const drawing = this.#all.get(sheet);
    if (drawing) drawing.isDeleted = true;
    return drawing;
  }

  /**
   * @param {Drawing} drawing
   * @param {number} revision that was saved
   * @param {{name: string, handle?: any}} place
   */
  keep(drawing, revision, place) {
    Object.assign(drawing, place, { saved: revision });
    this.#changed(this.#shown);
  }

  /**
   * Takes note that drawings are gone from the browser's storage. Undo may come back to them: they are kept anew then.
   * @param {string} id
   * @returns {Drawing[]} those that it was of
   */
  forget(id) {
    const gone = [...this.#all.values()].filter((drawing) => drawing.id === id);
    const nowhere = { id: undefined, writer: undefined, kept: undefined, keptImage: undefined };
    for (const drawing of gone) Object.assign(drawing, nowhere, { isBrought: true, isDeleted: true });
    return gone;
  }
}

/** @param {Drawing} drawing */
export function isUnsaved(drawing) {
  return drawing.revision !== drawing.saved;
}

/** Whether the browser's storage has it as it is. @param {Drawing} drawing */
export function isKept(drawing) {
  return drawing.revision === drawing.kept;
}

/** Whether there is something to keep: of samples and blank pages only what somebody has done to them. @param {Drawing} drawing */
export function isWork(drawing) {
  return drawing.id !== undefined || drawing.revision > 0 || drawing.isBrought === true;
}

/** The name of a file without its last extension. @param {string} name */
export function stem(name) {
  return name.replace(/(.)\.[^.]*$/, "$1");
}
