// The way to the wasm module: which build is loaded, calls into it, frames, and what comes back.
//
// A call returns a flat list of effects, [name, value, name, value, …], which go to the handlers. Once the module
// has broken off in a call it is not entered again.

/**
 * @typedef {object} App What the module exports; see `crates/scumble-web/src/app.rs`.
 * @property {(phase: string, samples: Float32Array) => unknown[]} pointer
 * @property {(name: string, args?: unknown) => unknown[]} command
 * @property {(work: Uint8Array) => void} prepare
 * @property {() => boolean} prepareOn
 * @property {() => boolean} makeOn
 * @property {() => unknown[]} frame
 * @property {() => Uint8Array} work
 * @property {() => {steps: string[], place: number}} history
 * @property {(model: string, numbers: Float64Array) => Uint32Array} colors
 * @property {(model: string, rgb: number) => Float64Array} colorNumbers
 * @property {() => Export} thumbnail
 * @property {(size_px: number, lines: boolean) => Export} export
 *
 * @typedef {object} Export a picture of the drawing as it was; `free` gives back what it takes
 * @property {number} width
 * @property {number} height
 * @property {(first: number, count: number, transparent: boolean) => Uint8Array} rows
 * @property {() => Uint8Array} field
 * @property {() => void} free
 *
 * @typedef {"down" | "add" | "erase" | "pick" | "move" | "up" | "cancel"} Phase
 * @typedef {(value: any) => void} Handler
 * @typedef {"webgpu" | "webgl" | "cpu"} Renderer
 */

/** Work that takes longer than this lets the page go on in between; it comes in slices that take less. */
const SLICE_MS = 16;

/** Another build is waited for so long, with nothing painted. */
const PATIENCE_MS = 8_000;

const RENDERERS = /** @type {Renderer[]} */ (["webgpu", "webgl", "cpu"]);

export class Engine {
  /** How many drawings are made ready that are not shown yet. */
  #preparing = 0;
  /** @type {App | undefined} */
  #app;
  /** @type {Record<string, Handler>} */
  #handlers;
  #frameAsked = false;
  /** Whether another picture of the drawing is on its way. */
  isMaking = false;
  /** @type {Renderer | undefined} The renderer that it began with. */
  #build;

  /** @param {Record<string, Handler>} handlers what to do with each effect; `stopped` is called after a fault, with whether a drawing was being made ready */
  constructor(handlers) {
    const making = (/** @type {"" | "picture" | "mesh"} */ wanted) => {
      this.isMaking = wanted !== "";
      handlers.making?.(wanted);
    };
    this.#handlers = { ...handlers, making, lost: (renderer) => this.#recover(renderer) };
    for (const kind of ["error", "unhandledrejection"]) {
      window.addEventListener(kind, (event) => {
        const fault = /** @type {any} */ (event).error ?? /** @type {any} */ (event).reason;
        if (fault instanceof WebAssembly.RuntimeError) this.#stop();
      });
    }
  }

  /**
   * Starts the first renderer that works; rejects where none does.
   * @param {string} desk colour around the page, #rrggbb
   */
  async start(desk) {
    let failure;
    for (const renderer of await candidates()) {
      try {
        const { App } = await load(renderer);
        this.#build = renderer;
        const options = { renderer, desk, wake: () => this.#askFrame() };
        this.#app = await App.create(this.#freshCanvas(), options);
        return;
      } catch (error) {
        console.warn(`${renderer}:`, error);
        failure = error;
      }
    }
    throw failure;
  }

  /**
   * @param {string} name
   * @param {unknown} [args]
   */
  command(name, args) {
    this.#enter((app) => app.command(name, args));
    this.#askFrame();
  }

  /**
   * Makes work ready for the command "open"; where that takes long, the page goes on in between.
   * @param {Uint8Array} work its exact bytes
   * @param {AbortSignal} signal ends it
   */
  async prepare(work, signal) {
    signal.throwIfAborted();
    this.#preparing++;
    try {
      await this.#prepare(work, signal);
    } finally {
      this.#preparing--;
    }
  }

  /**
   * @param {Uint8Array} work
   * @param {AbortSignal} signal
   */
  async #prepare(work, signal) {
    this.#call((app) => app.prepare(work));
    let isMore;
    // The page has a turn before "open", which takes its time too.
    do {
      isMore = this.#goOn((app) => app.prepareOn());
      await new Promise((wake) => setTimeout(wake));
      signal.throwIfAborted();
    } while (isMore);
  }

  /**
   * Goes on with long work for a while, and tells whether there is more of it.
   * @param {(app: App) => boolean} next its next slice
   */
  #goOn(next) {
    const start_ms = performance.now();
    while (this.#call(next) === true) if (performance.now() > start_ms + SLICE_MS) return true;
    return false;
  }

  /**
   * @param {Phase} phase
   * @param {Float32Array} samples x and y in CSS pixels from the canvas' corner, and pressure in 0..=1 (1 where there is none to be had), in turn
   */
  pointer(phase, samples) {
    this.#enter((app) => app.pointer(phase, samples));
    this.#askFrame();
  }

  /** Whether the module has started and not stopped. */
  get isRunning() {
    return this.#app !== undefined;
  }

  /**
   * Colours of numbers, three each, of a model: "oklch" or "hsv".
   * @param {string} model
   * @param {number[]} numbers
   */
  colors(model, numbers) {
    return this.#call((app) => app.colors(model, new Float64Array(numbers))) ?? new Uint32Array(numbers.length / 3);
  }

  /**
   * The three numbers of a colour.
   * @param {string} model
   * @param {string} color #rrggbb
   */
  colorNumbers(model, color) {
    return [...(this.#call((app) => app.colorNumbers(model, parseInt(color.slice(1), 16))) ?? [0, 0, 0])];
  }

  /** The exact bytes of the work; nothing once the module has stopped. */
  work() {
    return this.#call((app) => app.work());
  }

  /** Comes once the picture is that of the drawing as it is. */
  async made() {
    while (this.isMaking && this.isRunning) await new Promise((wake) => setTimeout(wake, SLICE_MS));
  }

  /** What was done to the drawing, as keys of messages, and in which colours, in turn; and how many of these steps are not taken back. */
  history() {
    return this.#call((app) => app.history());
  }

  /** A small picture of the drawing; nothing once the module has stopped. */
  thumbnail() {
    return this.#call((app) => app.thumbnail());
  }

  /**
   * The picture of the drawing as it is; nothing once the module has stopped.
   * @param {number} size_px pixels on its longer side
   * @param {boolean} lines
   */
  export(size_px, lines) {
    return this.#call((app) => app.export(size_px, lines));
  }

  /** @param {(app: App) => unknown[]} call */
  #enter(call) {
    const effects = this.#call(call) ?? [];
    for (let i = 0; i < effects.length; i += 2) {
      this.#handlers[String(effects[i])]?.(effects[i + 1]);
    }
  }

  /**
   * @template T
   * @param {(app: App) => T} call
   */
  #call(call) {
    try {
      return this.#app && call(this.#app);
    } catch (fault) {
      console.error(fault);
      // A plain error is the module's own word for what it does not take, and leaves it sound; of a panic, of a stack or a
      // memory that is at its end the browser tells by errors of other kinds.
      if (/** @type {Error} */ (fault)?.constructor !== Error) this.#stop();
      return undefined;
    }
  }

  #askFrame() {
    if (this.#frameAsked) return;
    this.#frameAsked = true;
    requestAnimationFrame(() => {
      this.#frameAsked = false;
      this.#enter((app) => app.frame());
      // Not in the frame: each may take its time.
      if (this.isMaking) setTimeout(() => this.#goOn((app) => app.makeOn()));
    });
  }

  /**
   * A canvas whose device is gone serves no more: a new one goes to the renderer that is named.
   * @param {Renderer | null} renderer
   */
  async #recover(renderer) {
    if (!renderer) return this.#handlers["no-renderer"]?.(undefined);
    const canvas = this.#freshCanvas();
    // The module has no renderer but its own build's: that of the other build paints for it.
    const painter = renderer === this.#build || renderer === "cpu" ? undefined : await this.#beside(renderer, canvas);
    this.command("canvas", { canvas, renderer, painter });
  }

  /**
   * A painter of another build on a canvas, if it can be had soon.
   * @param {Renderer} renderer
   * @param {HTMLCanvasElement} canvas
   */
  async #beside(renderer, canvas) {
    const lost = () => requestAnimationFrame(() => canvas.isConnected && this.command("lost"));
    const late = new Promise((_, reject) => setTimeout(reject, PATIENCE_MS, new Error("it does not come")));
    const made = load(renderer).then(({ Beside }) => Beside.create(canvas, lost));
    try {
      return await Promise.race([made, late]);
    } catch (fault) {
      console.warn(`${renderer}:`, fault);
      made.then((painter) => painter.free()).catch(() => {});
      return undefined;
    }
  }

  /** Puts an untouched canvas in the place of the one in the page: a canvas takes one kind of context in its life. */
  #freshCanvas() {
    const canvas = /** @type {HTMLCanvasElement} */ (document.getElementById("canvas"));
    const fresh = /** @type {HTMLCanvasElement} */ (canvas.cloneNode());
    // WebGPU reports a lost device to the module; of a lost WebGL context only the canvas is told.
    fresh.addEventListener("webglcontextlost", () => {
      if (fresh.isConnected) this.command("lost");
    });
    const focused = document.activeElement === canvas;
    canvas.replaceWith(fresh);
    if (focused) fresh.focus();
    return fresh;
  }

  #stop() {
    if (!this.#app) return;
    this.#app = undefined;
    this.#handlers.stopped?.(this.#preparing > 0);
  }
}

/** The renderers to try, best first; the address may name the one to use. */
async function candidates() {
  const forced = new URLSearchParams(location.search).get("renderer");
  const renderer = RENDERERS.find((name) => name === forced);
  if (renderer) return [renderer];
  const gpu = /** @type {any} */ (navigator).gpu;
  const adapter = await gpu?.requestAdapter().catch(() => null);
  return adapter ? RENDERERS : RENDERERS.slice(1);
}

/** @type {Map<string, Promise<any>>} */
const builds = new Map();

/**
 * The build that has a renderer. Both have the painter on the CPU: it takes the one that is here already.
 * @param {Renderer} renderer
 */
function load(renderer) {
  const loaded = [...builds.keys()].pop();
  const build = renderer === "cpu" ? loaded ?? "webgpu" : renderer;
  const module = builds.get(build) ?? fetchBuild(build);
  builds.set(build, module);
  module.catch(() => builds.delete(build));
  return module;
}

/** @param {string} build */
async function fetchBuild(build) {
  const module = await import(new URL(`../pkg/${build}/scumble_web.js`, import.meta.url).href);
  await module.default();
  return module;
}
