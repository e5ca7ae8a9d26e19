/** Pictures as rows of pixels, and what the tests ask of them. */
import assert from "node:assert/strict";
import { PNG } from "pngjs";

/** @typedef {[number, number, number]} Rgb */

/** @type {Rgb} */
export const PAPER = [255, 255, 255];

/** A change between neighbours that is an edge: shading changes less from one pixel to the next. */
const EDGE_LEVELS = 12;

/** Two renderers may differ by this much where there is no edge. */
const SAME_LEVELS = 2;

export class Picture {
  /**
   * @param {number} width
   * @param {number} height
   * @param {Uint8Array} rgba
   */
  constructor(width, height, rgba) {
    this.width = width;
    this.height = height;
    this.rgba = rgba;
  }

  /** @param {Buffer} png */
  static decode(png) {
    const { width, height, data } = PNG.sync.read(png);
    return new Picture(width, height, data);
  }

  /**
   * The colour of the pixel that holds a point.
   * @param {number} x
   * @param {number} y
   * @returns {Rgb}
   */
  at(x, y) {
    const i = 4 * (Math.floor(y) * this.width + Math.floor(x));
    return [this.rgba[i], this.rgba[i + 1], this.rgba[i + 2]];
  }

  /**
   * The colours of the pixels in a rectangle given by two corners, both in it, without repetition.
   * @param {[number, number]} from
   * @param {[number, number]} to
   */
  colors([x0, y0], [x1, y1]) {
    const colors = new Set();
    for (let y = Math.floor(y0); y <= y1; y++) {
      for (let x = Math.floor(x0); x <= x1; x++) colors.add(hex(this.at(x, y)));
    }
    return [...colors];
  }

  /** @param {Picture} other */
  equals(other) {
    return this.width === other.width && this.height === other.height && Buffer.compare(this.rgba, other.rgba) === 0;
  }

  /**
   * The part of a size whose upper left corner is here.
   * @param {number} left
   * @param {number} top
   * @param {{width: number, height: number}} size
   */
  part(left, top, { width, height }) {
    const rows = Array.from({ length: height }, (_, y) => {
      const start = 4 * ((top + y) * this.width + left);
      return this.rgba.subarray(start, start + 4 * width);
    });
    return new Picture(width, height, Buffer.concat(rows));
  }

  /** Half as large: each pixel the mean of four. Odd rows and columns at the end are left out. */
  half() {
    const [width, height] = [this.width >> 1, this.height >> 1];
    const rgba = new Uint8Array(4 * width * height);
    for (let i = 0; i < rgba.length; i++) {
      const [x, y] = [(i >> 2) % width, Math.floor((i >> 2) / width)];
      const above = 8 * (y * this.width + x) + (i & 3);
      const below = above + 4 * this.width;
      rgba[i] = (this.rgba[above] + this.rgba[above + 4] + this.rgba[below] + this.rgba[below + 4] + 2) >> 2;
    }
    return new Picture(width, height, rgba);
  }

  /** As PNG. */
  encode() {
    const png = new PNG({ width: this.width, height: this.height });
    png.data = Buffer.from(this.rgba);
    // Screenshots are opaque.
    return PNG.sync.write(png, { colorType: 2 });
  }

  /**
   * Whether there is an edge at this pixel or beside it.
   * @param {number} x
   * @param {number} y
   */
  isEdge(x, y) {
    return this.steepness(x, y) > EDGE_LEVELS;
  }

  /**
   * The largest difference from a pixel to those around it, in levels.
   * @param {number} x
   * @param {number} y
   */
  steepness(x, y) {
    const here = this.at(x, y);
    let steepest = 0;
    for (let j = Math.max(y - 1, 0); j <= Math.min(y + 1, this.height - 1); j++) {
      for (let i = Math.max(x - 1, 0); i <= Math.min(x + 1, this.width - 1); i++) {
        steepest = Math.max(steepest, distance(here, this.at(i, j)));
      }
    }
    return steepest;
  }
}

/**
 * Asserts that two pictures differ by at most two levels in each pixel that is on an edge of neither, as most are; or
 * by what the picture changes over half a pixel: renderers take a pixel's colour within it, on either side of a
 * bend.
 * @param {Picture} actual
 * @param {Picture} expected
 */
export function assertSame(actual, expected) {
  assert.deepEqual([actual.width, actual.height], [expected.width, expected.height]);
  let compared = 0;
  for (let y = 0; y < expected.height; y++) {
    for (let x = 0; x < expected.width; x++) {
      if (expected.isEdge(x, y) || actual.isEdge(x, y)) continue;
      compared += 1;
      const levels = distance(actual.at(x, y), expected.at(x, y));
      const allowed = Math.max(SAME_LEVELS, 0.5 * expected.steepness(x, y));
      assert.ok(levels <= allowed, `${levels} levels at ${x}, ${y}: ${actual.at(x, y)}, not ${expected.at(x, y)}`);
    }
  }
  assert.ok(compared > 0.8 * expected.width * expected.height, `only ${compared} pixels are on no edge`);
}

/**
 * The largest difference of a channel, in levels of 255.
 * @param {Rgb} a
 * @param {Rgb} b
 */
export function distance(a, b) {
  return Math.max(...a.map((value, i) => Math.abs(value - b[i])));
}

/** @param {Rgb} color */
export function hex(color) {
  return `#${color.map((value) => value.toString(16).padStart(2, "0")).join("")}`;
}
