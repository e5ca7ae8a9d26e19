// What all dialogs have in common.

/**
 * Opens a dialog at its beginning, with the focus on its first choice, not on what closes it.
 * @param {HTMLDialogElement} dialog
 */
export function openDialog(dialog) {
  dialog.showModal();
  const first = dialog.querySelector(":checked") ?? dialog.querySelector("ul button, .body :is(input, button)");
  /** @type {HTMLElement | null} */ (first)?.focus({ preventScroll: true });
}

export function closeOpen() {
  // What was asked for twice may be there one over the other.
  const open = document.querySelector("dialog:focus-within") ?? document.querySelector("dialog[open]");
  /** @type {HTMLDialogElement | null} */ (open)?.close();
}
