// The way to the panel of the history, which is fetched when it is opened first.

import { lazily } from "./lazy.js";
import { say } from "./messages.js";
import { nameOfColor as nameOf } from "./swatches.js";
import { done } from "./toolbar.js";

const button = /** @type {HTMLButtonElement} */ (document.getElementById("history"));

export class Steps {
  #engine;
  #panel = lazily(
    () => import("./history.js"),
    ({ History }) => new History({ say, nameOf, done, history: () => this.#engine.history(), go: (place) => this.#engine.command("go-to", place) }),
  );

  /** @param {import("./engine.js").Engine} engine */
  constructor(engine) {
    this.#engine = engine;
    // A panel that is there is opened by the button itself.
    button.addEventListener("click", () => this.#panel.now ?? this.#panel.use((panel) => panel.open()));
  }

  /** Opens or closes it, as its button does. */
  toggle() {
    button.click();
  }

  follow() {
    this.#panel.now?.follow();
  }

  /** Has the panel made anew when it is opened next, in the language of the page. */
  forget() {
    this.#panel.forget();
  }
}
