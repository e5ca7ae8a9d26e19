// A pen for the keyboard: cross hairs over the canvas that the arrow keys move; Enter puts them down and lifts them. It has
// nothing of the page but what is handed to it, so that it is a file of its own.

/** How far an arrow key goes, in CSS pixels: as it is, and with Shift. */
const STEPS_PX = [8, 40];

/**
 * @typedef {object} Shell what it has of the page
 * @property {HTMLElement} stage the element around the canvas
 * @property {import("./engine.js").Engine} engine
 * @property {typeof import("./elements.js").make} make
 * @property {(key: string) => string} say the text of a message
 * @property {(text: string) => void} tell
 */

export class KeyboardPen {
  #shell;
  #cross;
  #isDown = false;
  /** Where it is, in CSS pixels from the canvas' corner. @type {[number, number]} */
  #place = [0, 0];

  /** @param {Shell} shell */
  constructor(shell) {
    this.#shell = shell;
    const { stage } = shell;
    this.#cross = shell.make("div", { id: "cross", hidden: true });
    stage.append(this.#cross);
    // Another pen takes over, or what has the keys now.
    stage.addEventListener("pointerdown", () => this.#leave(), true);
    stage.addEventListener("focusout", () => this.#lift());
    new MutationObserver(() => this.#hear()).observe(/** @type {Node} */ (document.getElementById("status")), { childList: true });
  }

  /** Undo takes back what it draws as well: it is up then. */
  #hear() {
    if (document.getElementById("status")?.textContent === this.#shell.say("undone")) this.#isDown = false;
  }

  /** @param {string} key of a message */
  #tell(key) {
    this.#shell.tell(this.#shell.say(key));
  }

  /** Enter: it is shown first, then put down and lifted; a dropper picks at once. */
  press() {
    if (this.#cross.hidden) return this.#show();
    if (this.#isDown) return this.#lift();
    this.#isDown = true;
    this.#touch("down");
    if (document.documentElement.dataset.tool === "pick") this.#lift();
    else this.#tell("pen-down");
    return undefined;
  }

  /**
   * An arrow key moves it, and the view at its rim.
   * @param {number[]} direction
   * @param {boolean} isFar
   * @returns whether it is there to be moved, and no other control has the keys
   */
  move(direction, isFar) {
    if (this.#cross.hidden || !(document.activeElement instanceof HTMLCanvasElement)) return false;
    const { clientWidth, clientHeight } = this.#shell.stage;
    const wanted = this.#place.map((at, i) => at + STEPS_PX[Number(isFar)] * direction[i]);
    const [x, y] = (this.#place = [within(wanted[0], clientWidth), within(wanted[1], clientHeight)]);
    if (x !== wanted[0] || y !== wanted[1]) this.#shell.engine.command("pan", [x - wanted[0], y - wanted[1]]);
    this.#draw();
    if (this.#isDown) this.#touch("move");
    return true;
  }

  /** Escape: drops what it has done since it was put down, or else puts it away, and tells whether there was any of it. */
  drop() {
    if (this.#cross.hidden) return false;
    if (!this.#isDown) this.#cross.hidden = true;
    else this.#shell.engine.pointer("cancel", new Float32Array());
    this.#isDown = false;
    return true;
  }

  #show() {
    const { clientWidth, clientHeight } = this.#shell.stage;
    this.#place = [Math.round(clientWidth / 2), Math.round(clientHeight / 2)];
    this.#cross.hidden = false;
    this.#draw();
    this.#tell("pen-shown");
  }

  #lift() {
    if (this.#isDown) this.#touch("up");
    this.#isDown = false;
  }

  #leave() {
    this.#lift();
    this.#cross.hidden = true;
  }

  #draw() {
    this.#cross.style.translate = this.#place.map((at) => `${at}px`).join(" ");
  }

  /** @param {import("./engine.js").Phase} phase */
  #touch(phase) {
    this.#shell.engine.pointer(phase, new Float32Array([...this.#place, 1]));
  }
}

/**
 * @param {number} at
 * @param {number} end
 */
function within(at, end) {
  return Math.max(0, Math.min(end, at));
}
