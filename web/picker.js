// A picker of colours: sliders over what they give, the colour in hexadecimal digits, and colours that go with it. It is
// fetched with the panels of colours; the module has the arithmetic.

import { button } from "./buttons.js";
import { make } from "./elements.js";
import { Square } from "./square.js";

/** @typedef {import("./colors.js").Shell} Shell */
/** @typedef {{key: string, most: number, scale: number}} Dial a number of a model: what a slider says times its scale */

/** The sliders of each model. Chroma goes as far as any colour of sRGB does. @type {Record<string, Dial[]>} */
const MODELS = {
  oklch: [
    { key: "lightness", most: 100, scale: 0.01 },
    { key: "chroma", most: 330, scale: 0.001 },
    { key: "hue", most: 360, scale: 1 },
  ],
  hsv: [
    { key: "hue", most: 360, scale: 1 },
    { key: "saturation", most: 100, scale: 0.01 },
    { key: "value", most: 100, scale: 0.01 },
  ],
};

/** Places along a slider at which its colours are asked for. */
const PLACES = 32;

/** Steps of lightness from a colour, and degrees of hue. */
const SHADES = [0.2, 0.1, 0, -0.1, -0.2];
const HARMONIES = /** @type {[string, number][]} */ ([
  ["complementary", 180],
  ["analogous", -30],
  ["analogous", 30],
  ["triadic", -120],
  ["triadic", 120],
]);

/** Of white and black all shades were the same: they stay away from both. */
const LIGHTNESS = { least: 0.08, most: 0.98 };

const OUTSIDE = 1 << 24;

/** Which model was used last. */
let lastModel = "oklch";

/** How many pickers there are: the controls of each have names of their own. */
let pickers = 0;

export class Picker {
  #shell;
  #change;
  #settle;
  #number = pickers++;
  #model = lastModel;
  /** @type {number[]} Of the model. */
  #numbers = [0, 0, 0];
  /** #rrggbb, or what is none. */
  #color = "";
  /** The last one that was a colour. */
  #solid = "#000000";
  /** A key is down, of whose repeats each reports a change. */
  #isHeld = false;
  /** @type {HTMLInputElement[]} */
  #sliders = [];
  #dials = make("div", { className: "picker" });
  /** Of saturation and value, where there are these. */
  #square;
  #hex = make("input", { type: "text", spellcheck: false, autocomplete: "off", maxLength: 9 });
  #before = make("button", { type: "button", className: "swatch" });
  #now = make("span", {});
  #shades = make("ul", { role: "list" });
  #harmonies = make("ul", { role: "list" });
  /** What is shown. */
  element;

  /**
   * @param {Shell} shell
   * @param {(color: string) => void} change called with each colour, also on the way
   * @param {() => void} settle called when a colour stays
   */
  constructor(shell, change, settle) {
    this.#shell = shell;
    this.#change = change;
    this.#settle = settle;
    const go = (/** @type {number} */ x, /** @type {number} */ y) => this.#turn([this.#numbers[0], x, y]);
    this.#square = new Square(shell.say("square"), shell.say("two-dimensional"), go, () => this.#settle());
    this.#hex.ariaLabel = shell.say("hex");
    this.#hex.addEventListener("input", () => this.#judge());
    this.#hex.addEventListener("change", () => this.#enter());
    this.#before.addEventListener("click", () => this.#pick(this.#before.dataset.color ?? ""));
    this.element = make("div", { className: "picker" }, this.#head(), this.#models(), this.#dials);
    this.element.append(this.#strip("shades", this.#shades), this.#strip("harmonies", this.#harmonies));
    this.#build();
  }

  /** Begins with a colour, to which one can go back. @param {string} color #rrggbb, or what is none */
  begin(color) {
    this.show(color);
    this.#before.style.setProperty("--swatch", this.#solid);
    this.#before.dataset.color = this.#solid;
    this.#before.ariaLabel = this.#before.title = `${this.#shell.say("colour-before")} ${this.#solid}`;
  }

  /** Shows a colour; the one that it has given itself stays as it was turned. @param {string} color #rrggbb, or what is none */
  show(color) {
    if (color === this.#color) return;
    this.#color = color;
    if (color.startsWith("#")) this.#read(color);
    this.#render();
  }

  #head() {
    const line = make("div", { className: "line" }, make("div", { className: "pair" }, this.#before, this.#now), this.#hex);
    const EyeDropper = /** @type {any} */ (window).EyeDropper;
    if (EyeDropper) {
      const take = (/** @type {{sRGBHex: string}} */ { sRGBHex }) => this.#pick(parsed(sRGBHex) ?? this.#solid);
      // Who presses Escape has thought otherwise.
      line.append(button(this.#shell.say("eyedropper"), () => void new EyeDropper().open().then(take, () => undefined), "pick"));
    }
    return line;
  }

  #models() {
    const radios = Object.keys(MODELS).map((model) => {
      const radio = make("input", { type: "radio", name: `model-${this.#number}`, checked: model === this.#model });
      radio.ariaLabel = this.#shell.say(model);
      radio.addEventListener("change", () => this.#choose(model));
      return make("label", { className: "kind" }, radio, make("span", {}, this.#shell.say(model)));
    });
    return make("div", { className: "kinds", role: "radiogroup", "aria-label": this.#shell.say("colour-model") }, ...radios);
  }

  /**
   * @param {string} key
   * @param {HTMLUListElement} list
   */
  #strip(key, list) {
    list.ariaLabel = this.#shell.say(key);
    return make("div", { className: "strip" }, make("span", {}, this.#shell.say(key)), list);
  }

  /** @param {string} model */
  #choose(model) {
    lastModel = this.#model = model;
    this.#numbers = this.#shell.numbers(model, this.#solid);
    this.#build();
    this.#render();
  }

  /** Makes the sliders of the model. */
  #build() {
    this.#sliders = [];
    this.#dials.replaceChildren(...MODELS[this.#model].map((dial, i) => this.#dial(dial, i)));
    if (this.#model === "hsv") this.#dials.prepend(this.#square.element);
  }

  /**
   * @param {Dial} dial
   * @param {number} i
   */
  #dial({ key, most, scale }, i) {
    const slider = make("input", { type: "range", min: "0", max: String(most), step: "1" });
    slider.addEventListener("input", () => this.#turn(this.#with(i, slider.valueAsNumber * scale)));
    slider.addEventListener("keydown", ({ key }) => (this.#isHeld = key !== "Tab"));
    slider.addEventListener("change", () => this.#isHeld || this.#settle());
    for (const kind of ["keyup", "pointerup", "blur"]) slider.addEventListener(kind, () => this.#release());
    this.#sliders.push(slider);
    slider.id = `dial-${key}-${this.#number}`;
    return make("div", { className: "dial" }, make("label", { htmlFor: slider.id }, this.#shell.say(key)), slider, make("output", {}));
  }

  #release() {
    this.#isHeld = false;
    this.#settle();
  }

  /** @param {string} color */
  #read(color) {
    const before = this.#numbers;
    this.#numbers = this.#shell.numbers(this.#model, color);
    this.#solid = color;
    const [hue, vividness] = this.#model === "oklch" ? [2, 1] : [0, 1];
    // Gray has no hue: it keeps the one that is set.
    if (this.#numbers[vividness] === 0) this.#numbers[hue] = before[hue];
  }

  /**
   * The numbers with another one among them.
   * @param {number} i
   * @param {number} number
   */
  #with(i, number) {
    return this.#numbers.map((before, j) => (i === j ? number : before));
  }

  /** @param {number[]} numbers */
  #turn(numbers) {
    this.#numbers = numbers;
    const [packed] = this.#shell.colors(this.#model, this.#numbers);
    this.#solid = hexOf(packed);
    this.#give(this.#solid);
  }

  /** Takes a colour at once. @param {string} color */
  #pick(color) {
    this.#read(color);
    this.#give(color);
    this.#settle();
  }

  /** @param {string} color */
  #give(color) {
    this.#color = color;
    this.#render();
    this.#change(color);
  }

  #judge() {
    const isFault = parsed(this.#hex.value) === undefined;
    this.#hex.ariaInvalid = String(isFault);
    this.#hex.title = isFault ? this.#shell.say("hex-fault") : "";
  }

  #enter() {
    const color = parsed(this.#hex.value);
    if (color) this.#pick(color);
    else this.#render();
  }

  #render() {
    this.element.style.setProperty("--swatch", this.#solid);
    this.#hex.value = this.#color.startsWith("#") ? this.#color : "";
    this.#hex.ariaInvalid = "false";
    for (const i of this.#sliders.keys()) this.#renderDial(i);
    if (this.#model === "hsv") this.#renderSquare();
    this.#renderStrips();
  }

  /** @param {number} i */
  #renderDial(i) {
    const { key, most, scale } = MODELS[this.#model][i];
    const slider = this.#sliders[i];
    slider.value = String(Math.round(this.#numbers[i] / scale));
    const places = Array.from({ length: PLACES + 1 }, (_, k) => (k / PLACES) * most * scale);
    const numbers = places.flatMap((place) => this.#with(i, place));
    slider.style.setProperty("--track", track(this.#shell.colors(this.#model, numbers)));
    const text = this.#written(key, this.#numbers[i]);
    const isOutside = (this.#shell.colors(this.#model, this.#numbers)[0] & OUTSIDE) !== 0;
    slider.setAttribute("aria-valuetext", isOutside ? this.#shell.say("not-srgb", { text }) : text);
    const output = /** @type {HTMLElement} */ (slider.closest(".dial")?.querySelector("output"));
    output.textContent = text;
  }

  #renderSquare() {
    const [hue, saturation, value] = this.#numbers;
    const text = ["saturation", "value"].map((key, i) => `${this.#shell.say(key)} ${this.#written(key, [saturation, value][i])}`);
    this.#square.show(saturation, value, text.join(", "));
    this.#square.element.style.setProperty("--pure", hexOf(this.#shell.colors("hsv", [hue, 1, 1])[0]));
  }

  /**
   * @param {string} key
   * @param {number} number
   */
  #written(key, number) {
    if (key === "hue") return this.#shell.say("degrees", { degrees: Math.round(number) });
    if (key !== "chroma") return this.#shell.say("percent", { percent: Math.round(100 * number) });
    return number.toLocaleString(document.documentElement.lang, { minimumFractionDigits: 3, maximumFractionDigits: 3 });
  }

  #renderStrips() {
    const [lightness, chroma, hue] = this.#shell.numbers("oklch", this.#solid);
    const light = (/** @type {number} */ step) => Math.min(Math.max(lightness + step, LIGHTNESS.least), LIGHTNESS.most);
    const shades = this.#shell.colors("oklch", SHADES.flatMap((step) => [light(step), chroma, hue]));
    const turned = this.#shell.colors("oklch", HARMONIES.flatMap(([, angle]) => [lightness, chroma, hue + angle]));
    this.#fill(this.#shades, shades, () => "shade");
    this.#fill(this.#harmonies, turned, (i) => HARMONIES[i][0]);
  }

  /**
   * Keeps the buttons that are there, one of which may have the focus.
   * @param {HTMLUListElement} list
   * @param {Uint32Array} colors
   * @param {(i: number) => string} key what each is called
   */
  #fill(list, colors, key) {
    for (const [i, packed] of colors.entries()) {
      const color = hexOf(packed);
      const swatch = list.children[i]?.querySelector("button") ?? this.#preset(list);
      swatch.dataset.color = color;
      swatch.style.setProperty("--swatch", color);
      swatch.ariaLabel = swatch.title = this.#shell.say(key(i), { color });
    }
  }

  /** @param {HTMLUListElement} list */
  #preset(list) {
    const swatch = make("button", { type: "button", className: "swatch" });
    swatch.addEventListener("click", () => this.#pick(swatch.dataset.color ?? this.#solid));
    list.append(make("li", {}, swatch));
    return swatch;
  }
}

/** @param {number} packed 0xrrggbb, with a flag */
function hexOf(packed) {
  return `#${(packed & 0xffffff).toString(16).padStart(6, "0")}`;
}

/** The colour of three or six digits, as #rrggbb. @param {string} text */
function parsed(text) {
  const digits = /^#?([\da-f]{6}|[\da-f]{3})$/i.exec(text.trim())?.[1].toLowerCase();
  return digits && `#${digits.length === 3 ? digits.replace(/./g, "$&$&") : digits}`;
}

/**
 * What a slider's track shows: the colours that it gives, as a thin line where they are not in sRGB. The middle of the
 * thumb goes over it from end to end.
 * @param {Uint32Array} colors
 */
function track(colors) {
  const at = (/** @type {number} */ k) => `calc(var(--thumb) / 2 + (100% - var(--thumb)) * ${k / PLACES})`;
  const colored = [...colors].map((packed, k) => `${hexOf(packed)} ${at(k)}`);
  const veils = [...colors].map((packed, k) => {
    const veil = packed & OUTSIDE ? "var(--bar)" : "transparent";
    return `${veil} ${k === 0 ? "0%" : at(k - 0.5)} ${k === PLACES ? "100%" : at(k + 0.5)}`;
  });
  const veiled = (/** @type {string} */ edge) => `linear-gradient(to right, ${veils}) ${edge} / 100% 5px no-repeat`;
  return `${veiled("top")}, ${veiled("bottom")}, linear-gradient(to right, ${colored})`;
}
