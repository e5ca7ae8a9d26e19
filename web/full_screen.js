// The whole screen for the page, where the browser gives it.

import { say } from "./messages.js";
import { done } from "./toolbar.js";

const button = /** @type {HTMLButtonElement} */ (document.querySelector('[data-action="full-screen"]'));

export function connectFullScreen() {
  button.hidden = !document.fullscreenEnabled;
  show();
  document.addEventListener("fullscreenchange", () => {
    show();
    done(say(`full-screen-${isFull() ? "on" : "off"}`));
  });
}

export async function turnFullScreen() {
  try {
    if (isFull()) await document.exitFullscreen();
    else await document.documentElement.requestFullscreen();
  } catch (fault) {
    console.warn(fault);
    done(say("full-screen-not"));
  }
}

function isFull() {
  return document.fullscreenElement !== null;
}

function show() {
  button.setAttribute("aria-pressed", String(isFull()));
}
