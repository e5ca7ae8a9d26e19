// Every word that the page shows: a table from keys to texts. A text that needs values is a function of them. English is
// here, but for what the parts say that are fetched later; what is spoken in its place is fetched, too.

import { keysOf, nameKeys } from "./keys.js";

/** @typedef {Record<string, string | ((values: any) => string)>} Table */

/** @type {Table} */
export const english = {
  "app": "Scumble",
  "group-file": "File",
  "group-history": "History",
  "group-show": "Show",
  "group-zoom": "Zoom",
  "group-view": "View",
  "group-rotation": "Rotation and mirror",
  "open": "Open",
  "save": "Save",
  "recent": "Recent drawings",
  "recent-short": "Recent",
  "samples": "Samples",
  "export": "Export",
  "lines": "Lines",
  "cancel": "Cancel",
  "share": "Share",
  "as-file": "Save as a file",
  "shared-drawing": "Shared drawing",
  "opened-beside": ({ before }) => `Opened the link; Undo goes back to ${before}`,
  "undo": "Undo",
  "redo": "Redo",
  "history": "History",
  "show-lines": "Show lines",
  "show-scribbles": "Show scribbles",
  "tracing": "Tracing image",
  "show-tracing": "Show tracing image",
  "tracing-opacity": "Opacity",
  "remove-tracing": "Remove tracing image",
  "show-result": "Show result",
  "scribbles": "Scribbles",
  "result": "Result",
  "settings": "Settings",
  "language": "Language",
  "language-auto": "As the browser",
  "engine": "Engine",
  "engine-note": "Global reads all scribbles at once, Progressive one after the other",
  "engine-global": "Global",
  "engine-progressive": "Progressive",
  "solver": "Solver",
  "solver-note": "What draws the picture on this screen; files are the same with each",
  "solver-automatic": "Automatic",
  "solver-mesh": "Mesh",
  "solver-gpu": "GPU",
  "source-without-gpu": "What paints here has no GPU solver; the mesh solver draws",
  "gap-closing": "Gap closing",
  "gap-less": "Less: colours flow on",
  "gap-more": "more: stop sooner",
  "show-regions": "Show regions and gaps",
  "regions-note": "Each region in a tint, and a mark in each gap that stops colours; faint where they may go on",
  "spread": "Spread",
  "spread-note": "Colours also what nobody scribbled",
  "percent": ({ percent }) => `${percent}%`,
  "blend": "Blend",
  "blend-note": "The space in which colours mix",
  "blend-oklab": "OKLab",
  "blend-srgb": "sRGB",
  "zoom-in": "Zoom in",
  "zoom-out": "Zoom out",
  "zoom": ({ percent }) => `Zoom ${percent}%`,
  "fit": "Fit",
  "rotate-left": "Rotate left",
  "rotate-right": "Rotate right",
  "degrees": ({ degrees }) => `${degrees}°`,
  "rotated": ({ degrees }) => `Rotation ${degrees}°`,
  "mirror": "Mirror",
  "bar": "File, view and help",
  "full-screen": "Full screen",
  "full-screen-on": "Full screen; Escape ends it",
  "full-screen-off": "No longer full screen",
  "full-screen-not": "The browser does not give the page the whole screen",
  "tools": "Tools",
  "tool-scribble": "Scribble",
  "tool-erase": "Erase",
  "erasing": "What the eraser takes",
  "erasing-whole": "Whole scribbles",
  "erasing-whole-short": "Whole",
  "erasing-parts": "Parts",
  "tool-select": "Select",
  "selection": "Selection",
  "select-more": "Select more",
  "select-none": "Deselect",
  "delete-selected": "Delete",
  "duplicate": "Duplicate",
  "forward": "Bring forward",
  "backward": "Send backward",
  "hide": "Hide",
  "unhide": "Show again",
  "things": things,
  "tool-pick": "Pick colour",
  "tool-hand": "Hand",
  "kind": "What a scribble does",
  "kind-fill": "Fill",
  "kind-shade": "Shade",
  "shading": "Shading",
  "strength": "Strength",
  "pressure": "Pen pressure",
  "pressure-radius": "Radius",
  "pressure-off": "Off",
  "crosses": "Cross lines",
  "tones": "Tones",
  "lighter": "Lighter",
  "darker": "Darker",
  "warmer": "Warmer",
  "cooler": "Cooler",
  "colour": "Colour",
  "palette": "Palette",
  "edit-palette": "Edit palette",
  "recent-colours": "Recent",
  "shade": ({ color }) => `Shade ${color}`,
  "recent-colour": ({ color }) => `Recent: ${color}`,
  "brush-size": "Brush size",
  "canvas": "Canvas",
  "canvas-instructions":
    "Draw with the pointer to scribble a colour, to shade, or to erase scribbles. Enter shows cross hairs for the keyboard, which the arrow keys move, and puts the pen down there and lifts it. N selects one scribble after the other. The arrow keys move what is selected, or the picture; Escape drops the stroke, or deselects.",
  "guide": ({ help }) => `Wheel or Space-drag moves, Ctrl+wheel zooms${help ? `, ${help} shows all shortcuts` : ""}`,
  "help": "Help",
  "first-steps": "First steps",
  "step": ({ place, text }) => `Step ${place} of 3: ${text}`,
  "step-1": "Pick a colour",
  "step-2": "Scribble inside a shape",
  "step-3": "Add another colour, or Undo it",
  "steps-done": "That is how to colour. Open takes drawings of your own",
  "skip": "Skip",
  "fingers": "Fingers draw",
  "fingers-draw": "Fingers draw too",
  "pen-draws": "Only the pen draws now, fingers move the picture; the button with a finger changes that",
  "before": "The drawing before it was coloured",
  "pen": "Draw with the keyboard: cross hairs",
  "drop": "Drop the stroke, or deselect",
  "swatch-0": "No colour",
  "dismiss": "Dismiss",
  "update-ready": "A new version is ready",
  "reload": "Reload",
  "later-update": "Not now",

  "red": "Red",
  "orange": "Orange",
  "yellow": "Yellow",
  "green": "Green",
  "teal": "Teal",
  "blue": "Blue",
  "violet": "Violet",
  "pink": "Pink",
  "brown": "Brown",
  "peach": "Peach",
  "slate": "Slate",
  "white": "White",
  "no-colour": "No colour",

  "sample-Goldfish": "Goldfish",

  "untitled": "Untitled",
  "title": ({ name, unsaved }) => `${unsaved ? "• " : ""}${name} – Scumble`,
  "unsaved": "not saved to a file",
  "copy": ({ name }) => `Copy of ${name}`,
  "opened-copy": ({ name }) => `Opened ${name}: another tab has the drawing itself`,
  "copied-beside": ({ name, before }) => `Another tab has ${before}; this one goes on as ${name}`,
  "unkept-all": "The browser cannot keep your drawings. Save them as files, or they are gone when the page is closed.",
  "unkept-image":
    "The browser cannot keep the tracing image, only the rest of the drawing. Save it as a file, or delete others under Recent.",
  "start": "Pick a colour and scribble it into the drawing",
  "opening": ({ name }) => `Opening ${name || "the drawing"} …`,
  "progress": "Progress",
  "opening-stopped": "Opening cancelled; everything is as it was",
  "making": "Making the picture …",
  "making-stopped": "Cancelled; the drawing is as it was before. Redo does it again",
  "opened": ({ name }) => `Opened ${name}`,
  "unopened": ({ name }) => `${name} has been closed again`,
  "no-drawing": "That text is no drawing (SVG) and no link; copy all of either, and paste again",
  "text": "the text",
  "opened-first": ({ name }) => `Opened ${name} alone; open the other files one by one`,
  "opened-in-part": ({ name, notes }) => `Opened ${name}; ${notes}`,
  "palette-taken": ({ name, notes }) => `The palette has the colours of ${name}${notes && "; "}${notes}`,
  "traced": ({ name }) => `${name} lies under the lines; exported pictures are without it`,
  "tracing-removed": "Tracing image removed",
  "saved": ({ name }) => `Saved ${name}`,
  "scribble-added": ({ count, isFill }) => `${isFill ? "Scribble" : "Shade"} added, ${count} in the drawing`,
  "scribbles-erased": ({ erased, count }) =>
    erased === 0 ? "No scribble there to erase" : `${erased === 1 ? "Scribble" : `${erased} scribbles`} erased, ${count} in the drawing`,
  "scribbles-rubbed": ({ count }) => `Part of a scribble erased, ${count} in the drawing`,
  "eraser-turned": ({ parts }) => `The eraser takes ${parts ? "parts of scribbles" : "whole scribbles"}`,
  "selected": ({ scribbles, lines, place, total }) =>
    scribbles === 1 ? `Scribble ${place} of ${total} selected` : `${things({ scribbles, lines })} selected`,
  "edited": ({ edit, ...values }) => EDITED[edit](things(values)),
  "picked": ({ color }) => `Picked ${color === "none" ? "no colour" : color}`,
  "scribble-dropped": "Scribble dropped",
  "turned": ({ degrees, mirrored }) => {
    if (degrees === 0) return mirrored ? "Mirrored" : "As drawn";
    return `Rotated by ${Math.round(degrees)}°${mirrored ? ", mirrored" : ""}`;
  },
  "undone": "Undone",
  "redone": "Redone",
  "recovered": "The graphics device was lost; the picture has been drawn again",
  "recovered-webgl": "The graphics device was lost; the page draws with WebGL 2 now",
  "recovered-cpu": "The graphics device was lost; the page draws without it",

  "failed": ({ sentence }) => `${sentence.charAt(0).toUpperCase()}${sentence.slice(1)}.`,
  "error-image":
    "the picture is damaged, or coded as this browser does not know it; save it again as PNG or JPEG",
  "error-read": "the file could not be read; try opening it again",
  "error-write": "the file could not be written; save again to choose another place",
  "error-formats": "what opens and saves files could not be loaded; check the connection and try again",
  "error-too-hard": "the file takes more than there is room for here; simplify the drawing",
  "error-kept":
    "a drawing that the browser kept is damaged or from a newer Scumble; it stays among the recent drawings",
  "error-gone": "the drawing is no longer there",
  "error-storage": "the browser does not give out the drawings that it keeps; check whether the page may store data",
  "error-panel": "this part of the page could not be loaded; check the connection and load the page again",
  "error-language": "the language could not be loaded; check the connection and try again",
  "error-samples": "the samples could not be loaded; check the connection and load the page again",
  "error-start": "Scumble could not start in this browser; a current Chrome, Edge, Firefox or Safari will do.",
  "error-stopped": "Scumble has run into a fault and stopped. Load the page again to go on.",
  "error-renderer": "The graphics device was lost and could not be had again. Load the page again to go on.",
};

/** What became of what was selected. @type {Record<string, (things: string) => string>} */
const EDITED = {
  resized: (things) => `${things} resized`,
  moved: (things) => `${things} moved`,
  widened: (things) => `${things} with another brush size`,
  reshaded: (things) => `${things} shaded otherwise`,
  recoloured: (things) => `${things} recoloured`,
  duplicated: (things) => `${things} duplicated`,
  forward: (things) => `${things} brought forward`,
  backward: (things) => `${things} sent backward`,
  foremost: () => "Nothing lies in front",
  hindmost: () => "Nothing lies behind",
  deleted: (things) => `${things} deleted`,
  hidden: (things) => `${things} hidden; colours part there as before`,
  shown: (things) => `${things} shown again`,
};

/** @param {{scribbles?: number, lines?: number}} counts */
function things({ scribbles = 0, lines = 0 }) {
  const of = (/** @type {number} */ count, /** @type {string} */ noun) => `${count} ${noun}${count === 1 ? "" : "s"}`;
  if (scribbles > 0) return of(scribbles, "scribble");
  return lines > 0 ? of(lines, "line") : "Nothing";
}

/** The table that is spoken. @type {Table} */
let table = english;

/** The language that was asked for last. */
let wanted = "en";

/**
 * Has the page say everything in a language from now on.
 * @param {string} language en or de
 */
export async function speak(language) {
  wanted = language;
  const spoken = language === "de" ? await import("./german.js") : { german: english, keys: [] };
  if (language !== wanted) return;
  table = spoken.german;
  nameKeys(spoken.keys);
  document.documentElement.lang = language;
}

/** Has the words of what is fetched later, too. */
export async function haveWords() {
  Object.assign(english, (await import("./later_messages.js")).later);
}

/**
 * The text of a key. An unknown key is shown as it is, so that a gap in the table is seen.
 * @param {string} key
 * @param {Record<string, unknown>} [values]
 */
export function say(key, values = {}) {
  const text = table[key] ?? key;
  return typeof text === "function" ? text(values) : text;
}

/**
 * Puts the words into the page: `data-text` becomes an element's text, `data-label` its accessible name.
 * @param {ParentNode} root
 */
export function label(root) {
  for (const element of /** @type {NodeListOf<HTMLElement>} */ (root.querySelectorAll("[data-text]"))) {
    element.textContent = say(element.dataset.text ?? "", { help: keysOf("help") });
  }
  for (const element of /** @type {NodeListOf<HTMLElement>} */ (root.querySelectorAll("[data-label]"))) {
    name(element, say(element.dataset.label ?? ""));
  }
}

/**
 * Gives an element its accessible name, and a tooltip if it is a button or an input, with the shortcut of its
 * `data-shortcut`, or of what it does.
 * @param {HTMLElement} element
 * @param {string} text
 */
export function name(element, text) {
  element.setAttribute("aria-label", text);
  const { shortcut, action, label } = element.dataset;
  const keys = keysOf(shortcut ?? action ?? label ?? "");
  if (element instanceof HTMLButtonElement || element instanceof HTMLInputElement) {
    element.title = keys ? `${text} (${keys})` : text;
  }
}
