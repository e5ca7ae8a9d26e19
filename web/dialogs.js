// What the dialogs have in common, which are fetched when they are opened.

/**
 * A dialog in the page, with what closes it.
 * @param {string} id also the key of its title
 * @param {string} content markup of what is below the title
 * @param {Record<string, () => unknown>} acts what its buttons do, by their `data-action`
 * @param {(root: ParentNode) => void} label puts words into elements, by their `data-text` and `data-label`
 */
export function makeDialog(id, content, acts, label) {
  const made = document.createRange().createContextualFragment(`<dialog id="${id}" closedby="any" data-label="${id}">
    <header><h2 data-text="${id}"></h2>
      <button type="button" class="icon" data-action="close" data-label="close"><svg aria-hidden="true"><use href="#i-close"/></svg></button></header>
    ${content}</dialog>`);
  const dialog = /** @type {HTMLDialogElement} */ (made.firstElementChild);
  for (const [action, act] of Object.entries({ close: () => dialog.close(), ...acts })) {
    dialog.querySelector(`[data-action="${action}"]`)?.addEventListener("click", act);
  }
  label(made);
  document.body.append(made);
  return dialog;
}

/**
 * Opens a dialog at its beginning, with the focus on its first choice, not on what closes it.
 * @param {HTMLDialogElement} dialog
 */
export function openDialog(dialog) {
  dialog.showModal();
  dialog.addEventListener("close", backToCanvas, { once: true });
  const first = dialog.querySelector(":checked") ?? dialog.querySelector("ul button, .body :is(input, button)");
  /** @type {HTMLElement | null} */ (first)?.focus({ preventScroll: true });
}

/** What had the focus may be gone with the panel that it was in: a dialog closes those that are open. */
function backToCanvas() {
  if (document.activeElement === document.body) document.getElementById("canvas")?.focus();
}
