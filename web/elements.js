// Elements made by scripts, in one expression.

/**
 * @template {keyof HTMLElementTagNameMap} Tag
 * @param {Tag} tag
 * @param {Record<string, unknown>} properties of the element; those with a hyphen, and `role`, are attributes
 * @param {(Node | string)[]} content
 * @returns {HTMLElementTagNameMap[Tag]}
 */
export function make(tag, properties, ...content) {
  const element = document.createElement(tag);
  for (const [key, value] of Object.entries(properties)) {
    if (key.includes("-") || key === "role") element.setAttribute(key, String(value));
    else Object.assign(element, { [key]: value });
  }
  element.append(...content);
  return element;
}

/**
 * A symbol of the page's.
 * @param {string} name
 */
export function icon(name) {
  const space = "http://www.w3.org/2000/svg";
  const svg = document.createElementNS(space, "svg");
  const use = document.createElementNS(space, "use");
  svg.setAttribute("aria-hidden", "true");
  use.setAttribute("href", `#i-${name}`);
  svg.append(use);
  return svg;
}

/**
 * @param {string} text
 * @param {() => void} act
 * @param {string} [symbol] shown in place of the text
 */
export function button(text, act, symbol) {
  const content = symbol ? icon(symbol) : text;
  const made = make("button", { type: "button", title: symbol ? text : "", className: symbol ? "icon" : "" }, content);
  if (symbol) made.ariaLabel = text;
  made.addEventListener("click", act);
  return made;
}
