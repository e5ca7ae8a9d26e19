// The page's service worker: it keeps one whole version of the page, so that it opens without a connection.
//
// Each version is a folder of its own, with a cache of its own, named by the folder's URL, and pages name nothing but
// files of their own folder. So a page that was opened with another version goes on with that one's files, whichever
// worker is in charge. A new version waits until no page is open, or somebody asks for it.

const worker = /** @type {ServiceWorkerGlobalScope} */ (/** @type {unknown} */ (self));
const { scope } = worker.registration;
const FOLDER = `${scope}${VERSION}/`;

worker.addEventListener("install", (event) => event.waitUntil(install()));
worker.addEventListener("activate", (event) => event.waitUntil(worker.clients.claim()));
worker.addEventListener("message", ({ data }) => void (data === "take over" && worker.skipWaiting()));
worker.addEventListener("fetch", (event) => {
  const { request } = event;
  if (request.method !== "GET" || !request.url.startsWith(scope)) return;
  event.respondWith(answer(request));
  if (request.mode === "navigate") event.waitUntil(tidy());
});

/** Fetches all files; one that is not as it was built, as while a host gets another version, fails all of it. */
async function install() {
  const cache = await caches.open(FOLDER);
  await Promise.all(Object.entries(FILES).map(([path, integrity]) => keep(cache, path, integrity)));
}

/**
 * @param {Cache} cache
 * @param {string} path
 * @param {string} integrity
 */
async function keep(cache, path, integrity) {
  const url = scope + path;
  // An attempt before may have come so far.
  if (await cache.match(url)) return;
  const response = await fetch(url, { integrity, cache: "no-cache" });
  if (!response.ok) throw new Error(`${url}: ${response.status}`);
  await cache.put(url, response);
}

/**
 * Drops the versions that no page has open; each page holds a lock that is named as its folder. Only once this worker has
 * been asked for a page: one that the worker before it was asked for may be on its way, and holds none yet.
 */
async function tidy() {
  if (worker.registration.installing || worker.registration.waiting) return;
  const { held = [] } = await navigator.locks.query();
  const used = new Set([FOLDER, ...held.map(({ name }) => name)]);
  const names = (await caches.keys()).filter((name) => isVersion(name) && !used.has(name));
  await Promise.all(names.map((name) => caches.delete(name)));
}

/** Whether a cache is one of ours: the origin may have other pages, and other copies of this one. @param {string} name */
function isVersion(name) {
  return name.startsWith(scope) && /^v-[\da-f]+\/$/.test(name.slice(scope.length));
}

/** @param {Request} request */
async function answer(request) {
  const path = request.url.slice(scope.length).replace(/[?#].*$/, "");
  const url = scope + (path === "index.html" ? "" : path);
  const options = { ignoreVary: true };
  const own = await (await caches.open(FOLDER)).match(url, options);
  return own ?? (await caches.match(url, options)) ?? fetch(request);
}
