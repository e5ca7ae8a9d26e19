// The keyboard: the table of all shortcuts, which binds them, names them in tooltips and is what Help lists.

import { remember, remembered } from "./remember.js";

/**
 * Actions with their chords, by groups; both are keys of the message table. A letter in a chord is a key, whatever its
 * case; an action that ends in a hyphen stands for one action with each of its keys.
 * @type {Record<string, Record<string, string[]>>}
 */
export const SHORTCUTS = {
  tools: {
    "tool-scribble": ["B"],
    "tool-erase": ["E"],
    "other-erasing": ["Shift+E"],
    "tool-select": ["V"],
    "tool-pick": ["I"],
    // Pointers look at it themselves.
    "hold-pick": ["Alt"],
    "tool-hand": ["H"],
    "hold-hand": ["Space"],
    pen: ["Enter"],
    "other-kind": ["S"],
    "brush-smaller": ["["],
    "brush-larger": ["]"],
    drop: ["Escape"],
  },
  selection: {
    "select-next": ["N"],
    "select-previous": ["Shift+N"],
    "select-all": ["Ctrl+A"],
    "delete-selected": ["Delete", "Backspace"],
    duplicate: ["Ctrl+D"],
    forward: ["Ctrl+]"],
    backward: ["Ctrl+["],
  },
  colour: {
    "swatch-": ["1", "2", "3", "4", "5", "6", "7", "8", "9"],
    "swatch-0": ["0"],
    "swap-colors": ["X"],
  },
  "group-history": { undo: ["Ctrl+Z"], redo: ["Ctrl+Shift+Z", "Ctrl+Y"], history: ["Shift+H"] },
  "group-file": { open: ["Ctrl+O"], save: ["Ctrl+S"], export: ["Ctrl+Shift+E"], help: ["?"] },
  "group-view": {
    "arrow-": ["ArrowLeft", "ArrowRight", "ArrowUp", "ArrowDown"],
    "far-": ["Shift+ArrowLeft", "Shift+ArrowRight", "Shift+ArrowUp", "Shift+ArrowDown"],
    "zoom-in": ["Ctrl+=", "Ctrl++"],
    "zoom-out": ["Ctrl+-"],
    "zoom-reset": ["Ctrl+0"],
    fit: ["Shift+1"],
    // Krita's, with Shift: the digits pick swatches.
    "rotate-left": ["Shift+4"],
    "rotate-right": ["Shift+6"],
    "rotate-reset": ["Shift+5"],
    "hold-rotate": ["R"],
    mirror: ["M"],
    "show-lines": ["Shift+L"],
    "show-scribbles": ["Shift+B"],
    "show-result": ["Shift+R"],
    "show-regions": ["Shift+G"],
    "hold-before": ["C"],
    "full-screen": ["F"],
  },
};

/** Actions by chords. */
const ACTIONS = new Map(
  Object.values(SHORTCUTS).flatMap((group) =>
    Object.entries(group).flatMap(([action, chords]) =>
      chords.map((chord) => /** @type {const} */ ([chord, action.endsWith("-") ? action + chord : action])),
    ),
  ),
);

/** Arrow keys that are pressed within so long after one another are one gesture, as one that is held is. */
const RUN_MS = 1_000;

/** A key that is no letter, no digit, and has no name. */
const SIGN = /^[^a-z\d]$/i;

const isMac = /Mac|iP/.test(navigator.platform);

/** How keys are called in the language of the page, where that is not as in the table. @type {[string, string][]} */
let names = [];

/** What a chord is on the keys of other machines, and keys that have signs. @type {[string, string][]} */
const SIGNS = [
  ["ArrowLeft", "←"],
  ["ArrowRight", "→"],
  ["ArrowUp", "↑"],
  ["ArrowDown", "↓"],
  ...(isMac ? /** @type {[string, string][]} */ ([["Ctrl+", "⌘"], ["Shift+", "⇧"], ["Alt", "⌥"]]) : []),
];

/** Where the browser keeps that shortcuts of a single key are off, for those who dictate or rest on the keyboard. */
const SINGLES = "scumble-single-keys";

let singles = remembered(SINGLES) !== "off";

/** Whether shortcuts of a single character are on. */
export function haveSingles() {
  return singles;
}

/** @param {boolean} on */
export function setSingles(on) {
  singles = on;
  remember(SINGLES, on ? "on" : "off");
}

/** @param {string} chord */
function isOn(chord) {
  return singles || !/^(Shift\+)?.$/.test(chord);
}

/** How a chord is written on this machine's keys. @param {string} chord */
export function written(chord) {
  return [...SIGNS, ...names].reduce((text, [key, sign]) => text.replace(key, sign), chord);
}

/** @param {[string, string][]} called keys of the table and what they are called; a Mac's have signs in all languages */
export function nameKeys(called) {
  names = called;
}

/** The chord of an action, as it is written; nothing where there is none that is on. @param {string} action */
export function keysOf(action) {
  const found = [...ACTIONS].find(([chord, of]) => of === action && isOn(chord));
  return found && written(found[0]);
}

/**
 * @param {(action: string) => void} act
 * @param {(action: string, held: boolean) => void} hold
 */
export function listen(act, hold) {
  /** Actions of the keys that are held. @type {Map<string, string>} */
  const held = new Map();
  const release = (/** @type {string} */ key) => {
    const action = held.get(key);
    held.delete(key);
    if (action) hold(action, false);
  };
  followRuns(() => act("settle"));
  window.addEventListener("keydown", (event) => {
    if (event.defaultPrevented || (event.altKey && !makesSign(event)) || document.querySelector("dialog[open]")) return;
    const chord = chordOf(event);
    const action = isOn(chord) && ACTIONS.get(chord);
    const isCommand = chord.startsWith("Ctrl+") && chord !== "Ctrl+A";
    if (!action || (usesKey(event.target, event.key) && !isCommand)) return;
    // Escape also closes what has come down from a button.
    if (event.key !== "Escape") event.preventDefault();
    // A long press of Enter is one.
    if (event.repeat && action === "pen") return;
    if (!action.startsWith("hold-")) act(action);
    else if (!event.repeat) {
      held.set(event.key.toLowerCase(), action);
      hold(action, true);
    }
  });
  window.addEventListener("keyup", (event) => release(event.key.toLowerCase()));
  window.addEventListener("blur", () => {
    // Keys that are let go elsewhere are not heard of.
    [...held.keys()].forEach(release);
    act("settle");
  });
}

/**
 * Ends the gesture of arrow keys where none is pressed for a while, or something else is done.
 * @param {() => void} settle
 */
function followRuns(settle) {
  let run = 0;
  const end = () => {
    // Without a run, what is in hand is a slider's.
    if (run) settle();
    clearTimeout(run);
    run = 0;
  };
  window.addEventListener("pointerdown", end, true);
  // Those who speak their commands click without a pointer.
  window.addEventListener("click", end, true);
  const follow = (/** @type {KeyboardEvent} */ { key }) => {
    if (key.startsWith("Arrow")) clearTimeout(run);
    // Shift is for arrows that go farther.
    else if (key !== "Shift") end();
  };
  window.addEventListener("keydown", follow, true);
  window.addEventListener("keyup", ({ key }) => {
    if (!key.startsWith("Arrow")) return;
    clearTimeout(run);
    run = window.setTimeout(end, RUN_MS);
  });
}

/** Whether a key with Alt is a sign: by AltGr, which Windows reports as Ctrl and Alt, or by a Mac's Option. @param {KeyboardEvent} event */
function makesSign(event) {
  return SIGN.test(event.key) && (isMac || event.getModifierState("AltGraph"));
}

/** @param {KeyboardEvent} event of a key with Alt only where that makes a sign */
function chordOf(event) {
  const digit = /^Digit(\d)$/.exec(event.code)?.[1];
  const key = event.key === " " ? "Space" : event.shiftKey && digit ? digit : event.key;
  const isCommand = event.metaKey || (event.ctrlKey && !event.altKey);
  // Shift is part of what makes a sign.
  const modifiers = `${isCommand ? "Ctrl+" : ""}${event.shiftKey && !SIGN.test(key) ? "Shift+" : ""}`;
  return modifiers + (key.length === 1 ? key.toUpperCase() : key);
}

/**
 * Space is the hand on the canvas, or with nothing focused, and Enter the pen. Sliders and lists use plain keys themselves, radio buttons the
 * arrows, check boxes none that means something here.
 * @param {EventTarget | null} target
 * @param {string} key
 */
function usesKey(target, key) {
  if (key === " " || key === "Enter") return !(target instanceof HTMLCanvasElement || target === document.body);
  if (!(target instanceof HTMLInputElement)) return target instanceof HTMLSelectElement;
  if (target.type === "range") return /^(Arrow|Home$|End$|Page)/.test(key);
  return target.type === "radio" ? key.startsWith("Arrow") : target.type !== "checkbox";
}
