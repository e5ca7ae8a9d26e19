// A slider with two directions: what a place in a square is, from its left edge to the right and from the lower to the upper.

import { make } from "./elements.js";

/** A key goes so far, and so far with Shift, where the square's sides are 1. */
const STEP = 0.01;
const FAR = 0.1;

/** Where each key goes. @type {Record<string, [number, number]>} */
const WAYS = {
  ArrowLeft: [-STEP, 0],
  ArrowRight: [STEP, 0],
  ArrowUp: [0, STEP],
  ArrowDown: [0, -STEP],
  PageUp: [0, FAR],
  PageDown: [0, -FAR],
  Home: [-1, 0],
  End: [1, 0],
};

export class Square {
  #place = [0, 0];
  #change;
  element;

  /**
   * @param {string} label
   * @param {string} kind what it is, as there is no role for it
   * @param {(x: number, y: number) => void} change called with each place, also on the way
   * @param {() => void} settle called when a place stays
   */
  constructor(label, kind, change, settle) {
    this.#change = change;
    this.element = make("div", { className: "square", role: "slider", tabIndex: 0, "aria-label": label, "aria-roledescription": kind });
    this.element.append(make("i", {}));
    this.element.addEventListener("keydown", (event) => this.#key(event));
    this.element.addEventListener("pointerdown", (event) => this.#press(event));
    this.element.addEventListener("pointermove", (event) => this.#drag(event));
    for (const kind of ["keyup", "pointerup", "pointercancel", "blur"]) this.element.addEventListener(kind, settle);
  }

  /**
   * @param {number} x from 0 to 1
   * @param {number} y likewise, upwards
   * @param {string} text what this place is
   */
  show(x, y, text) {
    this.#place = [x, y];
    this.element.style.setProperty("--x", `${100 * x}%`);
    this.element.style.setProperty("--y", `${100 - 100 * y}%`);
    // There is one number for two: the first of them.
    this.element.setAttribute("aria-valuenow", String(Math.round(100 * x)));
    this.element.setAttribute("aria-valuetext", text);
  }

  /** @param {number} x @param {number} y */
  #go(x, y) {
    this.#change(within(x), within(y));
  }

  /** @param {KeyboardEvent} event */
  #key(event) {
    const way = WAYS[event.key];
    if (!way || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    const [x, y] = this.#place;
    const times = event.shiftKey ? FAR / STEP : 1;
    this.#go(x + times * way[0], y + times * way[1]);
  }

  /** @param {PointerEvent} event */
  #press(event) {
    if (event.button !== 0) return;
    this.element.setPointerCapture(event.pointerId);
    this.#drag(event);
  }

  /** @param {PointerEvent} event */
  #drag(event) {
    if (!this.element.hasPointerCapture(event.pointerId)) return;
    const { left, bottom, width, height } = this.element.getBoundingClientRect();
    this.#go((event.clientX - left) / width, (bottom - event.clientY) / height);
  }
}

/** @param {number} part */
function within(part) {
  return Math.min(Math.max(part, 0), 1);
}
