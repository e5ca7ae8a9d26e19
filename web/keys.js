// The keyboard: chords to actions. The buttons name their chords in their tooltips.

/** @type {Record<string, string>} */
const CHORDS = {
  "ctrl+o": "open",
  "ctrl+s": "save",
  "ctrl+shift+e": "export",
  "ctrl+z": "undo",
  "ctrl+shift+z": "redo",
  "ctrl+y": "redo",
  "ctrl+=": "zoom-in",
  "ctrl++": "zoom-in",
  "ctrl+shift++": "zoom-in",
  "ctrl+-": "zoom-out",
  "ctrl+0": "zoom-reset",
  "shift+1": "fit",
  "b": "tool-scribble",
  "e": "tool-erase",
  "i": "tool-pick",
  "h": "tool-hand",
  "shift+l": "show-lines",
  "shift+b": "show-scribbles",
  "shift+r": "show-result",
  "s": "other-kind",
  "x": "swap-colors",
  "[": "brush-smaller",
  "]": "brush-larger",
  "escape": "cancel",
  "arrowleft": "pan-left",
  "arrowright": "pan-right",
  "arrowup": "pan-up",
  "arrowdown": "pan-down",
  ...Object.fromEntries([0, 1, 2, 3, 4, 5, 6, 7, 8, 9].map((n) => [String(n), `swatch-${n}`])),
};

/**
 * @param {(action: string) => void} act
 * @param {(held: boolean) => void} holdSpace
 */
export function listen(act, holdSpace) {
  window.addEventListener("keydown", (event) => {
    if (event.defaultPrevented || document.querySelector("dialog[open]")) return;
    if (event.key === " " && isCanvas(event.target)) {
      event.preventDefault();
      holdSpace(true);
      return;
    }
    const action = CHORDS[chord(event)];
    if (!action || (usesKey(event.target, event.key) && !event.ctrlKey && !event.metaKey)) return;
    // Escape also closes what has come down from a button.
    if (event.key !== "Escape") event.preventDefault();
    act(action);
  });
  window.addEventListener("keyup", (event) => {
    if (event.key === " ") holdSpace(false);
  });
}

/** @param {KeyboardEvent} event */
function chord(event) {
  const digit = /^Digit(\d)$/.exec(event.code)?.[1];
  const key = event.shiftKey && digit ? digit : event.key.toLowerCase();
  return `${event.ctrlKey || event.metaKey ? "ctrl+" : ""}${event.shiftKey ? "shift+" : ""}${key}`;
}

/**
 * Where Space is the hand: on the canvas, or with nothing focused.
 * @param {EventTarget | null} target
 */
function isCanvas(target) {
  return target instanceof HTMLCanvasElement || target === document.body;
}

/**
 * Sliders and lists use plain keys themselves, radio buttons the arrows, check boxes none that means something here.
 * @param {EventTarget | null} target
 * @param {string} key
 */
function usesKey(target, key) {
  if (!(target instanceof HTMLInputElement)) return target instanceof HTMLSelectElement;
  if (target.type === "range") return /^(Arrow|Home$|End$|Page)/.test(key);
  return target.type === "radio" ? key.startsWith("Arrow") : target.type !== "checkbox";
}
