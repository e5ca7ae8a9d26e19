// The drawings that come with the page.

import { say } from "./messages.js";

/** @typedef {{ kind: string, file: string, name: string, credit: string }} Sample its kind and its name in English, as `index.json` has them */

/** Where they are. */
export const FOLDER = new URL("../samples/", import.meta.url);

/** What a page begins with where nobody has worked. */
export const FIRST = { file: "goldfish.svg", name: "Goldfish" };

/** @param {{name: string}} sample */
export const sampleName = ({ name }) => say(`sample-${name}`);

/**
 * A sample as work: its lines alone, or with scribbles.
 * @param {string} file
 * @param {boolean} [isColored]
 */
export async function sampleWork(file, isColored = false) {
  const ending = isColored ? "colored.work" : "work";
  const buffer = await fetched(file.replace(/svg$/, ending), (response) => response.arrayBuffer());
  return new Uint8Array(buffer);
}

/** All of them. @returns {Promise<Sample[]>} */
export const sampleList = () => fetched("index.json", (response) => response.json());

/**
 * A file of the samples' folder.
 * @template T
 * @param {string} file
 * @param {(response: Response) => Promise<T>} read
 */
async function fetched(file, read) {
  try {
    const response = await fetch(new URL(file, FOLDER));
    if (response.ok) return await read(response);
  } catch (fault) {
    console.warn(fault);
  }
  throw new Error(say("error-samples"));
}
