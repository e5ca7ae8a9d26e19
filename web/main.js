// The start of the page, and the wiring of its parts.

import { followed } from "./cursor.js";
import { Drawings, isUnsaved, stem } from "./drawings.js";
import { Engine } from "./engine.js";
import { choose, download, keep, receive } from "./files.js";
import { formats } from "./formats.js";
import { listen } from "./keys.js";
import { label, say } from "./messages.js";
import { png } from "./png.js";
import { Pointers } from "./pointer.js";
import { Samples, sampleWork } from "./samples.js";
import { closeShare, copyLink, isLink, sendLink, showLink } from "./share.js";
import { connect, pickColor, shown, showName, swatch, tell, warn } from "./toolbar.js";

/** An arrow key moves the view by this much, in CSS pixels. */
const STEP_PX = 48;

const stage = /** @type {HTMLElement} */ (document.getElementById("stage"));

/** The canvas of the moment: a lost one is replaced. */
const canvas = () => /** @type {HTMLCanvasElement} */ (document.getElementById("canvas"));

/** @type {Record<string, import("./engine.js").Handler>} */
const handlers = {
  ...shown,
  sheet: (state) => drawings.follow(state),
  tool: both(shown.tool, followed.tool),
  color: both(shown.color, followed.color),
  "brush-size": both(shown["brush-size"], followed["brush-size"]),
  zoom: both(shown.zoom, followed.zoom),
  // The affine map from drawing units to CSS pixels of the canvas, for those who look at the canvas from outside.
  view: (matrix) => (canvas().dataset.view = [...matrix].join(" ")),
  renderer: (name) => {
    if (canvas().dataset.renderer) tell(say("recovered"));
    canvas().dataset.renderer = name;
  },
  opened: ({ notes }) => done(say(notes === "" ? "opened" : "opened-in-part", { name: drawings.shown.name, notes })),
  ...Object.fromEntries(
    ["scribble-added", "scribbles-erased", "scribble-dropped", "undone", "redone"].map((key) => [
      key,
      (values) => done(say(key, values)),
    ]),
  ),
  failed: (values) => warn(say("failed", values)),
  "no-renderer": () => warn(say("error-renderer")),
  exported: async ({ width, height, rgba }) => {
    const name = `${stem(drawings.shown.name)}.png`;
    download(name, await png(width, height, rgba));
    done(say("exported", { name }));
  },
  stopped: () => warn(say("error-stopped")),
};

/** Says what was done; a warning about something before it has had its time. @param {string} text */
function done(text) {
  warn("");
  tell(text);
}

/**
 * @param {(value: any) => void} first
 * @param {(value: any) => void} second
 */
function both(first, second) {
  return (/** @type {any} */ value) => {
    first(value);
    second(value);
  };
}

const engine = new Engine(handlers);
const drawings = new Drawings((drawing) => showName(drawing.name, isUnsaved(drawing)));
const samples = new Samples(open);
const pointers = new Pointers(stage, engine);

/** Counts what has been asked for: what comes after something else was asked for is dropped. */
let asked = 0;

/**
 * Opens what is on its way.
 * @param {string} name
 * @param {Promise<import("./formats.js").Opened>} coming
 * @param {any} [handle] the file that it can be saved to again
 * @returns what went wrong, if anything did; the page has been told
 */
async function open(name, coming, handle) {
  const ticket = ++asked;
  try {
    const { work, notes } = await whole(coming);
    if (ticket !== asked) return undefined;
    drawings.expect(name, handle);
    engine.command("open", { work, notes });
    return undefined;
  } catch (fault) {
    if (ticket === asked) failed(fault);
    return fault;
  }
}

/**
 * Work with its lines, which come from a sample where it has only the name of that.
 * @param {Promise<import("./formats.js").Opened>} coming
 */
async function whole(coming) {
  const opened = await coming;
  if (!opened.lacks) return opened;
  return { work: await formats.onSample(opened.work, await sampleWork(opened.lacks)), notes: opened.notes };
}

/** @param {import("./files.js").Coming} coming */
function openFile({ name, bytes, handle }) {
  open(name, bytes.then(formats.open), handle);
}

/** @param {string} text a link, or SVG */
function openText(text) {
  if (isLink(text)) openLink(text);
  else openFile({ name: "SVG", bytes: Promise.resolve(new TextEncoder().encode(text)) });
}

/**
 * Opens a link beside the work that is there.
 * @param {string} link
 * @returns what went wrong, if anything did
 */
async function openLink(link) {
  const before = drawings.shown;
  const fault = await open(say("shared-drawing"), formats.openLink(link));
  if (drawings.shown !== before && before.revision > 0) tell(say("opened-beside", { before: before.name }));
  return fault;
}

/** Opens the link in the address, which is then the page's own again: its drawing may become another. */
function openAddress() {
  const link = location.hash;
  history.replaceState(null, "", location.pathname + location.search);
  return openLink(link);
}

async function share() {
  const work = engine.work();
  if (!work) return;
  try {
    await showLink((await formats.link(work)) ?? "", formats.qrCode);
  } catch (fault) {
    failed(fault);
  }
}

async function save() {
  const drawing = drawings.shown;
  const { name, handle, revision } = drawing;
  const work = engine.work();
  if (!work) return;
  try {
    const place = await keep({ name: `${stem(name)}.scumble`, handle }, () => formats.save(work));
    if (!place) return;
    drawings.keep(drawing, revision, place);
    done(say("saved", place));
  } catch (fault) {
    drawing.handle = undefined;
    failed(fault);
  }
}

/** @param {unknown} fault with a sentence for people */
function failed(fault) {
  warn(say("failed", { sentence: /** @type {Error} */ (fault).message }));
}

/** What the page does by itself; all other actions are commands of the module. @type {Record<string, () => void>} */
const actions = {
  open: () => void choose(openFile).catch(failed),
  save,
  share,
  "close-share": closeShare,
  "copy-link": copyLink,
  "send-link": sendLink,
  samples: () => samples.show(),
  "close-samples": () => samples.close(),
  "pick-color": pickColor,
  dismiss: () => warn(""),
  cancel: () => pointers.cancel(),
  "pan-left": () => engine.command("pan", [STEP_PX, 0]),
  "pan-right": () => engine.command("pan", [-STEP_PX, 0]),
  "pan-up": () => engine.command("pan", [0, STEP_PX]),
  "pan-down": () => engine.command("pan", [0, -STEP_PX]),
};

/** @param {string} action */
function act(action) {
  const [, kind, which] = /^(swatch|tool)-(.+)$/.exec(action) ?? [];
  if (kind === "swatch") engine.command("color", swatch(Number(which)));
  else if (kind === "tool") engine.command("tool", which);
  else if (actions[action]) actions[action]();
  else engine.command(action);
}

/** The colour around the page as #rrggbb: the theme's, from the style sheet. */
function desk() {
  const channels = getComputedStyle(stage).backgroundColor.match(/\d+/g)?.slice(0, 3) ?? [];
  return `#${channels.map((channel) => Number(channel).toString(16).padStart(2, "0")).join("")}`;
}

/** Tells the module the size of the canvas, in device pixels and device pixels per CSS pixel. */
function followSize() {
  const tellSize = () => {
    const scale = devicePixelRatio;
    engine.command("resize", [Math.round(stage.clientWidth * scale), Math.round(stage.clientHeight * scale), scale]);
  };
  new ResizeObserver(tellSize).observe(stage);
  window.addEventListener("resize", tellSize);
  tellSize();
}

/** Opens the link in the address, or else the first sample, unless something has been opened meanwhile. */
async function begin() {
  try {
    const list = samples.list();
    const fault = isLink(location.hash) ? await openAddress() : undefined;
    if (drawings.areNone && (asked === 0 || fault)) await samples.choose((await list)[0]);
    if (fault) failed(fault);
  } catch (fault) {
    failed(fault);
  }
}

async function start() {
  label(document);
  connect(act, (command, args) => engine.command(command, args));
  try {
    await engine.start(desk());
  } catch {
    warn(say("error-start"));
    return;
  }
  followSize();
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => engine.command("desk", desk()));
  listen(act, (held) => pointers.holdSpace(held));
  receive(openFile, openText);
  window.addEventListener("hashchange", () => void (isLink(location.hash) && openAddress()));
  window.addEventListener("beforeunload", (event) => {
    if (drawings.areUnsaved) event.preventDefault();
  });
  const isFresh = !isLink(location.hash);
  await begin();
  if (isFresh) tell(say("start"));
}

start();
