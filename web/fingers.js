// Fingers on the canvas, and taps of several at once.

/** @typedef {{ x: number, y: number }} Place */

/** A tap takes so long at most, and each finger of it goes so far at most, in CSS pixels. */
const TAP_MS = 300;
const TAP_PX = 12;

/** What touches more, in CSS pixels, is a hand. */
const FINGER_PX = 40;

export class Fingers {
  /** Where each was last. @type {Map<number, Place>} */
  places = new Map();
  /** Whether all that they have done since there was none may still be a tap, of which nothing moves. */
  isTap = false;
  /** Where each came down since then. @type {Map<number, Place>} */
  #from = new Map();
  #began_ms = 0;

  /** @param {PointerEvent} event @param {Place} place */
  down({ pointerId, timeStamp, width, height }, place) {
    if (this.places.size === 0) {
      this.#from.clear();
      this.#began_ms = timeStamp;
      this.isTap = true;
    }
    this.isTap &&= Math.max(width, height) <= FINGER_PX;
    this.places.set(pointerId, place);
    this.#from.set(pointerId, place);
  }

  /** @param {PointerEvent} event of a finger @param {Place} place where it is now */
  move({ pointerId, timeStamp }, { x, y }) {
    const from = this.#from.get(pointerId);
    this.isTap &&= timeStamp - this.#began_ms <= TAP_MS && !!from && Math.hypot(x - from.x, y - from.y) <= TAP_PX;
  }

  /**
   * A finger goes up, or the system takes it away.
   * @param {PointerEvent} event
   * @param {Place} place
   * @param {"up" | "cancel"} phase
   * @returns {number} how many have tapped, once the last of them is up
   */
  up(event, place, phase) {
    if (!this.places.has(event.pointerId)) return 0;
    this.move(event, place);
    this.isTap &&= phase === "up";
    this.places.delete(event.pointerId);
    return this.places.size === 0 && this.isTap ? this.#from.size : 0;
  }
}
