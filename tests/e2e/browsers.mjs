/**
 * Starts the two browsers headless, with the switches that give them WebGPU (and Chromium WebGL 2) without a GPU, and
 * gives their pages one face: Playwright drives Chromium, Puppeteer drives Firefox over WebDriver BiDi.
 */
import { once } from "node:events";
import { readdir } from "node:fs/promises";
import { setTimeout } from "node:timers/promises";
import { chromium } from "playwright-core";
import puppeteer from "puppeteer-core";

const CHROMIUM_FLAGS = [
  "--no-sandbox",
  "--disable-quic",
  "--no-first-run",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
];

const WITH_EMULATED_GPU = [
  "--use-angle=swiftshader",
  "--enable-unsafe-swiftshader",
  "--enable-unsafe-webgpu",
  "--ignore-gpu-blocklist",
  "--enable-gpu",
  "--enable-features=Vulkan",
  "--use-vulkan=swiftshader",
];

/** As Chromium runs on a machine that has none: it lays the page together on the CPU too, which takes a quarter less time. */
const WITHOUT_GPU = ["--disable-gpu"];

/** The switches of Chromium. @param {boolean} hasGpu */
const chromiumArgs = (hasGpu) => [...CHROMIUM_FLAGS, ...(hasGpu ? WITH_EMULATED_GPU : WITHOUT_GPU)];

/** How Puppeteer starts each. @type {import("puppeteer-core").LaunchOptions} */
export const CHROMIUM = { browser: "chrome", executablePath: "/usr/bin/chromium", args: chromiumArgs(true) };
/** @type {import("puppeteer-core").LaunchOptions} */
const FIREFOX = {
  browser: "firefox",
  executablePath: "/usr/bin/firefox-esr",
  extraPrefsFirefox: { "dom.webgpu.enabled": true, "gfx.webgpu.ignore-blocklist": true },
};

/** The system's dialogs for files, which nobody can answer here, are left out: the page has other ways. */
const withoutDialogs = () => {
  Object.assign(window, { showOpenFilePicker: undefined, showSaveFilePicker: undefined });
};

/** What the page does at its next frame is done, and painted. */
export const PAINTED = "new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))";

/** The guide of the first visit has been seen, where a test does not say otherwise. */
const asSeen = () => {
  try {
    localStorage.setItem("scumble-first-steps", "yes");
  } catch {
    // The blank page keeps nothing.
  }
};

/** What draws without a graphics card takes its time on a busy machine. */
const PATIENCE_MS = 120_000;

const VIEWPORT = { width: 1200, height: 800 };

/**
 * @typedef {object} Tab one page of a browser
 * @property {(url: string) => Promise<unknown>} goto
 * @property {<T>(expression: string) => Promise<T>} evaluate
 * @property {(expression: string) => Promise<unknown>} waitFor until the expression is true in the page
 * @property {(role: string, name: string) => Promise<void>} click a control by its role and accessible name
 * @property {(list: string, option: string) => Promise<unknown>} choose an option, by its value, of a list, by its name
 * @property {{move(x: number, y: number): Promise<void>, down(): Promise<void>, up(): Promise<void>}} mouse
 * @property {(points: [number, number][]) => Promise<void>} swipe a finger goes down, through places of the window, and up
 * @property {(places: [number, number][][]) => Promise<void>} pinch fingers go down, through places of the window, and up
 * @property {(kind: "down" | "move" | "up", place: [number, number]) => Promise<unknown>} pen a pen, in Chromium
 * @property {(place?: [number, number]) => Promise<unknown>} palm a hand that rests at a place, in Chromium, or no longer
 * @property {(x_px: number, y_px: number) => Promise<void>} wheel
 * @property {(key: string) => Promise<void>} press
 * @property {(key: string, act: () => Promise<void>) => Promise<void>} hold a key down during an act
 * @property {(files: string[], button?: string) => Promise<void>} chooseFiles what the user picks in the file dialog of "Open", or of another button
 * @property {(clip?: {x: number, y: number, width: number, height: number}) => Promise<Uint8Array>} screenshot PNG
 * @property {(act: () => Promise<void>) => Promise<string>} download the path of the file that an act downloads
 * @property {string[]} faults what went wrong in the page: uncaught errors and errors on the console
 * @property {(see: (url: string) => void) => void} onRequest
 * @property {(script: string) => Promise<unknown>} prepare runs a script in each page that is opened from now on, before its own
 * @property {(width_px: number, height_px: number) => Promise<unknown>} resize its window
 * @property {(bytes: number) => Promise<unknown>} limitStorage
 * @property {() => Promise<void>} toFront
 * @property {() => Promise<Tab>} beside another page with the same history
 * @property {() => Promise<void>} close
 */

/**
 * @typedef {object} Browser
 * @property {(options?: {isFirst?: boolean, isDark?: boolean, isForced?: boolean}) => Promise<Tab>} open a page without a history; `isFirst` leaves it to it that nobody was there, in Chromium `isDark` is the theme and `isForced` has the system's colours
 * @property {() => Promise<void>} close
 */

/**
 * @typedef {object} Mortal a browser with one page, whose history is in a folder
 * @property {Tab} tab
 * @property {() => Promise<void>} kill ends it as a crash would, unless it has ended
 */

/** @typedef {{hasGpu?: boolean}} Graphics whether a browser is to believe that there is a GPU; Firefox always does */

/**
 * @param {"chromium" | "firefox"} name
 * @param {Graphics} [graphics]
 * @returns {Promise<Browser>}
 */
export function launch(name, { hasGpu = false } = {}) {
  return name === "chromium" ? launchChromium(hasGpu) : launchFirefox();
}

/**
 * @param {boolean} hasGpu
 * @returns {Promise<Browser>}
 */
async function launchChromium(hasGpu) {
  const browser = await chromium.launch({
    executablePath: "/usr/bin/chromium",
    args: chromiumArgs(hasGpu),
    timeout: PATIENCE_MS,
  });
  return {
    open: async ({ isFirst = false, isDark = false, isForced = false } = {}) => {
      const colorScheme = isDark ? "dark" : "light";
      const forcedColors = isForced ? "active" : "none";
      const page = await (await browser.newContext({ viewport: VIEWPORT, colorScheme, forcedColors })).newPage();
      if (!isFirst) await page.addInitScript(asSeen);
      return chromiumTab(page);
    },
    close: () => browser.close(),
  };
}

/**
 * @param {import("playwright-core").Page} page
 * @returns {Promise<Tab>}
 */
async function chromiumTab(page) {
  page.setDefaultTimeout(PATIENCE_MS);
  await page.addInitScript(withoutDialogs);
  /** @type {string[]} */
  const faults = [];
  page.on("pageerror", (error) => faults.push(String(error)));
  page.on("console", (message) => void (message.type() === "error" && faults.push(message.text())));
  /** A touch ends where it began. @type {Promise<import("playwright-core").CDPSession> | undefined} */
  let resting;
  return {
    faults,
    goto: (url) => page.goto(url),
    evaluate: (expression) => page.evaluate(expression),
    waitFor: (expression) => page.waitForFunction(expression),
    click: (role, name) => page.getByRole(/** @type {any} */ (role), { name, exact: true }).click(),
    choose: (list, option) => page.getByRole("combobox", { name: list, exact: true }).selectOption(option),
    mouse: page.mouse,
    swipe: (places) => touch(page, places.map((place) => [place])),
    pinch: (places) => touch(page, places),
    pen: (kind, [x, y]) => pen(page, kind, x, y),
    palm: async (place) => {
      const devtools = await (resting ??= page.context().newCDPSession(page));
      const touchPoints = place ? [{ x: place[0], y: place[1] }] : [];
      await devtools.send("Input.dispatchTouchEvent", { type: place ? "touchStart" : "touchEnd", touchPoints });
    },
    wheel: (x_px, y_px) => page.mouse.wheel(x_px, y_px),
    press: (key) => page.keyboard.press(key),
    hold: async (key, act) => {
      await page.keyboard.down(key);
      await act();
      await page.keyboard.up(key);
    },
    chooseFiles: async (files, button = "Open") => {
      const chooser = page.waitForEvent("filechooser");
      await page.getByRole("button", { name: button, exact: true }).click();
      await (await chooser).setFiles(files);
    },
    screenshot: (clip) => page.screenshot({ clip }),
    download: async (act) => {
      const download = page.waitForEvent("download");
      await act();
      return (await download).path();
    },
    onRequest: (see) => void page.on("request", (request) => see(request.url())),
    prepare: (script) => page.addInitScript(script),
    resize: async (width_px, height_px) => {
      await page.setViewportSize({ width: width_px, height: height_px });
      await page.evaluate(PAINTED);
    },
    limitStorage: async (bytes) => {
      const devtools = await page.context().newCDPSession(page);
      await devtools.send("Storage.overrideQuotaForOrigin", { origin: new URL(page.url()).origin, quotaSize: bytes });
    },
    toFront: () => page.bringToFront(),
    beside: async () => chromiumTab(await page.context().newPage()),
    close: () => page.close(),
  };
}

/**
 * Fingers go down, through places, and up.
 * @param {import("playwright-core").Page} page
 * @param {[number, number][][]} places of all fingers, one moment after the other
 */
async function touch(page, [first, ...rest]) {
  const devtools = await page.context().newCDPSession(page);
  const send = (/** @type {"touchStart" | "touchMove" | "touchEnd"} */ type, /** @type {[number, number][]} */ fingers) =>
    devtools.send("Input.dispatchTouchEvent", { type, touchPoints: fingers.map(([x, y], id) => ({ x, y, id })) });
  await send("touchStart", first);
  for (const fingers of rest) await send("touchMove", fingers);
  await send("touchEnd", []);
}

/**
 * @param {import("playwright-core").Page} page
 * @param {"down" | "move" | "up"} kind
 * @param {number} x
 * @param {number} y
 */
async function pen(page, kind, x, y) {
  const devtools = await page.context().newCDPSession(page);
  const type = /** @type {const} */ ({ down: "mousePressed", move: "mouseMoved", up: "mouseReleased" })[kind];
  await devtools.send("Input.dispatchMouseEvent", { type, x, y, button: "left", buttons: 1, clickCount: 1, force: 0.5, pointerType: "pen" });
}

/** @returns {Promise<Browser>} */
async function launchFirefox() {
  const browser = await puppeteer.launch({ ...FIREFOX, defaultViewport: VIEWPORT, timeout: PATIENCE_MS });
  return {
    open: async ({ isFirst = false } = {}) => {
      const page = await (await browser.createBrowserContext()).newPage();
      if (!isFirst) await page.evaluateOnNewDocument(asSeen);
      return puppeteerTab(page);
    },
    close: () => browser.close(),
  };
}

/**
 * A browser of its own, whose pages leave their history in a folder.
 * @param {"chromium" | "firefox"} name
 * @param {string} folder
 * @returns {Promise<Mortal>}
 */
export async function launchIn(name, folder) {
  const browser = await puppeteer.launch({
    ...(name === "chromium" ? CHROMIUM : FIREFOX),
    userDataDir: folder,
    defaultViewport: VIEWPORT,
    timeout: PATIENCE_MS,
  });
  const page = await browser.newPage();
  await page.evaluateOnNewDocument(asSeen);
  const process = /** @type {import("node:child_process").ChildProcess} */ (browser.process());
  return {
    tab: puppeteerTab(page),
    kill: async () => {
      const gone = once(process, "exit");
      if (process.kill("SIGKILL")) await gone;
      await areBack(folder);
    },
  };
}

/** Waits until Puppeteer has put the settings back that it found in a folder. @param {string} folder */
async function areBack(folder) {
  for (let tries = 0; tries < 100; tries++) {
    if (!(await readdir(folder)).some((file) => file.endsWith(".puppeteer"))) return;
    await setTimeout(20);
  }
}

/**
 * A control that is shown, by its role and name: of the elements of the page alone, as Firefox takes seconds for each that it
 * looks up as assistive technology would. Playwright does that in Chromium.
 * @param {import("puppeteer-core").Page} page
 * @param {string} role
 * @param {string} name
 * @returns {import("puppeteer-core").Locator<HTMLSelectElement>}
 */
function control(page, role, name) {
  const own = { button: "button", checkbox: "input[type=checkbox]", combobox: "select", radio: "input[type=radio]" }[role];
  const selector = JSON.stringify([`[role=${role}]`, own].filter(Boolean).join());
  const find = `[...document.querySelectorAll(${selector})].find((element) => element.checkVisibility() &&
    (element.ariaLabel ?? element.labels?.[0]?.textContent ?? element.textContent).trim() === ${JSON.stringify(name)})`;
  return page.locator(/** @type {() => HTMLSelectElement} */ (new Function(`return ${find}`)));
}

/**
 * Waits until an expression is true. Puppeteer's own way is now and then never told where the page is loaded anew meanwhile.
 * @param {import("puppeteer-core").Page} page
 * @param {string} expression
 */
async function waitFor(page, expression) {
  const end_ms = Date.now() + PATIENCE_MS;
  /** @type {unknown} */
  let answer;
  while (Date.now() < end_ms) {
    // A page that is going, or has not come yet, has faults.
    answer = await page.evaluate(`Boolean(${expression})`).catch((fault) => fault);
    if (answer === true) return;
    await setTimeout(20);
  }
  throw new Error(`waited in vain for ${expression}`, { cause: answer });
}

/**
 * @param {import("puppeteer-core").Page} page
 * @returns {Tab}
 */
function puppeteerTab(page) {
  page.setDefaultTimeout(PATIENCE_MS);
  /** @type {string[]} */
  const faults = [];
  page.on("pageerror", (error) => faults.push(String(error)));
  page.on("console", (message) => void (message.type() === "error" && faults.push(message.text())));
  return {
    faults,
    goto: (url) => page.goto(url),
    evaluate: (expression) => /** @type {Promise<any>} */ (page.evaluate(expression)),
    waitFor: (expression) => waitFor(page, expression),
    click: (role, name) => control(page, role, name).click(),
    choose: async (list, option) => (await control(page, "combobox", list).waitHandle()).select(option),
    mouse: page.mouse,
    swipe: async ([first, ...rest]) => {
      await page.touchscreen.touchStart(...first);
      for (const place of rest) await page.touchscreen.touchMove(...place);
      await page.touchscreen.touchEnd();
    },
    pinch: async ([first, ...rest]) => {
      const fingers = [];
      for (const place of first) fingers.push(await page.touchscreen.touchStart(...place));
      for (const places of rest) {
        for (const [i, finger] of fingers.entries()) await finger.move(...places[i]);
      }
      for (const finger of fingers) await finger.end();
    },
    pen: async () => {
      throw new Error("pens are tested in Chromium");
    },
    palm: async () => {
      throw new Error("pens are tested in Chromium");
    },
    wheel: (x_px, y_px) => page.mouse.wheel({ deltaX: x_px, deltaY: y_px }),
    press: (key) => page.keyboard.press(/** @type {any} */ (key)),
    hold: async (key, act) => {
      await page.keyboard.down(/** @type {any} */ (key));
      await act();
      await page.keyboard.up(/** @type {any} */ (key));
    },
    chooseFiles: async (files) => {
      const input = await page.$('input[type="file"]');
      await /** @type {import("puppeteer-core").ElementHandle<HTMLInputElement>} */ (input).uploadFile(...files);
    },
    screenshot: (clip) => page.screenshot({ clip }),
    download: async () => {
      throw new Error("downloads are tested in Chromium");
    },
    onRequest: (see) => void page.on("request", (request) => see(request.url())),
    prepare: (script) => page.evaluateOnNewDocument(script),
    resize: async (width_px, height_px) => {
      await page.setViewport({ width: width_px, height: height_px });
      await page.evaluate(PAINTED);
    },
    limitStorage: async () => {
      throw new Error("storage is limited in Chromium");
    },
    toFront: () => page.bringToFront(),
    beside: async () => puppeteerTab(await page.browserContext().newPage()),
    close: () => page.close(),
  };
}
