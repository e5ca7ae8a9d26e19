// Files in and out: opened, dropped or pasted SVG, and pictures to keep.

/** @typedef {(name: string, bytes: Uint8Array, scribbles?: unknown[]) => void} Open */

/**
 * Takes files from the file dialog, from drops on the page and from the clipboard, which may also hold SVG text.
 * @param {Open} open
 * @param {() => void} unreadable called where the browser cannot read a file
 */
export function receive(open, unreadable) {
  const input = /** @type {HTMLInputElement} */ (document.getElementById("file"));
  const take = (/** @type {DataTransfer | null} */ data) => {
    const file = data?.files[0];
    const text = data?.getData("text/plain") ?? "";
    if (file) read(file, open, unreadable);
    else if (text.trim() !== "") open("SVG", new TextEncoder().encode(text));
  };
  input.addEventListener("change", () => {
    const file = input.files?.[0];
    if (file) read(file, open, unreadable);
    input.value = "";
  });
  window.addEventListener("paste", (event) => take(event.clipboardData));
  receiveDrops(take);
}

/** Shows the browser's dialog for files. */
export function choose() {
  document.getElementById("file")?.click();
}

/** @param {(data: DataTransfer | null) => void} take */
function receiveDrops(take) {
  const stage = document.getElementById("stage");
  const mark = (/** @type {boolean} */ on) => stage?.classList.toggle("drop", on);
  window.addEventListener("dragover", (event) => {
    event.preventDefault();
    mark(true);
  });
  window.addEventListener("dragleave", (event) => {
    if (event.relatedTarget === null) mark(false);
  });
  window.addEventListener("drop", (event) => {
    event.preventDefault();
    mark(false);
    take(event.dataTransfer);
  });
}

/**
 * @param {File} file
 * @param {Open} open
 * @param {() => void} unreadable
 */
async function read(file, open, unreadable) {
  let bytes;
  try {
    bytes = new Uint8Array(await file.arrayBuffer());
  } catch {
    unreadable();
    return;
  }
  open(file.name, bytes);
}

/**
 * Hands a file to the browser to keep.
 * @param {string} name
 * @param {Blob} file
 */
export function download(name, file) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(file);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}
