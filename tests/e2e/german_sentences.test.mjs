// What the Rust side says has its German: each sentence in its sources, and in those of the XML parser, has a twin in the
// table that German pages have, and no twin is without a source.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readdir, readFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { inGerman, sentences, things } from "../../web/german_sentences.js";

const CRATES = fileURLToPath(new URL("../../crates", import.meta.url));

/** The crates whose sentences the page shows. Those of `scumble-gpu` go to the console; `scumble-export` makes none. */
const SAYING = ["core", "solve", "io", "files", "web"];

/** What the page does not show: files, or items in them up to where they end. @type {[string, string?][]} */
const UNSEEN = [
  // Of the command line alone.
  ["core/src/color.rs"],
  ["io/src/scribbles.rs"],
  ["io/src/picture_file.rs"],
  ["io/src/error.rs", "pub enum ScribblesError"],
  ["io/src/notes.rs", "impl fmt::Display for ScribbleNotes"],
  ["io/src/notes.rs", "impl fmt::Display for CurveSetNotes"],
  // For the console.
  ["web/src/app.rs"],
  ["web/src/screen.rs"],
  // Told otherwise where they are read.
  ["io/src/work_file/items.rs", "const NO_MORE_CURVES"],
  ["io/src/work_file/pressures.rs", "pub(super) fn press"],
  // What is written, no words.
  ["io/src/curve_set/write.rs"],
  ["io/src/svg.rs", "const IGNORED"],
  ["io/src/svg.rs", "const UNCLIPPED"],
  ["io/src/svg.rs", "const UNMASKED"],
  ["io/src/svg_source.rs", "pub fn write_svg_source"],
  ["io/src/palette/gpl.rs", "pub(super) const MARK"],
  ["io/src/palette/gpl.rs", "pub(super) fn written"],
];

/** Faults of the XML parser that are told otherwise, or need what is not asked of it. */
const UNSEEN_OF_XML = ["nodes limit reached", "XML with DTD detected", "entity resolver failed at {}: {}"];

/** Comments, characters, bytes, and in a group the content of strings. */
const TOKENS = /\/\/[^\n]*|b?'(?:\\[^']+|[^\\'])'|\bb"(?:[^"\\]|\\[^])*"|\br(#*)"[^]*?"\1|"((?:[^"\\]|\\[^])*)"/g;

/** The strings in Rust code, as they are shown. @param {string} code */
function strings(code) {
  const found = [...code.matchAll(TOKENS)].flatMap(([, , string]) => (string === undefined ? [] : [string]));
  return found.map((string) => string.replace(/\\(.)/g, "$1"));
}

/** What a format string says, with `{}` for each value. @param {string} format */
function template(format) {
  return format.replace(/\{\{|\}\}|\{[\w:?]*\}/g, (part) => (/^(.)\1$/.test(part) ? part[0] : "{}"));
}

/** Whether a string is for people: words, or what puts notes in brackets. @param {string} string */
function isSaid(string) {
  return /\p{L}[\p{P}\p{L}]* \p{L}|\p{L}: $|^ \(\{\w+\}\)$/u.test(string);
}

/** Rust code without its tests and what the page does not show. @param {string} name of the file */
async function seenCode(name) {
  let code = await readFile(join(CRATES, `scumble-${name}`), "utf8");
  code = code.replace(/#\[cfg\(test\)\]\s*mod [^]*/, "");
  for (const [, item] of UNSEEN.filter(([file]) => file === name)) {
    const start = code.indexOf(item ?? "");
    assert.ok(start >= 0, `${name} has no ${item}`);
    const end = item?.includes("const ") ? '";\n' : "\n}\n";
    const length = item ? code.slice(start).indexOf(end) + end.length : code.length;
    code = code.slice(0, start) + code.slice(start + length);
  }
  return code;
}

/** The code of all files that the page shows something of. */
async function sources() {
  const folders = SAYING.map(async (crate) => {
    const files = await readdir(join(CRATES, `scumble-${crate}/src`), { recursive: true });
    return files.filter((file) => /(?<!tests)\.rs$/.test(file)).map((file) => `${crate}/src/${file}`);
  });
  const names = (await Promise.all(folders)).flat();
  assert.deepEqual(UNSEEN.map(([name]) => name).filter((name) => !names.includes(name)), []);
  return Promise.all(names.map(seenCode));
}

/** What the XML parser says. @returns {Promise<string[]>} */
async function xmlSentences() {
  const options = ["metadata", "--format-version=1", "--offline", "--filter-platform=wasm32-unknown-unknown"];
  const { packages } = JSON.parse(execFileSync("cargo", options, { cwd: CRATES, maxBuffer: 1 << 28 }).toString());
  const { manifest_path } = packages.find((/** @type {{name: string}} */ { name }) => name === "roxmltree");
  const [parse, tokenizer] = await Promise.all(
    ["parse.rs", "tokenizer.rs"].map((file) => readFile(join(dirname(manifest_path), "src", file), "utf8")),
  );
  const [display] = parse.slice(parse.indexOf("Display for Error")).split("\n}\n");
  const expected = [...tokenizer.matchAll(/InvalidChar2\(\s*("[^"]+")/g)].flatMap(([, string]) => strings(string));
  return [...strings(display).map(template).filter((said) => !UNSEEN_OF_XML.includes(said)), ...expected.filter(isWord)];
}

/** @param {string} string */
function isWord(string) {
  return /\p{L}/u.test(string);
}

/** What a table lacks, and what in it is of no use. @param {string[]} said @param {Record<string, string>} table */
function differing(said, table) {
  return { lacking: said.filter((text) => !(text in table)), idle: Object.keys(table).filter((text) => !said.includes(text)) };
}

/** @param {string} text @param {string} value in place of each placeholder */
const filled = (text, value) => text.replace(/\{\*?\}/g, value);

test("each sentence has its German, and each German one its sentence", async () => {
  const code = (await sources()).join("\n");
  const counted = [...code.matchAll(/\(\s*self\.\w+,\s*("[^"]+",\s*"[^"]+"),?\s*\)/g)].flatMap(([, both]) => strings(both));
  const alone = strings(code).filter((string) => isSaid(string) && !counted.includes(string)).map(template);
  const said = [...alone.map((text) => (text.endsWith(": ") ? `${text}{}` : text)), ...(await xmlSentences())];
  assert.deepEqual(differing(said, sentences), { lacking: [], idle: [] });
  assert.deepEqual(differing(counted, things), { lacking: [], idle: [] });
});

test("each sentence is taken for itself, with all its values", () => {
  for (const [english, german] of Object.entries(sentences)) {
    assert.equal(german.match(/\{\*?\}/g)?.length, english.match(/\{\}/g)?.length, english);
    assert.equal(inGerman(filled(english, "7:x")), filled(german, "7:x"));
  }
});

test("sentences within sentences, and lists of things, are said in German", () => {
  const notes = "left out: 1 text, 12 clip paths, 2 curves with unusable control points";
  const german = "weggelassen: 1 Text, 12 Beschneidungspfade, 2 Kurven mit unbrauchbaren Kontrollpunkten";
  assert.equal(inGerman(notes), german);
  assert.equal(
    inGerman(`the drawing has no lines and no shapes to colour (${notes})`),
    `die Zeichnung hat keine Linien und keine Formen zum Färben (${german})`,
  );
  assert.equal(
    inGerman("its lines alone, without the scribbles: the file cannot be used: line 3 should have a colon; mend it there, or save the drawing again"),
    "nur die Linien, ohne die Kritzel: die Datei ist in Zeile 3 unbrauchbar, dort müsste stehen: ein Doppelpunkt; bessere sie aus, oder sichere die Zeichnung noch einmal",
  );
  assert.equal(
    inGerman("the diffusion curves are damaged: expected a quote not 'x' at 2:5; mend the file there, or save it again"),
    "die Diffusionskurven sind beschädigt: ein Anführungszeichen statt 'x' erwartet bei 2:5; bessere die Datei dort aus, oder sichere sie noch einmal",
  );
});

test("what is no sentence of the Rust side stays, and so do values", () => {
  for (const text of ["", "Etwas anderes mit 3 images; und so", "a quote unquote", "5 constructor"]) assert.equal(inGerman(text), text);
  assert.match(
    inGerman("this is no drawing: it starts with <a number>, not with <svg>, nor with <curve_set> as diffusion curves do; choose another"),
    /<a number>/,
  );
});
