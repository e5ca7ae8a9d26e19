// The service worker that keeps this version of the page for when there is no connection, and word of the next one.

/** This version's folder, as `offline/worker.js` knows it. */
const FOLDER = new URL("../", import.meta.url).href;

/** @type {ServiceWorkerRegistration | undefined} */
let registration;

/**
 * Has this version kept, and follows what comes after it. On a host that has no worker the page does without either.
 * @param {() => void} ready called when another version is there
 */
export async function followVersions(ready) {
  if (!navigator.serviceWorker) return;
  try {
    registration = await navigator.serviceWorker.register("worker.js", { updateViaCache: "none" });
  } catch (fault) {
    return console.info(fault);
  }
  if (registration.waiting) ready();
  registration.addEventListener("updatefound", () => follow(registration?.installing, ready));
  follow(registration.installing, ready);
  document.addEventListener("visibilitychange", () => document.hidden || registration?.update().catch(console.info));
}

/** Goes on with the version that is ready. The drawing is kept: the page opens with it. */
export function takeVersion() {
  const { waiting } = registration ?? {};
  const reload = () => location.reload();
  // Another tab may have brought it already.
  if (!waiting) return reload();
  navigator.serviceWorker.addEventListener("controllerchange", reload, { once: true });
  waiting.postMessage("take over");
}

/** Says that this version is in use, as long as there is the page. */
export function holdVersion() {
  navigator.locks?.request(FOLDER, { mode: "shared" }, () => new Promise(() => {})).catch(console.info);
}

/**
 * @param {ServiceWorker | null | undefined} worker
 * @param {() => void} ready
 */
function follow(worker, ready) {
  worker?.addEventListener("statechange", () => {
    // The first version of all has none before it.
    if (worker.state === "installed" && registration?.active) ready();
  });
}
