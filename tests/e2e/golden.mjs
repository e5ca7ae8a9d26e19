/**
 * Golden pictures of the page, in `golden/`, and how a page is like them.
 *
 * All machines see the same: Chromium draws with its adapter in software, all words are in one font, and nothing moves.
 */
import assert from "node:assert/strict";
import { mkdir, readFile, writeFile } from "node:fs/promises";
import { fileURLToPath } from "node:url";
import pixelmatch from "pixelmatch";
import { PAINTED } from "./browsers.mjs";
import { Picture } from "./picture.mjs";

const path = (/** @type {string} */ file) => fileURLToPath(new URL(file, import.meta.url));

/** Where the pictures go that are not as they were. */
const REFUSED = path("../../target/golden/");

/** From which on two colours differ, from 0 to 1: by some five levels. */
const THRESHOLD = 0.03;

/** How many pixels may differ beside those that pixelmatch takes for the smoothing of an edge. The faintest icon has six. */
const ALLOWED = 4;

const FONT = await readFile(path("../../node_modules/@fontsource-variable/inter/files/inter-latin-wght-normal.woff2"), "base64");

/** What makes a page the same everywhere: to be run before its own scripts. */
export const ALIKE = `
  document.fonts.add(new FontFace("Golden", "url(data:font/woff2;base64,${FONT})", { weight: "100 900" }));
  addEventListener("DOMContentLoaded", () => {
    const style = document.createElement("style");
    style.textContent = "* { font-family: Golden !important; animation: none !important; transition: none !important; caret-color: transparent !important; }";
    document.head.append(style);
  });`;

/**
 * What a tab shows once it has come to rest: twice the same in a row.
 * @param {import("./browsers.mjs").Tab} tab
 */
export async function atRest(tab) {
  const settled = `Promise.all([document.fonts.ready, ...[...document.images].filter((image) => image.src && image.loading !== "lazy").map((image) => image.decode())])`;
  const shot = async () => {
    await tab.evaluate(`${settled}.then(() => ${PAINTED})`);
    return Picture.decode(Buffer.from(await tab.screenshot()));
  };
  let [before, after] = [await shot(), await shot()];
  while (!after.equals(before)) [before, after] = [after, await shot()];
  return after;
}

/**
 * Asserts that a picture is like the golden one of its name; with `GOLDEN=accept` in the environment it becomes that.
 * @param {string} name
 * @param {Picture} picture
 */
export async function assertGolden(name, picture) {
  const golden = path(`golden/${name}.png`);
  if (process.env.GOLDEN === "accept") {
    await mkdir(path("golden"), { recursive: true });
    return writeFile(golden, picture.encode());
  }
  const different = await difference(name, picture);
  if (different > ALLOWED) await refuse(name, picture, different);
}

/** @param {string} name @param {Picture} picture */
export async function isGolden(name, picture) {
  return (await difference(name, picture)) <= ALLOWED;
}

/**
 * In how many pixels a picture differs from the golden one of its name.
 * @param {string} name
 * @param {Picture} picture
 * @param {Buffer} [marked] takes the golden picture with these marked
 */
async function difference(name, { width, height, rgba }, marked) {
  const golden = Picture.decode(await readFile(path(`golden/${name}.png`)));
  if (golden.width !== width || golden.height !== height) return Number.POSITIVE_INFINITY;
  return pixelmatch(golden.rgba, rgba, marked, width, height, { threshold: THRESHOLD });
}

/** @param {string} name @param {Picture} picture @param {number} different */
async function refuse(name, picture, different) {
  const marked = Buffer.alloc(picture.rgba.length);
  await difference(name, picture, marked);
  await mkdir(REFUSED, { recursive: true });
  await writeFile(`${REFUSED}${name}.png`, picture.encode());
  await writeFile(`${REFUSED}${name}-marked.png`, new Picture(picture.width, picture.height, marked).encode());
  assert.fail(`${name} is another picture than tests/e2e/golden/${name}.png, in ${different} pixels, of which ${ALLOWED} may be:
    look at it in ${REFUSED}, beside it what differs in red. If it is as it should be: cargo xtask golden`);
}
