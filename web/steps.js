// The way to the panel of the history, which is fetched when it is opened first.

import { haveRest } from "./lazy.js";
import { say } from "./messages.js";
import { done, failed } from "./toolbar.js";

const button = /** @type {HTMLButtonElement} */ (document.getElementById("history"));

export class Steps {
  #engine;
  /** @type {import("./history.js").History | undefined} */
  #panel;

  /** @param {import("./engine.js").Engine} engine */
  constructor(engine) {
    this.#engine = engine;
    button.addEventListener("click", () => this.#load());
  }

  /** Opens or closes it, as its button does. */
  toggle() {
    button.click();
  }

  follow() {
    this.#panel?.follow();
  }

  /** Has the panel made anew when it is opened next, in the language of the page. */
  forget() {
    this.#panel?.remove();
    this.#panel = undefined;
  }

  /** From then on the button opens it by itself. */
  async #load() {
    if (this.#panel) return;
    try {
      const [{ History }] = await Promise.all([import("./history.js"), haveRest()]);
      this.#panel ??= new History({ say, history: () => this.#engine.history(), go: (place) => this.#go(place) });
      this.#panel.open();
    } catch (fault) {
      console.warn(fault);
      failed(new Error(say("error-panel")));
    }
  }

  /** @param {number} place */
  #go(place) {
    this.#engine.command("go-to", place);
    const { steps = [] } = this.#engine.history() ?? {};
    done(say("went-to", { text: say(["history-start", ...steps][place]) }));
  }
}
