// The browser's storage of drawings: of each its entry in the list, its work as exact bytes, the picture under its lines,
// and a small picture of it.

const NAME = "scumble";
const VERSION = 2;

/** A storage that has not answered after this long is taken for one that does not work. */
const PATIENCE_MS = 5_000;

/** Firefox commits also what has failed, once it is told to commit; others are not known to do better. */
const COMMITS_WELL = navigator.userAgent.includes("Chrome/");

const OPENING_TRIES = 5;
const OPENING_PAUSE_MS = 200;

/**
 * @typedef {object} Entry
 * @property {string} id
 * @property {string} name
 * @property {number} writer counts whose it has been
 * @property {number} seen when it was written or opened last, in milliseconds since 1970
 * @property {boolean} isUnsaved whether it has been changed since it was in a file
 * @property {any} [handle] that file
 * @property {boolean} [isAside] whether it could not be opened
 */

/** @typedef {{number: number, bytes: Uint8Array<ArrayBuffer>}} Image a picture under lines, as its work knows it */

/** @typedef {Record<string, IDBObjectStore>} Stores */

/** @type {Promise<IDBDatabase> | undefined} */
let database;

/** All drawings, the one that was seen last first. */
export async function entries() {
  const all = await read(["entries"], (stores) => stores.entries.getAll());
  return /** @type {Entry[]} */ (all).sort((a, b) => b.seen - a.seen);
}

/**
 * A drawing as it was written last, all parts of it at once.
 * @param {string} id
 * @returns {Promise<{entry?: Entry, work?: unknown, image?: unknown}>}
 */
export async function drawing(id) {
  /** @type {IDBRequest[]} */
  let [entry, work, image] = [];
  await transact(["entries", "works", "images"], "readonly", (stores) => {
    [entry, work, image] = [stores.entries.get(id), stores.works.get(id), stores.images.get(id)];
  });
  return { entry: entry?.result, work: work?.result, image: image?.result };
}

/**
 * Makes a drawing somebody's: whoever has had it writes it no more.
 * @param {string} id
 * @returns {Promise<number>} the number of the new writer
 */
export async function claim(id) {
  let writer = 0;
  await change(["entries", "ended"], (stores) =>
    whereThere(id, stores, (entry) => {
      const before = Number(entry.writer) || 0;
      writer = before + 1;
      stores.ended.put(true, [id, before]);
      stores.entries.put({ ...entry, writer });
    }));
  return writer;
}

/** A PNG. @param {string} id @returns {Promise<Uint8Array<ArrayBuffer> | undefined>} */
export const picture = (id) => read(["pictures"], (stores) => stores.pictures.get(id));

/**
 * Writes a drawing, unless it has become somebody else's.
 * @param {Entry} entry
 * @param {Uint8Array} work
 * @param {boolean} isBare whether the image that is there is its own no more
 * @returns {Promise<boolean>} whether it was written
 */
export const write = (entry, work, isBare) =>
  writeAs(entry, ["entries", "works", "images"], ({ entries, works, images }) => {
    entries.put(entry);
    works.put(work, entry.id);
    if (isBare) images.delete(entry.id);
  });

/**
 * Writes a drawing's image, unless the drawing has become somebody else's.
 * @param {Entry} entry
 * @param {Image} image
 * @returns {Promise<boolean>} whether it was written
 */
export const writeImage = (entry, image) => writeAs(entry, ["images"], ({ images }) => images.put(image, entry.id));

/**
 * @param {Entry} entry
 * @param {string[]} names
 * @param {(stores: Stores) => void} act
 */
async function writeAs({ id, writer }, names, act) {
  try {
    await change([...names, "ended"], (stores) => {
      // All of it fails where the mark is there. So the storage checks by itself, while the page is busy.
      const mark = [id, writer];
      stores.ended.add(true, mark);
      stores.ended.delete(mark);
      act(stores);
      if (COMMITS_WELL) stores.ended.transaction.commit();
    });
    return true;
  } catch (fault) {
    if (/** @type {any} */ (fault)?.name === "ConstraintError") return false;
    throw fault;
  }
}

/**
 * Writes the picture of a drawing that is there.
 * @param {string} id
 * @param {Uint8Array} picture
 */
export const writePicture = (id, picture) =>
  change(["entries", "pictures"], (stores) => whereThere(id, stores, () => stores.pictures.put(picture, id)));

/**
 * Notes something of a drawing in its entry.
 * @param {string} id
 * @param {Partial<Entry>} more
 */
export const note = (id, more) =>
  change(["entries"], (stores) => whereThere(id, stores, (entry) => stores.entries.put({ ...entry, ...more })));

/** Marks a drawing that could not be opened. @param {string} id */
export const putAside = (id) => note(id, { isAside: true });

/** @param {string} id */
export const remove = (id) =>
  change(["entries", "works", "images", "pictures", "ended"], ({ ended, ...stores }) => {
    for (const store of Object.values(stores)) store.delete(id);
    ended.delete(IDBKeyRange.bound([id], [id, []]));
  });

/**
 * @param {string} id
 * @param {Stores} stores
 * @param {(entry: Entry) => void} act
 */
function whereThere(id, stores, act) {
  const request = stores.entries.get(id);
  request.onsuccess = () => request.result && act(request.result);
}

/**
 * @param {string[]} names
 * @param {(stores: Stores) => IDBRequest} ask
 * @returns {Promise<any>}
 */
async function read(names, ask) {
  /** @type {IDBRequest | undefined} */
  let request;
  await transact(names, "readonly", (stores) => (request = ask(stores)));
  return request?.result;
}

/**
 * @param {string[]} names
 * @param {(stores: Stores) => void} act
 */
function change(names, act) {
  return transact(names, "readwrite", act);
}

/**
 * Ends once all of it is in the storage, or none of it. Where the storage does not answer, it may be either.
 * @param {string[]} names
 * @param {IDBTransactionMode} mode
 * @param {(stores: Stores) => void} act
 */
async function transact(names, mode, act) {
  const transaction = (await (database ??= opened())).transaction(names, mode);
  /** @type {Promise<void>} */
  const done = new Promise((resolve, reject) => {
    transaction.oncomplete = () => resolve();
    transaction.onabort = () => reject(transaction.error);
    setTimeout(() => reject(new Error("the storage does not answer")), PATIENCE_MS);
  });
  try {
    act(Object.fromEntries(names.map((name) => [name, transaction.objectStore(name)])));
  } catch (fault) {
    done.catch(() => undefined);
    abort(transaction);
    throw fault;
  }
  return done;
}

/** @param {IDBTransaction} transaction */
function abort(transaction) {
  try {
    transaction.abort();
  } catch {
    // The browser has done so.
  }
}

function opened() {
  const opening = openedAfter(OPENING_TRIES);
  opening.catch(() => (database = undefined));
  return opening;
}

/**
 * @param {number} tries
 * @returns {Promise<IDBDatabase>}
 */
async function openedAfter(tries) {
  try {
    return await openedOnce();
  } catch (fault) {
    // After a crash the files of the storage may be in use still.
    if (tries === 1 || /** @type {any} */ (fault)?.name !== "UnknownError") throw fault;
    await new Promise((wake) => setTimeout(wake, OPENING_PAUSE_MS));
    return openedAfter(tries - 1);
  }
}

/** @returns {Promise<IDBDatabase>} */
function openedOnce() {
  return new Promise((resolve, reject) => {
    const request = indexedDB.open(NAME, VERSION);
    request.onupgradeneeded = ({ oldVersion }) => {
      if (oldVersion < 1) {
        request.result.createObjectStore("entries", { keyPath: "id" });
        request.result.createObjectStore("works");
        request.result.createObjectStore("pictures");
        // Marks of an id and a writer whose it is no more.
        request.result.createObjectStore("ended");
      }
      request.result.createObjectStore("images");
    };
    request.onsuccess = () => resolve(watched(request.result));
    request.onerror = () => reject(request.error);
    setTimeout(() => reject(new Error("the storage does not open")), PATIENCE_MS);
  });
}

/**
 * A database that the browser closes is opened again when it is needed; one that a newer page needs is let go.
 * @param {IDBDatabase} opened
 */
function watched(opened) {
  opened.onclose = () => (database = undefined);
  opened.onversionchange = () => {
    opened.close();
    database = undefined;
  };
  return opened;
}
