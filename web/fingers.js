// Fingers on the canvas, and taps of several at once.

/** @typedef {{ x: number, y: number }} Place */

/** A tap takes so long at most, and each finger of it goes so far at most, in CSS pixels. */
const TAP_MS = 300;
const TAP_PX = 12;

export class Fingers {
  /** Where each was last. @type {Map<number, Place>} */
  places = new Map();
  /** Where each came down that has since there was none. @type {Map<number, Place>} */
  #from = new Map();
  #began_ms = 0;
  #isTap = false;

  /** @param {PointerEvent} event @param {Place} place */
  down({ pointerId, timeStamp }, place) {
    if (this.places.size === 0) {
      this.#from.clear();
      this.#began_ms = timeStamp;
      this.#isTap = true;
    }
    this.places.set(pointerId, place);
    this.#from.set(pointerId, place);
  }

  /**
   * Whether all of it may still be a tap, of which nothing moves.
   * @param {PointerEvent} event of a finger that has moved
   * @param {Place} place
   */
  isTap({ pointerId, timeStamp }, place) {
    const from = this.#from.get(pointerId) ?? place;
    this.#isTap &&= timeStamp - this.#began_ms <= TAP_MS && Math.hypot(place.x - from.x, place.y - from.y) <= TAP_PX;
    return this.#isTap;
  }

  /**
   * A finger goes up.
   * @param {PointerEvent} event
   * @param {Place} place
   * @returns {number} how many have tapped, once the last of them is up
   */
  up(event, place) {
    const isTap = this.isTap(event, place);
    return this.places.delete(event.pointerId) && this.places.size === 0 && isTap ? this.#from.size : 0;
  }
}
