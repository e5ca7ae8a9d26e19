// Toolbars as one stop of Tab each, after the ARIA authoring practices: arrow keys, Home and End go from one control to
// the next. What has come down from a button of the bar is a stop of its own while it is open.

/** Controls of a bar: they lie in it, and may come and go. */
const CONTROLS = "button, input";

/** How far each key goes. @type {Record<string, number>} */
const STEPS = { ArrowLeft: -1, ArrowUp: -1, ArrowRight: 1, ArrowDown: 1, Home: -Infinity, End: Infinity };

/** @param {HTMLElement} bar */
export function connectBar(bar) {
  const panels = /** @type {HTMLElement[]} */ ([...bar.querySelectorAll("[popover]")]);
  const settle = () => [bar, ...panels].forEach((part) => stopAt(part, current(part)));
  bar.addEventListener("focusin", ({ target }) => {
    const control = /** @type {HTMLElement} */ (target);
    stopAt(partOf(control), control);
  });
  bar.addEventListener("keydown", go);
  for (const panel of panels) panel.addEventListener("toggle", settle);
  // The control that is the stop may be disabled, or hidden in a narrower window.
  new MutationObserver(settle).observe(bar, { subtree: true, attributeFilter: ["disabled", "hidden"] });
  new ResizeObserver(settle).observe(/** @type {HTMLElement} */ (bar.parentElement));
  settle();
}

/**
 * Home and End for radio buttons, which have the rest by themselves.
 * @param {HTMLElement} bar
 */
export function connectRadios(bar) {
  bar.addEventListener("keydown", (event) => {
    if (event.key !== "Home" && event.key !== "End") return;
    event.preventDefault();
    const radios = bar.querySelectorAll("input");
    const radio = radios[event.key === "Home" ? 0 : radios.length - 1];
    radio.focus();
    radio.click();
  });
}

/** @param {KeyboardEvent} event */
function go(event) {
  const step = STEPS[event.key];
  if (step === undefined || event.ctrlKey || event.metaKey || event.altKey || event.shiftKey) return;
  event.preventDefault();
  const from = /** @type {HTMLElement} */ (event.target);
  const controls = usable(partOf(from));
  const to = controls.indexOf(from) + step;
  // One after the last is the first; the ends are ends.
  const place = Number.isFinite(to) ? (to + controls.length) % controls.length : step < 0 ? 0 : controls.length - 1;
  controls[place]?.focus();
}

/**
 * What a control's stop is: the panel that it lies in, where that comes down from a button, or else what that lies in.
 * @param {HTMLElement} control
 * @returns {HTMLElement}
 */
function partOf(control) {
  const panel = /** @type {HTMLElement | null} */ (control.closest("[popover], [role=toolbar]"));
  if (!panel?.hasAttribute("popover")) return /** @type {HTMLElement} */ (panel);
  const isApart = panel.matches(":popover-open") || !panel.checkVisibility();
  return isApart ? panel : partOf(/** @type {HTMLElement} */ (panel.parentElement));
}

/** @param {HTMLElement} part */
function controlsOf(part) {
  const controls = /** @type {NodeListOf<HTMLButtonElement | HTMLInputElement>} */ (part.querySelectorAll(CONTROLS));
  return [...controls].filter((control) => partOf(control) === part);
}

/** The controls that can be used, those of a panel once it is open. @param {HTMLElement} part @returns {HTMLElement[]} */
function usable(part) {
  const isClosed = part.hasAttribute("popover") && !part.checkVisibility();
  return controlsOf(part).filter((control) => !control.disabled && (isClosed || control.checkVisibility()));
}

/** The control that Tab comes to, as far as it can be used. @param {HTMLElement} part */
function current(part) {
  const controls = usable(part);
  return controls.find((control) => control.tabIndex === 0) ?? controls[0];
}

/**
 * @param {HTMLElement} part
 * @param {HTMLElement | undefined} stop
 */
function stopAt(part, stop) {
  for (const control of controlsOf(part)) control.tabIndex = control === stop ? 0 : -1;
}
