// The second wasm module, in a worker: what it does takes no time of the page's, and is stopped by ending the worker.

/**
 * @typedef {{name: string, args: unknown[]}} Question a function of the module, and what it is called with
 * @typedef {{result: unknown} | {sentence: string} | {failure: "missing" | "stopped"}} Answer what it gave, what it says is wrong, or why it cannot answer
 */

const functions = (async () => {
  const functions = await import(new URL("../pkg/files/scumble_files.js", import.meta.url).href);
  await functions.default();
  return functions;
})();

addEventListener("message", async ({ data }) => postMessage(await answer(data)));

/**
 * @param {Question} question
 * @returns {Promise<Answer>}
 */
async function answer({ name, args }) {
  const module = await functions.catch(console.warn);
  if (!module) return { failure: "missing" };
  try {
    return { result: plain(module[name](...args)) };
  } catch (fault) {
    // A plain error is the module's own sentence. What has stopped in the middle is not entered again.
    if (/** @type {Error} */ (fault)?.constructor === Error) return { sentence: /** @type {Error} */ (fault).message };
    console.warn(fault);
    return { failure: "stopped" };
  }
}

/** An object of the module as one that can be sent. @param {any} result */
function plain(result) {
  if (typeof result?.free !== "function") return result;
  const fields = Object.entries(Object.getOwnPropertyDescriptors(Object.getPrototypeOf(result)));
  const sent = Object.fromEntries(fields.filter(([, field]) => field.get).map(([name]) => [name, result[name]]));
  result.free();
  return sent;
}
