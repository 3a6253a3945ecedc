// @ts-check
// Create and update the elements of panels. Text is never parsed as HTML, because it may come from a node.

const SVG = "http://www.w3.org/2000/svg";

/**
 * @template {keyof HTMLElementTagNameMap} Tag
 * @param {Tag} tag
 * @param {string} className
 * @param {(Node | string)[]} content
 * @returns {HTMLElementTagNameMap[Tag]}
 */
export function create(tag, className, ...content) {
  const element = document.createElement(tag);
  if (className) element.className = className;
  element.append(...content);
  return element;
}

/**
 * Create an element of SVG.
 * @param {string} tag @param {Record<string, string | number>} attributes @param {Element[]} content
 */
export function shape(tag, attributes = {}, ...content) {
  const element = document.createElementNS(SVG, tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, String(value));
  element.append(...content);
  return element;
}

/** @param {string} text @param {string} className @param {() => void} press */
export function button(text, className, press) {
  const element = create("button", className, text);
  element.type = "button";
  element.addEventListener("click", press);
  return element;
}

/** Create a labelled checkbox. @param {string} text @param {(on: boolean) => void} change */
export function toggle(text, change) {
  const box = create("input", "");
  box.type = "checkbox";
  box.addEventListener("change", () => change(box.checked));
  return create("label", "ros-toggle", box, text);
}

/**
 * Let a click anywhere in `row` press `pick`, the button in it that keys and screen readers reach. Selecting text does
 * not press it.
 * @param {HTMLElement} row @param {HTMLButtonElement} pick
 */
export function pressAnywhere(row, pick) {
  row.classList.add("ros-pickable");
  row.addEventListener("click", ({ target }) => {
    if (target instanceof Node && !pick.contains(target) && getSelection()?.isCollapsed) pick.click();
  });
}

/**
 * Set the text of an element if it differs. Setting the same text would remove the visitor's selection and make screen
 * readers announce it again.
 * @param {Element} element @param {string} text
 */
export function setText(element, text) {
  if (element.textContent !== text) element.textContent = text;
}

/**
 * Set the text of a note, and mark it as an error if `wrong`.
 * @param {Element} note @param {string} text @param {boolean} wrong
 */
export function setNote(note, text, wrong = false) {
  note.classList.toggle("ros-wrong", wrong);
  setText(note, text);
}

/**
 * Let `list` contain the elements `wanted` in this order. Elements that stay are not moved, because moving an
 * element takes the keyboard focus from it.
 * @param {Element} list @param {Element[]} wanted
 */
export function arrange(list, wanted) {
  for (const child of [...list.children]) {
    if (!wanted.includes(child)) child.remove();
  }
  wanted.forEach((element, index) => {
    const there = list.children[index] ?? null;
    if (there !== element) list.insertBefore(element, there);
  });
}

/**
 * Enable and disable buttons. A button that had the keyboard focus passes it on to one that can be pressed.
 * @param {[HTMLButtonElement, boolean][]} buttons each with whether it is enabled
 */
export function enable(buttons) {
  const focused = buttons.some(([element]) => element === document.activeElement);
  for (const [element, on] of buttons) element.disabled = !on;
  const active = document.activeElement;
  if (focused && !(active instanceof HTMLButtonElement && !active.disabled)) {
    buttons.find(([, on]) => on)?.[0].focus();
  }
}
