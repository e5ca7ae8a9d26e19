// The controls around the canvas. They show what the module says and ask it for changes; they keep no state.

import { label, name, say } from "./messages.js";

const control = (/** @type {string} */ id) => /** @type {HTMLElement} */ (document.getElementById(id));
const input = (/** @type {string} */ id) => /** @type {HTMLInputElement} */ (control(id));
const buttonOf = (/** @type {string} */ action) =>
  /** @type {HTMLButtonElement} */ (document.querySelector(`[data-action="${action}"]`));
const settingOf = (/** @type {string} */ setting) =>
  /** @type {HTMLInputElement} */ (document.querySelector(`[data-setting="${setting}"]`));

/** Settings in percent, with where their figures stand. */
const FIGURES = [["gap-closing", "gap-figure"], ["strength", "strength-figure"], ["tracing-opacity", "tracing-figure"]];

/**
 * @param {(action: string) => void} act for a button
 * @param {(command: string, args?: unknown) => void} set for a value
 */
export function connect(act, set) {
  document.addEventListener("mousedown", keepFocus);
  // Before what is chosen there is done, so that the focus comes back to what is still to be seen.
  control("files").addEventListener("click", () => control("files").togglePopover(false), true);
  for (const button of /** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll("[data-action]"))) {
    button.addEventListener("click", () => act(button.dataset.action ?? ""));
  }
  for (const radio of radios()) radio.addEventListener("change", () => set(radio.name, radio.value));
  for (const setting of ["lines", "scribbles", "result", "regions", "spread", "crosses"]) {
    settingOf(setting).addEventListener("change", () => set(setting, settingOf(setting).checked));
  }
  for (const setting of ["engine", "solver", "blend", "pressure"]) {
    settingOf(setting).addEventListener("change", () => set(setting, settingOf(setting).value));
  }
  for (const [setting] of FIGURES) connectSlider(settingOf(setting), set);
  input("brush-size").addEventListener("input", () => set("brush-size", input("brush-size").valueAsNumber));
  settled(input("brush-size"), set);
}

/**
 * A slider sets its setting, in percent, while it is dragged. All of that is one gesture until it is let go, which is
 * told even where it has come back to the value that it had, and no change is reported.
 * @param {HTMLInputElement} slider
 * @param {(command: string, args?: unknown) => void} set
 */
function connectSlider(slider, set) {
  slider.addEventListener("input", () => set(slider.dataset.setting ?? "", slider.valueAsNumber / 100));
  settled(slider, set);
}

/**
 * @param {HTMLInputElement} slider
 * @param {(command: string, args?: unknown) => void} set
 */
function settled(slider, set) {
  for (const kind of ["change", "pointerup", "blur"]) slider.addEventListener(kind, () => set("settle"));
}

/** The zoom as it was shown last: 1 where a drawing unit is a CSS pixel. */
let zoomShown = 1;

/** How the page was turned last. */
let turnShown = { degrees: 0, mirrored: false };

/** Says in the language of the page what the controls are, and what they are at. */
export function labelControls() {
  label(document);
  shown.zoom(zoomShown);
  shown.turn(turnShown);
  for (const [setting, figure] of FIGURES) showPercent(settingOf(setting), control(figure), settingOf(setting).valueAsNumber);
}

/** The radio buttons of the tools, and of what a scribble does. */
function radios() {
  return /** @type {NodeListOf<HTMLInputElement>} */ (document.querySelectorAll("aside input[type=radio]"));
}

/**
 * @param {string} group
 * @param {string} value
 */
function check(group, value) {
  for (const radio of radios()) if (radio.name === group) radio.checked = radio.value === value;
}

/**
 * A button pressed with the mouse leaves the focus where it is: on the canvas, where Space is the hand. One that opens
 * a panel takes it, as the panel follows it for those who go on by keys; so do those of colours, which have fields.
 * @param {MouseEvent} event
 */
function keepFocus(event) {
  if (event.target instanceof Element && event.target.closest(":is(button:not([popovertarget], .colors *), .tool, .kind, .toggle):not(dialog *)")) event.preventDefault();
}

/** From the first pen on there is a choice. @param {boolean} fingersDraw */
export function showFingers(fingersDraw) {
  const button = buttonOf("fingers");
  button.hidden = false;
  button.setAttribute("aria-pressed", String(fingersDraw));
}

export function areLinesShown() {
  return settingOf("lines").checked;
}

/** Shows or hides one of the layers. @param {string} layer */
export function toggle(layer) {
  settingOf(layer).click();
}

/** What effects do to the controls. */
export const shown = {
  /** @param {string} name */
  tool(name) {
    check("tool", name);
    control("erasing").hidden = name !== "erase";
  },
  /** @param {string} name what the eraser takes */
  erasing(name) {
    check("erasing", name);
  },
  /** @param {{kind: string, strength: number, crosses: boolean, pressure: string, largest: number}} mode */
  mode({ kind, strength, crosses, pressure, largest }) {
    check("kind", kind);
    control("shading").hidden = control("tones").hidden = kind !== "shade";
    input("brush-size").max = String(largest);
    showPercent(settingOf("strength"), control("strength-figure"), Math.round(strength * 100));
    settingOf("crosses").checked = crosses;
    settingOf("pressure").value = pressure;
  },
  /** @param {number} size_du */
  "brush-size"(size_du) {
    input("brush-size").value = String(size_du);
  },
  /** @param {boolean} possible */
  undo(possible) {
    buttonOf("undo").disabled = !possible;
  },
  /** @param {boolean} possible */
  redo(possible) {
    buttonOf("redo").disabled = !possible;
  },
  /** @param {boolean} on */
  lines(on) {
    settingOf("lines").checked = on;
  },
  /** @param {boolean} on */
  scribbles(on) {
    settingOf("scribbles").checked = on;
  },
  /** @param {boolean} on */
  result(on) {
    settingOf("result").checked = on;
  },
  /** @param {boolean} on */
  regions(on) {
    settingOf("regions").checked = on;
  },
  /** @param {{blend: string, engine: string, gapClosing: number, spread: boolean}} settings of the drawing */
  settings({ blend, engine, gapClosing, spread }) {
    settingOf("blend").value = blend;
    settingOf("engine").value = engine;
    settingOf("spread").checked = spread;
    showPercent(settingOf("gap-closing"), control("gap-figure"), Math.round(gapClosing * 100));
    // The other engine does not spread.
    settingOf("spread").disabled = engine !== "global";
  },
  /** @param {{image?: number, opacity?: number}} state which picture is under the lines, if any, and its opacity */
  tracing({ image, opacity = 0 }) {
    control("tracing-button").hidden = image === undefined;
    if (image === undefined) control("tracing").hidePopover();
    showPercent(settingOf("tracing-opacity"), control("tracing-figure"), Math.round(opacity * 100));
  },
  /** @param {{asked: string}} state which solver is to make the picture */
  solver({ asked }) {
    settingOf("solver").value = asked;
  },
  /** @param {number} zoom 1 where a drawing unit is a CSS pixel */
  zoom(zoom) {
    zoomShown = zoom;
    const percent = Math.round(zoom * 100);
    control("zoom").textContent = say("percent", { percent });
    name(control("zoom"), say("zoom", { percent }));
  },
  /** @param {{degrees: number, mirrored: boolean}} turn how the page lies on the canvas */
  turn(turn) {
    turnShown = turn;
    const degrees = Math.round(turn.degrees);
    control("rotated").textContent = say("degrees", { degrees });
    name(control("rotated"), say("rotated", { degrees }));
    buttonOf("mirror").setAttribute("aria-pressed", String(turn.mirrored));
    control("rotation-button").classList.toggle("on", turn.mirrored || turn.degrees !== 0);
  },
};

/**
 * @param {HTMLInputElement} slider
 * @param {HTMLElement} figure
 * @param {number} percent
 */
function showPercent(slider, figure, percent) {
  const text = say("percent", { percent });
  slider.value = String(percent);
  slider.setAttribute("aria-valuetext", text);
  figure.textContent = text;
}

/**
 * @param {string} drawing what it is called
 * @param {boolean} unsaved
 * @param {boolean} kept whether the browser has it as it is, for those who look at the page from outside
 */
export function showName(drawing, unsaved, kept) {
  document.title = say("title", { name: drawing, unsaved });
  control("drawing").textContent = drawing;
  control("drawing").dataset.kept = String(kept);
  control("unsaved").hidden = !unsaved;
}

/** How often something was said. */
export let told = 0;

/** @param {string} text what just happened */
export function tell(text) {
  told++;
  control("status").textContent = text;
}

/** @param {string} text what went wrong; empty to put it away. Counts in it get marks between their thousands, places as 1:4712 do not */
export function warn(text) {
  const figure = (/** @type {string} */ digits) => Number(digits).toLocaleString(document.documentElement.lang);
  const alert = control("alert");
  alert.hidden = text === "";
  // Above all panels, also those that were opened after the last one.
  alert.togglePopover(false);
  alert.togglePopover(!alert.hidden);
  /** @type {HTMLElement} */ (alert.querySelector("p")).textContent = text.replace(/(?<=\s)\d{4,}(?=\s)/g, figure);
}

/** Says what was done; a warning about something before it has had its time. @param {string} text */
export function done(text) {
  warn("");
  tell(text);
}

/** @param {unknown} fault with a sentence for people */
export function failed(fault) {
  warn(say("failed", { sentence: /** @type {Error} */ (fault).message }));
}

/** Says what the browser cannot keep, if there is anything. @param {import("./keeper.js").Failing} fails */
export function showUnkept(fails) {
  control("unkept").hidden = fails === "";
  /** @type {HTMLElement} */ (control("unkept").querySelector("p")).textContent = fails && say(`unkept-${fails}`);
}

/** @param {boolean} isReady whether the page has another version to go on with */
export function showUpdate(isReady) {
  control("update").hidden = !isReady;
}
