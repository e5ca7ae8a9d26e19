// The start of the page, and the wiring of its parts.

import { followed } from "./cursor.js";
import { Engine } from "./engine.js";
import { choose, download, receive } from "./files.js";
import { listen } from "./keys.js";
import { label, say } from "./messages.js";
import { png } from "./png.js";
import { Pointers } from "./pointer.js";
import { Samples } from "./samples.js";
import { connect, pickColor, shown, swatch, tell, warn } from "./toolbar.js";

/** An arrow key moves the view by this much, in CSS pixels. */
const STEP_PX = 48;

const stage = /** @type {HTMLElement} */ (document.getElementById("stage"));

/** Whether there is work that would be lost with the page. */
let hasWork = false;

/** The canvas of the moment: a lost one is replaced. */
const canvas = () => /** @type {HTMLCanvasElement} */ (document.getElementById("canvas"));

/** @type {Record<string, import("./engine.js").Handler>} */
const handlers = {
  ...shown,
  undo: both(shown.undo, (possible) => (hasWork = possible)),
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
  opened: (values) => {
    done(say(values.notes === "" ? "opened" : "opened-in-part", values));
  },
  ...Object.fromEntries(
    ["scribble-added", "scribbles-erased", "scribble-dropped", "undone", "redone"].map((key) => [
      key,
      (values) => done(say(key, values)),
    ]),
  ),
  failed: (values) => warn(say("failed", values)),
  "no-renderer": () => warn(say("error-renderer")),
  exported: async ({ name, width, height, rgba }) => {
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
/** @type {import("./files.js").Open} */
const open = (name, bytes, scribbles) => engine.command("open", { name, bytes, scribbles });
const samples = new Samples(open, () => warn(say("error-samples")));
const pointers = new Pointers(stage, engine);

/** Opens a person's own file, whatever sample is still on its way. @type {import("./files.js").Open} */
function openOwn(name, bytes) {
  samples.overtake();
  open(name, bytes);
}

/** What the page does by itself; all other actions are commands of the module. @type {Record<string, () => void>} */
const actions = {
  open: choose,
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
  receive(openOwn, () => warn(say("error-read")));
  window.addEventListener("beforeunload", (event) => {
    if (hasWork) event.preventDefault();
  });
  await samples.start();
  tell(say("start"));
}

start();
