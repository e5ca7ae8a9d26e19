// The swatches beside the canvas: the palette of the drawing, tones, and the colours that were scribbled with last.

import { make } from "./elements.js";
import { name, say } from "./messages.js";
import { remember, remembered } from "./remember.js";

/** @typedef {{color: string, name: string}} Swatch a colour as #rrggbb, and what somebody has called it, if so */

/** The palette of drawings that have none, by keys of the message table. */
const USUAL = Object.entries({
  red: "#e5484d",
  orange: "#f5803e",
  yellow: "#f7c948",
  green: "#46a758",
  teal: "#12a594",
  blue: "#3b82f6",
  violet: "#8e4ec6",
  pink: "#e93d82",
  brown: "#8d5a3b",
  peach: "#f3c9a5",
  slate: "#60646c",
  white: "#ffffff",
});

/** Swatches of steps from the colour that is there, by what the module calls them. */
const TONES = /** @type {Record<string, string>} */ ({
  lighter: "linear-gradient(135deg, #8b8d98 25%, #fff 75%)",
  darker: "linear-gradient(135deg, #8b8d98 25%, #000 75%)",
  warmer: "linear-gradient(135deg, #8b8d98 25%, #ff8b3e 75%)",
  cooler: "linear-gradient(135deg, #8b8d98 25%, #4a9df8 75%)",
});

/** What is picked for "no colour", in the page and in the module. */
export const NO_COLOR = "none";

/** A palette is shown as far as this: as many colours as the file of one may have. */
export const MOST_SWATCHES = 1_000;

const MOST_RECENT = 8;

/** Where the browser keeps the colours that were scribbled with last. */
const RECENT = "scumble-recent-colors";

/** Keys in the message table by colour. */
const NAMES = new Map([...USUAL, ["no-colour", NO_COLOR]].map(([key, color]) => [color, key]));

/** The palette that is shown: the drawing's own, or the usual one. @type {Swatch[]} */
let palette = usual();

/** The last first. @type {string[]} */
let recent = remembered(RECENT)?.match(/#[\da-f]{6}\b/g)?.slice(0, MOST_RECENT) ?? [];

/** What the module says is scribbled with: #rrggbb, none, or a tone. */
let current = "";

const part = (/** @type {string} */ id) => /** @type {HTMLElement} */ (document.getElementById(id));

/** @param {(color: string | undefined) => void} pick called with nothing where a press is beside the swatches */
export function connectSwatches(pick) {
  labelSwatches();
  for (const list of lists()) {
    list.addEventListener("click", ({ target }) => pick(/** @type {HTMLElement} */ (target).dataset.color));
  }
}

/** Calls all swatches what they are called in the language of the page. */
export function labelSwatches() {
  fill("tones", Object.keys(TONES).map((tone) => ({ color: tone, label: say(tone) })));
  fillPalette();
  fillRecent();
}

function lists() {
  return ["tones", "palette", "recent-colors"].map(part);
}

/** The palette that is shown. */
export function swatches() {
  return palette;
}

/** What is scribbled with: #rrggbb, none, or a tone. */
export function currentColor() {
  return current;
}

/**
 * The colour of a swatch, counted from 1; 0 is that of none. Nothing where the palette has fewer.
 * @param {number} n
 */
export function swatch(n) {
  return n === 0 ? NO_COLOR : palette[n - 1]?.color;
}

/** What people call a swatch. @param {Swatch} swatch */
export function nameOf({ color, name }) {
  return name || say(NAMES.get(color) ?? color);
}

/** What people call a colour, #rrggbb or none: as the palette does, if it has it. @param {string} color */
export function nameOfColor(color) {
  return nameOf(palette.find((swatch) => swatch.color === color) ?? { color, name: "" });
}

/** Notes that the colour of the moment was scribbled with. */
export function used() {
  if (!current.startsWith("#") || recent[0] === current) return;
  recent = [current, ...recent.filter((color) => color !== current)].slice(0, MOST_RECENT);
  remember(RECENT, recent.join(" "));
  fillRecent();
}

/** What effects do to the swatches. */
export const shownSwatches = {
  /** @param {string[]} own of the drawing: colours and names in turn; without any the usual one is shown */
  palette(own) {
    const ours = own.flatMap((color, i) => (i % 2 === 0 && color !== NO_COLOR ? [{ color, name: own[i + 1] }] : []));
    palette = ours.length === 0 ? usual() : ours;
    fillPalette();
  },
  /** @param {string} color #rrggbb, none, or a tone */
  color(color) {
    current = color;
    paint(part("color"), color);
    part("color").dataset.color = color;
    press();
  },
};

function usual() {
  return USUAL.map(([, color]) => ({ color, name: "" }));
}

function fillPalette() {
  const shown = palette.slice(0, MOST_SWATCHES);
  const items = shown.map((swatch, i) => ({ color: swatch.color, label: nameOf(swatch), shortcut: `swatch-${i + 1}` }));
  fill("palette", [...items, { color: NO_COLOR, label: say("no-colour"), shortcut: "swatch-0" }]);
}

function fillRecent() {
  part("recent-colors").hidden = recent.length === 0;
  fill("recent-colors", recent.map((color) => ({ color, label: say("recent-colour", { color: nameOfColor(color) }) })));
}

/**
 * @param {string} id of the list
 * @param {{color: string, label: string, shortcut?: string}[]} swatches
 */
function fill(id, swatches) {
  part(id).replaceChildren(
    ...swatches.map(({ color, label, shortcut }) => {
      const swatch = make("button", { type: "button", className: "swatch", "data-color": color });
      paint(swatch, color);
      if (shortcut) swatch.dataset.shortcut = shortcut;
      name(swatch, label);
      return make("li", {}, swatch);
    }),
  );
  press();
}

/**
 * @param {HTMLElement} swatch
 * @param {string} color
 */
function paint(swatch, color) {
  swatch.style.setProperty("--swatch", TONES[color] ?? color);
  swatch.classList.toggle("none", color === NO_COLOR);
}

/** Marks the swatches of the colour of the moment. */
function press() {
  for (const swatch of lists().flatMap((list) => [...list.querySelectorAll("button")])) {
    swatch.setAttribute("aria-pressed", String(swatch.dataset.color === current));
  }
}
