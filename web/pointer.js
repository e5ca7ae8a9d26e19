// Pointers over the canvas: the pen does what its tool does, or picks a colour while Alt is held; wheel, pinch, middle
// button and Space move and zoom the view.

import { Fingers } from "./fingers.js";

/** @typedef {import("./engine.js").Engine} Engine */
/** @typedef {import("./fingers.js").Place} Place */

/** The button of the eraser at the other end of a pen. */
const ERASER_BUTTON = 5;
/** A second finger drops a scribble that has fewer points than this, and ends a longer one. */
const DROPPED_BELOW_POINTS = 10;
/** Zoom by a wheel: this much of the logarithm a pixel, and at most so many pixels an event. */
const ZOOM_PER_PX = 0.01;
const ZOOM_LIMIT_PX = 24;
const PX_PER_LINE = 16;
/** Two fingers rotate the page once they have turned so far. */
const TWIST_DEGREES = 12;
/** What a tap of so many fingers does. @type {Record<number, string>} */
const TAPS = { 2: "undo", 3: "redo" };

export class Pointers {
  #stage;
  #engine;
  /** @type {number | null} The pointer that uses the tool. */
  #pen = null;
  #penPoints = 0;
  /** Whether that is a pen. */
  #isPen = false;
  /** @type {number | null} The pointer that drags the view. */
  #hand = null;
  #fingers = new Fingers();
  /** Whether fingers draw; once there is a pen they do not, or hands that rest would. */
  #fingersDraw = true;
  #hasPen = false;
  /** @type {Place} Where the hand was last. */
  #last = { x: 0, y: 0 };
  /** @type {"pan" | "rotate" | ""} What a drag does while a key is held. */
  #held = "";
  /** Whether the hand rotates. */
  #isRotating = false;
  /** How far two fingers have turned since the second came down, in degrees. */
  #twist = 0;
  #isFinger = false;
  /** Whether what was no stroke is dropped just now. */
  isTakingBack = false;
  #isAdding;
  #tell;

  /**
   * @param {HTMLElement} stage the element around the canvas
   * @param {Engine} engine
   * @param {() => boolean} isAdding whether each press adds, as one with Shift does
   * @param {(fingersDraw: boolean) => void} tell called when fingers draw no longer, or again
   */
  constructor(stage, engine, isAdding, tell) {
    this.#stage = stage;
    this.#engine = engine;
    this.#isAdding = isAdding;
    this.#tell = tell;
    const on = /** @type {(kind: string, act: (event: any) => void) => void} */ (
      (kind, act) => stage.addEventListener(kind, act, { passive: false })
    );
    on("pointerdown", (event) => this.#down(event));
    on("pointermove", (event) => this.#move(event));
    on("pointerup", (event) => this.#up(event, "up"));
    on("pointercancel", (event) => this.#up(event, "cancel"));
    on("wheel", (event) => this.#wheel(event));
    on("contextmenu", (event) => event.preventDefault());
  }

  /** Drops what was no stroke, as a second finger shows, or a pen beside a hand: there is nothing to be said of it. */
  #takeBack() {
    this.isTakingBack = true;
    this.cancel();
    this.isTakingBack = false;
  }

  /** Drops what the pen has done since it came down, and tells whether it was. */
  cancel() {
    if (this.#pen === null) return false;
    this.#drop();
    this.#engine.pointer("cancel", new Float32Array());
    return true;
  }

  /** Fingers are given more room. @param {boolean} isFinger */
  #tellFinger(isFinger) {
    if (isFinger === this.#isFinger) return;
    this.#isFinger = isFinger;
    this.#engine.command("finger", isFinger);
  }

  /**
   * While a key is held the pointer drags the view, or rotates it.
   * @param {"pan" | "rotate" | ""} held
   */
  hold(held) {
    this.#held = held;
    this.#stage.classList.toggle("hand", held !== "" || this.#hand !== null);
  }

  /** @param {PointerEvent} event */
  #down(event) {
    const target = /** @type {Element} */ (event.target).closest("canvas, #frame");
    if (!target) return;
    this.#stage.querySelector("canvas")?.focus();
    event.preventDefault();
    // A press beside a panel closes that, and no more.
    if (document.querySelector(":popover-open:not(#alert)")) return;
    const isFinger = event.pointerType === "touch";
    if (event.pointerType === "pen") this.#meetPen();
    // A hand that rests beside the pen.
    if (isFinger && this.#isPen) return;
    this.#stage.setPointerCapture(event.pointerId);
    this.#tellFinger(isFinger);
    if (isFinger) this.#fingers.down(event, this.#place(event));
    const isDrag = event.button === 1 || (event.button === 0 && (this.#held || (isFinger && !this.#fingersDraw)));
    if (isFinger && this.#fingers.places.size > 1) this.#startPinch();
    else if (isDrag) this.#startDrag(event);
    else if (this.#pen === null && this.#hand === null) this.#startStroke(event);
  }

  /** @param {PointerEvent} event */
  #move(event) {
    this.#stage.classList.toggle("pick", event.altKey);
    if (event.pointerType === "pen" && !this.#hasPen) this.#meetPen();
    const place = this.#place(event);
    const { places } = this.#fingers;
    const isFinger = places.has(event.pointerId);
    if (isFinger) this.#fingers.move(event, place);
    if (event.pointerId === this.#pen) this.#stroke("move", event);
    else if (isFinger && this.#fingers.isTap) return;
    else if (event.pointerId === this.#hand) this.#drag(place);
    else if (isFinger && places.size === 2) this.#pinch(event);
    if (isFinger) places.set(event.pointerId, place);
  }

  /** With the first event of a pen, fingers draw no longer; what lies on the canvas as it comes down is a hand. */
  #meetPen() {
    if (!this.#hasPen) this.#letFingersDraw(false);
    this.#hasPen = true;
    if (this.#fingers.places.size === 0) return;
    this.#fingers.places.clear();
    this.#hand = null;
    this.hold(this.#held);
    this.#takeBack();
  }

  /** Fingers draw, or move the picture as they did not. */
  turnFingers() {
    this.#letFingersDraw(!this.#fingersDraw);
  }

  /** @param {boolean} fingersDraw */
  #letFingersDraw(fingersDraw) {
    this.#fingersDraw = fingersDraw;
    this.#tell(fingersDraw);
  }

  /**
   * @param {PointerEvent} event
   * @param {"up" | "cancel"} phase
   */
  #up(event, phase) {
    const tapped = this.#fingers.up(event, this.#place(event), phase);
    if (tapped in TAPS) this.#engine.command(TAPS[tapped]);
    if (event.pointerId === this.#hand) {
      this.#hand = null;
      this.hold(this.#held);
    }
    if (event.pointerId !== this.#pen) return;
    this.#stroke(phase, event);
    this.#drop();
  }

  #drop() {
    this.#pen = null;
    this.#isPen = false;
  }

  /** @param {PointerEvent} event */
  #startStroke(event) {
    const main = event.altKey ? "pick" : event.shiftKey || this.#isAdding() ? "add" : "down";
    const phase = event.button === 0 ? main : event.button === ERASER_BUTTON ? "erase" : null;
    if (phase === null) return;
    this.#pen = event.pointerId;
    this.#isPen = event.pointerType === "pen";
    this.#penPoints = 0;
    this.#stroke(phase, event);
  }

  /**
   * @param {import("./engine.js").Phase} phase
   * @param {PointerEvent} event
   */
  #stroke(phase, event) {
    const coalesced = phase === "move" ? event.getCoalescedEvents?.() ?? [] : [];
    const events = coalesced.length > 0 ? coalesced : [event];
    this.#penPoints += events.length;
    const samples = events.flatMap((e) => {
      const { x, y } = this.#place(e);
      // What feels no pressure reports one all the same.
      return [x, y, e.pointerType === "pen" ? e.pressure : 1];
    });
    this.#engine.pointer(phase, new Float32Array(samples));
  }

  /** @param {PointerEvent} event */
  #startDrag(event) {
    this.cancel();
    this.#hand = event.pointerId;
    this.#isRotating = event.button === 0 && this.#held === "rotate";
    this.#last = this.#place(event);
    this.hold(this.#held);
  }

  /** @param {Place} to */
  #drag(to) {
    const middle = { x: this.#stage.clientWidth / 2, y: this.#stage.clientHeight / 2 };
    if (this.#isRotating) this.#rotate(middle, turn(angle(middle, this.#last), angle(middle, to)));
    else this.#engine.command("pan", [to.x - this.#last.x, to.y - this.#last.y]);
    this.#last = to;
  }

  /**
   * @param {Place} about
   * @param {number} degrees clockwise
   */
  #rotate({ x, y }, degrees) {
    this.#engine.command("rotate-at", [x, y, degrees]);
  }

  #startPinch() {
    this.#twist = 0;
    this.#hand = null;
    this.hold(this.#held);
    if (this.#pen === null) return;
    if (this.#penPoints < DROPPED_BELOW_POINTS || this.#fingers.isTap) this.#takeBack();
    else this.#engine.pointer("up", new Float32Array());
    this.#drop();
  }

  /** @param {PointerEvent} event */
  #pinch(event) {
    const { places } = this.#fingers;
    const before = span(places);
    places.set(event.pointerId, this.#place(event));
    const after = span(places);
    this.#engine.command("pan", [after.x - before.x, after.y - before.y]);
    if (before.length > 0) this.#engine.command("zoom-at", [after.x, after.y, after.length / before.length]);
    const twist = turn(before.angle, after.angle);
    // Who has begun to rotate goes on, also back.
    if (Math.abs(this.#twist) >= TWIST_DEGREES) this.#rotate(after, twist);
    else this.#twist += twist;
  }

  /** @param {WheelEvent} event */
  #wheel(event) {
    event.preventDefault();
    const unit = event.deltaMode === WheelEvent.DOM_DELTA_PIXEL ? 1 : PX_PER_LINE;
    const [dx, dy] = [event.deltaX * unit, event.deltaY * unit];
    const { x, y } = this.#place(event);
    if (event.ctrlKey || event.metaKey) {
      const px = Math.max(-ZOOM_LIMIT_PX, Math.min(ZOOM_LIMIT_PX, dy));
      this.#engine.command("zoom-at", [x, y, Math.exp(-px * ZOOM_PER_PX)]);
    } else if (event.shiftKey && dx === 0) this.#engine.command("pan", [-dy, 0]);
    else this.#engine.command("pan", [-dx, -dy]);
  }

  /**
   * CSS pixels from the canvas' corner.
   * @param {MouseEvent} event
   */
  #place(event) {
    const box = this.#stage.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  }
}

/**
 * The middle of the first two fingers, how far apart they are, and where the second is from the first.
 * @param {Map<number, Place>} fingers
 */
function span(fingers) {
  const [a, b] = [...fingers.values()];
  return { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2, length: Math.hypot(a.x - b.x, a.y - b.y), angle: angle(a, b) };
}

/**
 * In which direction a place lies from another, in degrees, clockwise from the right.
 * @param {Place} from
 * @param {Place} to
 */
function angle(from, to) {
  return (Math.atan2(to.y - from.y, to.x - from.x) * 180) / Math.PI;
}

/**
 * How far a direction turns to another: the short way.
 * @param {number} from
 * @param {number} to
 */
function turn(from, to) {
  return to - from - 360 * Math.round((to - from) / 360);
}
