// The mouse cursor over the canvas: a ring as wide as the brush, in its colour, or as wide as the eraser; a dropper; a hand.

/** Rings outside this range are drawn as cross hairs: too small to see, or larger than browsers allow. */
const RING_PX = { least: 6, most: 120 };

/** How far the eraser reaches across, as in `gestures.rs`. */
const ERASER_PX = 10;
/** The ring of a brush without a colour of its own. */
const COLORLESS = "#80808080";

const DROPPER = document.querySelector("#i-pick path")?.getAttribute("d");

let tool = "scribble";
let color = "#000000";
let size_du = 0;
let zoom = 1;

/** The values come one by one, as effects. */
export const followed = {
  /** @param {string} value */
  tool: (value) => show(() => (tool = value)),
  /** @param {string} value */
  color: (value) => show(() => (color = value)),
  /** @param {number} value */
  "brush-size": (value) => show(() => (size_du = value)),
  /** @param {number} value */
  zoom: (value) => show(() => (zoom = value)),
};

/** What each tool has. @type {Record<string, () => string>} */
const CURSORS = {
  scribble: brush,
  select: () => "default",
  erase: () => ring(ERASER_PX, "black"),
  pick: dropper,
  hand: () => "grab",
};

/** @param {() => void} change */
function show(change) {
  change();
  const { style, dataset } = document.documentElement;
  dataset.tool = tool;
  style.setProperty("--brush", CURSORS[tool]());
  style.setProperty("--dropper", dropper());
}

function brush() {
  const width_px = size_du * zoom;
  const drawn = width_px >= RING_PX.least && width_px <= RING_PX.most;
  return drawn ? ring(width_px, color.startsWith("#") ? color : COLORLESS) : "crosshair";
}

/** The tool's own picture, whose tip is where it picks. */
function dropper() {
  const line = (/** @type {string} */ stroke, /** @type {number} */ width) =>
    `<path d="${DROPPER}" fill="white" stroke="${stroke}" stroke-width="${width}" stroke-linejoin="round"/>`;
  return image(20, line("white", 4) + line("black", 1.5), 2, 18);
}

/**
 * @param {number} width_px
 * @param {string} color
 */
function ring(width_px, color) {
  const size = Math.ceil(width_px) + 4;
  const circle = (/** @type {number} */ r, /** @type {string} */ stroke) =>
    `<circle cx="${size / 2}" cy="${size / 2}" r="${r}" fill="none" stroke="${stroke}" stroke-width="1.5"/>`;
  const middle = Math.round(size / 2);
  return image(size, circle(width_px / 2 + 1, "white") + circle(width_px / 2, color), middle, middle);
}

/**
 * @param {number} size_px of its sides
 * @param {string} shapes in SVG
 * @param {number} x of the place that it points to
 * @param {number} y
 */
function image(size_px, shapes, x, y) {
  const svg = `<svg xmlns="http://www.w3.org/2000/svg" width="${size_px}" height="${size_px}">${shapes}</svg>`;
  return `url("data:image/svg+xml,${encodeURIComponent(svg)}") ${x} ${y}, crosshair`;
}
