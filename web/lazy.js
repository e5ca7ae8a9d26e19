// Parts of the page that are fetched at their first use.

import { make } from "./elements.js";
import { haveWords, say } from "./messages.js";
import { failed } from "./toolbar.js";

/** @type {Promise<unknown> | undefined} */
let style;

/** Has the style and the words of such parts, which come with the first one. */
export function haveRest() {
  return Promise.all([haveStyle(), haveWords()]);
}

function haveStyle() {
  style ??= new Promise((resolve, reject) => {
    const href = new URL("later.css", import.meta.url).href;
    const onerror = () => {
      link.remove();
      style = undefined;
      reject();
    };
    const link = make("link", { rel: "stylesheet", href, onload: resolve, onerror });
    document.head.append(link);
  });
  return style;
}

/**
 * @template T, M
 * @param {() => Promise<M>} fetch a module
 * @param {(module: M) => T} build what it is for, once its words are there
 */
export function lazily(fetch, build) {
  const load = async () => {
    try {
      const [module] = await Promise.all([fetch(), haveRest()]);
      part.now = build(module);
    } catch (fault) {
      console.warn(fault);
      part.loading = undefined;
      throw new Error(say("error-panel"));
    }
  };
  const part = {
    /** What was fetched, if it is there. @type {T | undefined} */
    now: undefined,
    /** Its fetching, from the first use on. @type {Promise<void> | undefined} */
    loading: undefined,
    /** Uses it, at once where it is there, and says what goes wrong. @param {(it: T) => unknown} act */
    async use(act) {
      try {
        if (!part.now) await (part.loading ??= load());
        if (part.now) await act(part.now);
      } catch (fault) {
        failed(fault);
      }
    },
    /** Takes it out of the page, to be made anew at its next use, as in another language. */
    forget() {
      /** @type {any} */ (part.now)?.remove();
      part.now = part.loading = undefined;
    },
  };
  return part;
}
