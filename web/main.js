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
import { Samples } from "./samples.js";
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
 */
async function open(name, coming, handle) {
  const ticket = ++asked;
  try {
    const { work, notes } = await coming;
    if (ticket !== asked) return;
    drawings.expect(name, handle);
    engine.command("open", { work, notes });
  } catch (fault) {
    if (ticket === asked) failed(fault);
  }
}

/** @param {import("./files.js").Coming} coming */
function openFile({ name, bytes, handle }) {
  open(name, bytes.then(formats.open), handle);
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

/** Opens the first sample, unless something else has been opened meanwhile. */
async function begin() {
  try {
    const [first] = await samples.list();
    if (asked === 0) await samples.choose(first);
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
  receive(openFile);
  window.addEventListener("beforeunload", (event) => {
    if (drawings.areUnsaved) event.preventDefault();
  });
  await begin();
  tell(say("start"));
}

start();
