// The start of the page, and the wiring of its parts.

import { begin, end, isBusy } from "./busy.js";
import { followed } from "./cursor.js";
import { Colors } from "./colors.js";
import { Drawings, isKept, isUnsaved, stem } from "./drawings.js";
import { Engine } from "./engine.js";
import { make } from "./elements.js";
import { choose, download, keep, receive } from "./files.js";
import { beginFirstSteps, followFirstSteps, showFirstSteps, skipFirstSteps } from "./first_steps.js";
import { formats } from "./formats.js";
import { connectFullScreen, turnFullScreen } from "./full_screen.js";
import { removed } from "./hold.js";
import { Keeper } from "./keeper.js";
import { SHORTCUTS, haveSingles, listen, setSingles, written } from "./keys.js";
import { connectLanguage } from "./language.js";
import { lazily } from "./lazy.js";
import { haveWords, label, name, say } from "./messages.js";
import { Opening } from "./opening.js";
import { Pointers } from "./pointer.js";
import { connectPrinter } from "./print.js";
import { FOLDER, sampleList, sampleName } from "./samples.js";
import { labelSelection, selectsMore, showSelection, toggleMore } from "./selection.js";
import { Steps } from "./steps.js";
import { entries, picture, putAside } from "./storage.js";
import { connectSwatches, labelSwatches, shownSwatches, swatch } from "./swatches.js";
import { areLinesShown, connect, done, failed, labelControls, shown, showFingers, showName, showUnkept, showUpdate, tell, told, toggle, warn } from "./toolbar.js";
import { connectBar, connectRadios } from "./toolbars.js";
import { Tracing } from "./tracing.js";
import { followVersions, holdVersion, takeVersion } from "./versions.js";

/** What the address may ask for. */
const SOLVERS = ["automatic", "mesh", "gpu"];

/** What is said of when it is done. */
const DOINGS = ["scribbles-erased", "scribbles-rubbed", "eraser-turned", "selected", "edited", "turned"];

/** What the page is seen to be busy with. */
const MAKING = "making";

/** Where the arrow keys go. @type {Record<string, [number, number]>} */
const ARROWS = { Left: [-1, 0], Right: [1, 0], Up: [0, -1], Down: [0, 1] };

const stage = /** @type {HTMLElement} */ (document.getElementById("stage"));

/** The canvas of the moment: a lost one is replaced. */
const canvas = () => /** @type {HTMLCanvasElement} */ (document.getElementById("canvas"));

/** @type {Record<string, import("./engine.js").Handler>} */
const handlers = {
  ...shown,
  sheet: (state) => {
    drawings.follow(state);
    tracing.show(drawings.shown.images);
    keeper.follow(drawings.shown);
    steps.follow();
  },
  closed: (sheet) => drawings.close(sheet),
  tracing: both(shown.tracing, (state) => tracing.follow(state)),
  tool: both(shown.tool, followed.tool),
  color: (color) => {
    shownSwatches.color(color);
    followed.color(color);
    colors.follow();
    followFirstSteps("color");
  },
  palette: both(shownSwatches.palette, () => colors.follow()),
  "brush-size": both(shown["brush-size"], followed["brush-size"]),
  zoom: both(shown.zoom, followed.zoom),
  selection: showSelection,
  view: (matrix) => {
    tracing.look(matrix);
    // The affine map from drawing units to CSS pixels of the canvas, for those who look at the canvas from outside.
    canvas().dataset.view = [...matrix].join(" ");
  },
  renderer: (name) => {
    const { renderer } = canvas().dataset;
    if (renderer) tell(say(renderer === name ? "recovered" : `recovered-${name}`));
    canvas().dataset.renderer = name;
  },
  solver: both(shown.solver, ({ source }) => {
    // Which one makes the picture, for those who look at the canvas from outside.
    canvas().dataset.solver = source;
    if (source.includes("-")) tell(say(`source-${source}`));
  }),
  opened: ({ notes }) => done(say(notes === "" ? "opened" : "opened-in-part", { name: drawings.shown.name, notes })),
  "scribble-added": (values) => {
    colors.used();
    doing("scribble-added", values);
  },
  "scribble-dropped": () => pointers.isTakingBack || doing("scribble-dropped", {}),
  ...Object.fromEntries(
    [...DOINGS, "picked", "undone", "redone"].map((key) => [
      key,
      (values) => doing(key, values),
    ]),
  ),
  making: (wanted) => {
    // A mesh takes the place of pixels, which look like it.
    if (wanted === "picture") begin(MAKING, say("making"));
    else end(MAKING);
  },
  "making-stopped": () => opening.stopped("making-stopped"),
  failed: (values) => warn(say("failed", values)),
  unopened: ({ sheet, sentence }) => opening.unopened(drawings.leave(sheet), sentence),
  "no-renderer": () => warn(say("error-renderer")),
  stopped: (isPreparing) => {
    warn(say("error-stopped"));
    // What does this as it is opened would do it again.
    const { id, revision } = drawings.shown;
    if (id && revision === 0 && !isPreparing) putAside(id).catch(console.warn);
  },
};

/**
 * Says what was done.
 * @param {string} key
 * @param {any} values
 */
function doing(key, values) {
  done(followFirstSteps(key) ? say("steps-done") : say(key, values));
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

/** Strips of a picture for the list that take longer let the page go on in between. */
const STRIPS_MS = 8;

const engine = new Engine(handlers);
connectPrinter(engine);
const drawings = new Drawings(nameShown);
const tracing = new Tracing(engine);
const keeper = new Keeper({
  work: () => engine.work(),
  image: () => tracing.image,
  shown: () => drawings.shown,
  isMaking: () => engine.isMaking,
  picture: async () => {
    const picture = engine.thumbnail();
    if (!picture) return undefined;
    try {
      const { pngOf } = await import("./png.js");
      let begin_ms = performance.now();
      return await pngOf(picture, false, async () => {
        // A page that goes away waits for nothing; a picture that takes no time is there before that may be.
        if (document.hidden || performance.now() < begin_ms + STRIPS_MS) return;
        await new Promise((wake) => setTimeout(wake));
        begin_ms = performance.now();
      });
    } finally {
      picture.free();
    }
  },
  kept: nameShown,
  copied: (copy, before) => {
    nameShown();
    tell(say("copied-beside", { name: copy.name, before }));
  },
  failing: showUnkept,
});
const opening = new Opening(engine, drawings, keeper, tracing);
const colors = new Colors(engine, (file) => opening.file(file));
const steps = new Steps(engine);
const pointers = new Pointers(stage, engine, selectsMore, (fingersDraw) => {
  showFingers(fingersDraw);
  tell(say(fingersDraw ? "fingers-draw" : "pen-draws"));
});

function nameShown() {
  const { shown } = drawings;
  showName(shown.name, isUnsaved(shown), isKept(shown));
}

const sharing = lazily(
  () => import("./share.js"),
  ({ Share }) => new Share({ say, label, codeOf: formats.qrCode, save }),
);

const gallery = lazily(
  () => import("./gallery.js"),
  ({ Gallery }) => {
    const open = opening.sample.bind(opening);
    return new Gallery({ say, label, name, list: sampleList, nameOf: sampleName, folder: FOLDER, open });
  },
);

const recent = lazily(
  () => import("./recent.js"),
  ({ Recent }) => {
    const remove = async (/** @type {string} */ id) => {
      const isGone = await removed(id);
      if (isGone) keeper.drop(drawings.forget(id));
      return isGone;
    };
    return new Recent({ say, label, name, entries, picture, open: (id) => opening.kept(id), remove });
  },
);

const exporting = lazily(
  () => import("./export.js"),
  ({ Export }) => new Export({ engine, formats, say, label, done, drawing: () => drawings.shown.name, stem, download }),
);

const help = lazily(
  () => import("./help.js"),
  ({ Help }) => new Help({ say, label, labelNames, shortcuts: SHORTCUTS, written, haveSingles, setSingles, showFirstSteps }),
);

const keyboardPen = lazily(
  () => import("./keyboard_pen.js"),
  ({ KeyboardPen }) => new KeyboardPen({ stage, engine, make, say, tell }),
);

function share() {
  const work = engine.work();
  if (!work) return;
  sharing.use(async (dialog) => dialog.open((await formats.link(work)) ?? "", tracing.image !== undefined));
}

async function save() {
  const drawing = drawings.shown;
  const { name, handle, revision } = drawing;
  const work = engine.work();
  const image = tracing.image?.bytes;
  if (!work) return;
  try {
    const place = await keep({ name: `${stem(name)}.scumble`, handle }, () => formats.save(work, image));
    if (!place) return;
    drawings.keep(drawing, revision, place);
    keeper.saved(drawing);
    done(say("saved", place));
  } catch (fault) {
    drawing.handle = undefined;
    failed(fault);
  }
}

function removeTracing() {
  engine.command("trace", null);
  done(say("tracing-removed"));
  // The button goes with the picture.
  canvas().focus();
}

async function showRecent() {
  await keeper.pictureNow();
  await recent.use((dialog) => dialog.show(drawings.shown.id).catch(() => failed(new Error(say("error-storage")))));
}

/** What the page does by itself; all other actions are commands of the module. @type {Record<string, () => void>} */
const actions = {
  open: () => void choose((file) => opening.file(file)).catch(failed),
  save,
  export: () => exporting.use((dialog) => dialog.open(areLinesShown())),
  "remove-tracing": removeTracing,
  share,
  recent: showRecent,
  samples: () => gallery.use((dialog) => dialog.show()),
  "pick-color": () => colors.show("color"),
  "edit-palette": () => colors.show("edit-palette"),
  dismiss: () => warn(""),
  "dismiss-unkept": () => showUnkept(""),
  update: takeVersion,
  "dismiss-update": () => showUpdate(false),
  help: () => help.use((dialog) => dialog.show()),
  history: () => steps.toggle(),
  "full-screen": turnFullScreen,
  "skip-steps": skipFirstSteps,
  "select-more": toggleMore,
  fingers: () => pointers.turnFingers(),
  pen: () => {
    canvas().focus();
    keyboardPen.use((pen) => pen.press());
  },
  stop: () => {
    if (opening.isLong) void opening.stop();
    else opening.stopMaking();
    // The button goes with what it stops.
    canvas().focus();
  },
  drop: () => {
    warn("");
    // Escape closes what is open, and does no more.
    if (pointers.cancel() || keyboardPen.now?.drop() || document.querySelector(":popover-open") || skipFirstSteps()) return;
    if (opening.isLong || isBusy(MAKING)) act("stop");
    else engine.command("select-none");
  },
};

/** What is done while a key is held. @type {Record<string, (held: boolean) => void>} */
const holds = {
  "hold-hand": (held) => pointers.hold(held ? "pan" : ""),
  "hold-rotate": (held) => pointers.hold(held ? "rotate" : ""),
  "hold-before": (held) => {
    tell(held ? say("before") : "");
    engine.command("before", held);
  },
};

/**
 * @param {[number, number]} direction
 * @param {boolean} isFar
 */
function moveBy(direction, isFar) {
  const move = () => engine.command("arrow", [...direction, Number(isFar)]);
  // Arrows wait with Enter while it is fetched.
  if (keyboardPen.loading) keyboardPen.use((pen) => pen.move(direction, isFar) || move());
  else move();
}

/** Has what is picked be scribbled with. @param {string | undefined} color nothing where no swatch is */
function pick(color) {
  if (color) engine.command("color", color);
}

/** @param {string} action */
function act(action) {
  const [, kind, which] = /^(swatch|tool|show|arrow-Arrow|far-Shift\+Arrow)-?(.+)$/.exec(action) ?? [];
  if (kind === "swatch") pick(swatch(Number(which)));
  else if (kind === "tool") engine.command("tool", which);
  else if (kind === "show") toggle(which);
  else if (kind) moveBy(ARROWS[which], kind !== "arrow-Arrow");
  else if (actions[action]) actions[action]();
  else engine.command(action);
}

/** What says in words what keys have chosen, from the first one on. @type {Promise<[typeof import("./spoken.js"), void]> | undefined} */
let spoken;

/**
 * Does what a key is for, and says what that has chosen, unless there is something else to be said by then.
 * @param {string} action
 */
function actByKey(action) {
  const before = told;
  act(action);
  // No key has done that.
  if (action === "settle") return;
  spoken ??= Promise.all([import("./spoken.js"), haveWords()]);
  spoken.then(
    ([{ wordsOf }]) => {
      const words = wordsOf(action, say);
      if (words && told === before) tell(words);
    },
    () => (spoken = undefined),
  );
}

/** The colour around the page as #rrggbb: the theme's, from the style sheet. */
function desk() {
  const channels = getComputedStyle(stage).backgroundColor.match(/\d+/g)?.slice(0, 3) ?? [];
  return `#${channels.map((channel) => Number(channel).toString(16).padStart(2, "0")).join("")}`;
}

/** Tells the module the size of the canvas in device pixels, device pixels per CSS pixel, and where it lies. */
function followSize() {
  const tellSize = () => {
    const scale = devicePixelRatio;
    const { left, top } = stage.getBoundingClientRect();
    engine.command("resize", [Math.round(stage.clientWidth * scale), Math.round(stage.clientHeight * scale), scale, left, top]);
  };
  new ResizeObserver(tellSize).observe(stage);
  window.addEventListener("resize", tellSize);
  tellSize();
}

/** Names all controls, with the shortcuts that are on. */
function labelNames() {
  labelControls();
  labelSwatches();
}

/** Says everything that is there in the language of the page. */
function labelAll() {
  labelNames();
  labelSelection();
  colors.forget();
  steps.forget();
  nameShown();
  gallery.now?.forget();
  tell("");
}

/** The page may go away: what a slider or a key has in hand is kept as it is, and all else. */
function leave() {
  engine.command("settle");
  keeper.hurry();
}

async function start() {
  holdVersion();
  await connectLanguage(labelAll);
  labelControls();
  connectSwatches(pick);
  connectBar(/** @type {HTMLElement} */ (document.getElementById("bar")));
  connectRadios(/** @type {HTMLElement} */ (document.getElementById("tools")));
  connectFullScreen();
  connect(act, (command, args) => engine.command(command, args));
  try {
    await engine.start(desk());
  } catch {
    warn(say("error-start"));
    return;
  }
  followSize();
  const solver = new URLSearchParams(location.search).get("solver") ?? "";
  if (SOLVERS.includes(solver)) engine.command("solver", solver);
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => engine.command("desk", desk()));
  listen(actByKey, (action, held) => holds[action]?.(held));
  receive((file) => opening.file(file), (text) => opening.text(text));
  window.addEventListener("hashchange", () => void (location.hash && opening.address()));
  window.addEventListener("beforeunload", (event) => {
    engine.command("settle");
    if (drawings.areAtRisk) event.preventDefault();
  });
  window.addEventListener("pagehide", leave);
  document.addEventListener("visibilitychange", () => document.hidden && leave());
  await opening.begin(beginFirstSteps).catch(failed);
  followVersions(() => showUpdate(true));
}

start();
