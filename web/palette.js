// The editor of the palette: swatches to sort, to name, to take away and to give another colour, which all that is painted
// with them follows; and palettes in and out of files.

import { button } from "./buttons.js";
import { make } from "./elements.js";
import { Picker } from "./picker.js";

/** @typedef {import("./colors.js").Shell} Shell */
/** @typedef {import("./colors.js").Swatch} Swatch */

const KINDS = [["gpl", "gpl"], ["ase", "ase"], ["hex", "hex-list"]];

/** A pointer that goes less far has pressed a swatch, not dragged it, in CSS pixels. */
const CLICK_PX = 5;

/** Colours of less chroma than this are sorted as gray. */
const GRAY = 0.03;

const NAME_LENGTH = 80;

/** Those that nothing else of the page has. */
const SYMBOLS = `
  <symbol id="i-earlier" viewBox="0 0 20 20"><path d="M16 10H4m5-5-5 5 5 5"/></symbol>
  <symbol id="i-later" viewBox="0 0 20 20"><path d="M4 10h12m-5-5 5 5-5 5"/></symbol>
  <symbol id="i-hue" viewBox="0 0 20 20"><path d="M7.5 12.5a4 4 0 1 1 0-8 4 4 0 0 1 0 8zM12.5 12.5a4 4 0 1 1 0-8 4 4 0 0 1 0 8zM10 17a4 4 0 1 1 0-8 4 4 0 0 1 0 8z"/></symbol>
  <symbol id="i-lightness" viewBox="0 0 20 20"><path fill="currentColor" d="M10 3v14a7 7 0 0 0 0-14z"/><path d="M10 3a7 7 0 1 0 0 14"/></symbol>`;

document.querySelector("body > svg")?.insertAdjacentHTML("beforeend", SYMBOLS);

export class PaletteEditor {
  #shell;
  /** @type {Swatch[]} */
  #swatches = [];
  #chosen = 0;
  /** The colour of the chosen one as its gesture began. @type {string | undefined} */
  #from;
  #picker;
  #list = make("ul", { className: "swatches", role: "listbox", "aria-orientation": "horizontal" });
  #name = make("input", { type: "text", maxLength: NAME_LENGTH, autocomplete: "off" });
  #kind = make("select", {});
  #file = make("input", { type: "file", accept: ".gpl,.ase,.hex", hidden: true });
  /** @type {Record<string, HTMLButtonElement>} */
  #buttons = {};
  element;

  /** @param {Shell} shell */
  constructor(shell) {
    this.#shell = shell;
    this.#picker = new Picker(shell, (color) => this.#recolor(color), () => this.#settle());
    this.#list.ariaLabel = shell.say("swatches");
    this.#list.addEventListener("keydown", (event) => this.#key(event));
    this.#list.addEventListener("pointerdown", (event) => this.#press(event));
    this.#name.addEventListener("change", () => this.#rename());
    this.#kind.ariaLabel = shell.say("palette-format");
    this.#kind.append(...KINDS.map(([value, key]) => new Option(shell.say(key), value)));
    this.#file.addEventListener("change", () => this.#import());
    this.element = make("div", { className: "picker" }, this.#list, this.#tools(), this.#field(), this.#picker.element);
    this.element.append(this.#files(), make("p", {}, shell.say("swatches-note")));
  }

  /** Begins with the swatch of the colour of the moment, if there is one. */
  begin() {
    const index = this.#shell.swatches().findIndex(({ color }) => color === this.#shell.color());
    if (index >= 0) this.#chosen = index;
    this.follow();
    this.#picker.begin(this.#swatches[this.#chosen].color);
  }

  /** Shows the palette as it is. */
  follow() {
    const before = this.#swatches;
    this.#swatches = this.#shell.swatches();
    this.#chosen = Math.min(this.#chosen, this.#last);
    this.#render();
    // What is on its way gives the brush its colour when it stays.
    if (this.#from === undefined) this.#lead(before);
  }

  /**
   * Who scribbles with a swatch goes on with it where undo or redo has given it another colour: that swatch alone, as palettes
   * of other drawings are other palettes.
   * @param {Swatch[]} before
   */
  #lead(before) {
    if (before.length !== this.#swatches.length) return;
    const [other, ...more] = [...before.keys()].filter((i) => before[i].color !== this.#swatches[i].color);
    if (more.length > 0 || before[other]?.color !== this.#shell.color()) return;
    this.#shell.command("brush-color", this.#swatches[other].color);
  }

  /** The last one that is shown: a drawing may have more of them. */
  get #last() {
    return Math.min(this.#swatches.length, this.#shell.most) - 1;
  }

  /** Adds the colour of the moment, if it is one. */
  add() {
    const color = this.#shell.color();
    if (!color.startsWith("#")) return;
    const swatches = this.#shell.swatches();
    const known = swatches.findIndex((swatch) => swatch.color === color);
    this.follow();
    const added = { color, name: "" };
    if (known < 0) this.#set([...swatches, added]);
    this.#choose(known < 0 ? swatches.length : known);
    this.#tell(known < 0 ? "swatch-added" : "swatch-there", { name: this.#shell.nameOf(swatches[known] ?? added) });
  }

  #tools() {
    const tools = /** @type {[string, () => void, string][]} */ ([
      ["add-swatch", () => this.add(), "plus"],
      ["remove-swatch", () => this.#remove(), "minus"],
      ["earlier", () => this.#move(this.#chosen - 1), "earlier"],
      ["later", () => this.#move(this.#chosen + 1), "later"],
      ["sort-hue", () => this.#sort(hueKey), "hue"],
      ["sort-lightness", () => this.#sort(lightnessKey), "lightness"],
    ]);
    for (const [key, act, symbol] of tools) this.#buttons[key] = button(this.#shell.say(key), act, symbol);
    return make("div", { className: "line" }, ...Object.values(this.#buttons));
  }

  #field() {
    return make("label", { className: "field" }, make("span", {}, this.#shell.say("swatch-name")), this.#name);
  }

  #files() {
    const { say } = this.#shell;
    const save = button(say("export"), () => void this.#export(this.#kind.value));
    const open = button(say("import"), () => this.#file.click());
    save.ariaLabel = say("export-palette");
    open.ariaLabel = say("import-palette");
    return make("div", { className: "line" }, open, this.#kind, save, this.#file);
  }

  /** @param {string} extension */
  async #export(extension) {
    const { say, nameOf, file, download, done, failed } = this.#shell;
    const list = this.#swatches.flatMap((swatch) => [swatch.color, nameOf(swatch)]);
    try {
      const name = `${say("palette")}.${extension}`;
      download(name, new Blob([await file(list, extension)]));
      done(say("exported", { name }));
    } catch (fault) {
      failed(fault);
    }
  }

  #import() {
    const file = this.#file.files?.[0];
    if (file) this.#shell.open(file);
    this.#file.value = "";
  }

  /**
   * @param {Swatch[]} swatches
   * @param {number} [chosen] which of them is
   */
  #set(swatches, chosen = this.#chosen) {
    this.#settle();
    this.#chosen = chosen;
    this.#shell.command("palette", flat(swatches));
    this.follow();
  }

  /** @param {number} index */
  #choose(index) {
    this.#settle();
    this.#chosen = Math.min(index, this.#last);
    this.#render();
    this.#picker.begin(this.#swatches[this.#chosen].color);
  }

  /** @param {string} to */
  #recolor(to) {
    const from = (this.#from ??= this.#swatches[this.#chosen].color);
    const palette = this.#swatches.map((swatch, i) => (i === this.#chosen ? { ...swatch, color: to } : swatch));
    this.#shell.command("repaint", { palette: flat(palette), from, to });
  }

  #settle() {
    if (this.#from === undefined) return;
    const isBrush = this.#from === this.#shell.color();
    const isOther = this.#from !== this.#swatches[this.#chosen].color;
    this.#from = undefined;
    this.#shell.command("settle");
    if (isOther) this.#tell("swatch-recoloured");
    // Who scribbles with the swatch goes on with it; what is selected has been painted with it already, or is not.
    if (isBrush) this.#shell.command("brush-color", this.#swatches[this.#chosen].color);
  }

  #rename() {
    const name = this.#name.value.trim();
    if (name === this.#swatches[this.#chosen].name) return;
    this.#set(this.#swatches.map((swatch, i) => (i === this.#chosen ? { ...swatch, name } : swatch)));
    this.#tell("swatch-renamed");
  }

  #remove() {
    const [removed] = this.#swatches.slice(this.#chosen, this.#chosen + 1);
    if (this.#swatches.length < 2) return;
    this.#set(this.#swatches.filter((_, i) => i !== this.#chosen));
    this.#choose(this.#chosen);
    this.#shell.done(this.#shell.say("swatch-removed", { name: this.#shell.nameOf(removed) }));
  }

  /** Puts the chosen swatch at another place. @param {number} to */
  #move(to) {
    const from = this.#chosen;
    if (to < 0 || to > this.#last || to === from) return;
    const moved = this.#swatches.filter((_, i) => i !== from);
    moved.splice(to, 0, this.#swatches[from]);
    this.#set(moved, to);
    this.#tell("swatch-moved", { place: to + 1 });
  }

  /** @param {(numbers: number[]) => number[]} key of a colour's OKLCH; the first number that differs decides */
  #sort(key) {
    const chosen = this.#swatches[this.#chosen];
    const keyed = this.#swatches.map((swatch) => ({ swatch, key: key(this.#shell.numbers("oklch", swatch.color)) }));
    keyed.sort((a, b) => a.key.reduce((order, number, i) => order || number - b.key[i], 0));
    const sorted = keyed.map(({ swatch }) => swatch);
    this.#set(sorted, sorted.indexOf(chosen));
    this.#shell.done(this.#shell.say("palette-sorted"));
  }

  /**
   * Says what became of the chosen swatch.
   * @param {string} key
   * @param {object} [more] that the message names
   */
  #tell(key, more) {
    const { done, say, nameOf } = this.#shell;
    done(say(key, { name: nameOf(this.#swatches[this.#chosen]), ...more }));
  }

  #render() {
    const hadFocus = this.#list.contains(document.activeElement);
    this.#list.replaceChildren(...this.#swatches.slice(0, this.#last + 1).map((swatch, i) => this.#option(swatch, i)));
    if (hadFocus) this.#focus();
    const chosen = this.#swatches[this.#chosen];
    if (document.activeElement !== this.#name) this.#name.value = chosen.name;
    this.#name.placeholder = this.#shell.nameOf({ ...chosen, name: "" });
    this.#picker.show(chosen.color);
    const { activeElement } = document;
    this.#buttons["remove-swatch"].disabled = this.#swatches.length < 2;
    this.#buttons.earlier.disabled = this.#chosen === 0;
    this.#buttons.later.disabled = this.#chosen === this.#last;
    if (activeElement instanceof HTMLButtonElement && activeElement.disabled) this.#focus();
  }

  /**
   * @param {Swatch} swatch
   * @param {number} i
   */
  #option(swatch, i) {
    const isChosen = i === this.#chosen;
    const label = this.#shell.nameOf(swatch);
    const state = { role: "option", "aria-selected": isChosen, "aria-label": label, title: label, tabIndex: isChosen ? 0 : -1 };
    const option = make("li", state);
    option.style.setProperty("--swatch", swatch.color);
    return option;
  }

  #focus() {
    /** @type {HTMLElement} */ (this.#list.children[this.#chosen]).focus();
  }

  /** @param {KeyboardEvent} event */
  #key(event) {
    if (event.altKey || event.ctrlKey || event.metaKey) return;
    const isRemoval = event.key === "Delete" || event.key === "Backspace";
    const to = this.#target(event.key);
    if (to === undefined && !isRemoval) return;
    // The page has other uses for these keys.
    event.preventDefault();
    if (to === undefined) this.#remove();
    else if (event.shiftKey) this.#move(to);
    else this.#choose(to);
    this.#focus();
  }

  /** Where a key leads from the chosen swatch. @param {string} key */
  #target(key) {
    const last = this.#last;
    const ways = /** @type {Record<string, number>} */ ({
      ArrowLeft: this.#chosen - 1,
      ArrowRight: this.#chosen + 1,
      ArrowUp: this.#chosen - this.#perRow(),
      ArrowDown: this.#chosen + this.#perRow(),
      Home: 0,
      End: last,
    });
    return key in ways ? Math.min(Math.max(ways[key], 0), last) : undefined;
  }

  #perRow() {
    const options = /** @type {HTMLElement[]} */ ([...this.#list.children]);
    return options.filter((option) => option.offsetTop === options[0].offsetTop).length;
  }

  /** Chooses a swatch, and lets it be dragged to another place. @param {PointerEvent} event */
  #press(event) {
    const index = this.#at(event);
    if (index < 0 || event.button !== 0) return;
    event.preventDefault();
    // What is written in a field is for the swatch that was chosen: a field that loses the focus gives it.
    this.#focus();
    this.#choose(index);
    this.#focus();
    const drag = new AbortController();
    const { signal } = drag;
    const move = (/** @type {PointerEvent} */ now) => {
      const isDrag = Math.hypot(now.clientX - event.clientX, now.clientY - event.clientY) > CLICK_PX;
      const to = this.#at(now);
      if (isDrag && to >= 0) this.#carry(to);
    };
    window.addEventListener("pointermove", move, { signal });
    window.addEventListener("pointerup", () => (drag.abort(), this.#drop(index)), { signal });
    window.addEventListener("pointercancel", () => (drag.abort(), this.follow()), { signal });
  }

  /** The place of the swatch under the pointer, or -1. @param {PointerEvent} event */
  #at({ clientX, clientY }) {
    const under = document.elementFromPoint(clientX, clientY)?.closest("[role=option]");
    return under ? [...this.#list.children].indexOf(under) : -1;
  }

  /** Shows the dragged swatch at a place. @param {number} to */
  #carry(to) {
    const dragged = this.#list.querySelector("[aria-selected=true]");
    const under = this.#list.children[to];
    if (!dragged || dragged === under) return;
    if ([...this.#list.children].indexOf(dragged) < to) under.after(dragged);
    else under.before(dragged);
  }

  /** Leaves the dragged swatch where it is shown. @param {number} from */
  #drop(from) {
    const to = [...this.#list.children].findIndex((option) => option.ariaSelected === "true");
    this.#chosen = from;
    this.#move(to);
    this.#focus();
  }
}

/** As the module has it: colours and names in turn. @param {Swatch[]} swatches */
function flat(swatches) {
  return swatches.flatMap(({ color, name }) => [color, name]);
}

/** Grays come last. @param {number[]} numbers */
function hueKey([lightness, chroma, hue]) {
  return chroma < GRAY ? [1, -lightness] : [0, hue, -lightness];
}

/** @param {number[]} numbers */
function lightnessKey([lightness, chroma, hue]) {
  return [-lightness, hue, chroma];
}
