// @ts-check
// The tools of a panel: icons in one row, with their names as tooltips. What does not fit is in a menu.

import { Ellipsis, Scan, ZoomIn, ZoomOut } from "../vendor/icons.js";
import { button, create, shape } from "./elements.js";
import { say } from "./words.js";

/** @typedef {typeof Ellipsis} Icon */

// Between the button and its menu, and between the menu and the edge of the window (px).
const GAP = 4;

/** @param {Icon} icon */
function drawn(icon) {
  const frame = {
    class: "ros-icon", viewBox: "0 0 24 24", width: 18, height: 18, fill: "none", stroke: "currentColor",
    "stroke-width": 2, "stroke-linecap": "round", "stroke-linejoin": "round", "aria-hidden": "true",
  };
  return shape("svg", frame, ...icon.map(([tag, attributes]) => shape(tag, /** @type {any} */ (attributes))));
}

/**
 * Create a button that shows an icon, and its name in a menu.
 * @param {string} name @param {Icon} icon @param {() => void} press @param {string} [about] what it does, for the tooltip
 */
export function tool(name, icon, press, about) {
  const element = button("", "ros-tool", press);
  setTool(element, name, icon, about);
  return element;
}

/** @param {HTMLButtonElement} element @param {string} name @param {Icon} icon @param {string} [about] */
export function setTool(element, name, icon, about) {
  if (element.textContent === name) return;
  element.replaceChildren(drawn(icon), create("span", "ros-tool-name", name));
  element.title = about ? `${name}: ${about}` : name;
}

/**
 * Create the tools that zoom what is shown.
 * @param {(closer: boolean) => void} zoom @param {() => void} fit
 */
export function zoomTools(zoom, fit) {
  return [
    tool(say("Zoom in"), ZoomIn, () => zoom(true)),
    tool(say("Zoom out"), ZoomOut, () => zoom(false)),
    tool(say("Fit"), Scan, fit, say("Show everything")),
  ];
}

/** A row of tools and fields. The last of them are in a menu if the panel is narrow. */
export class Toolbar {
  #menu = create("div", "ros-tool-menu");
  #more = tool(say("More"), Ellipsis, () => {});
  #items;
  #kept;
  /** How wide each is in the row (px), as last seen. @type {Map<HTMLElement, number>} */
  #widths = new Map();
  element;

  /** @param {HTMLElement[]} items @param {HTMLElement[]} kept those that stay in the row, at its end */
  constructor(items, kept) {
    this.#items = items;
    this.#kept = kept;
    this.#more.hidden = true;
    this.#more.popoverTargetElement = this.#menu;
    this.#menu.popover = "auto";
    this.#menu.addEventListener("toggle", () => this.#place());
    this.#menu.addEventListener("click", ({ target }) => {
      if (target instanceof Element && target.closest("button")) this.#menu.hidePopover();
    });
    this.element = create("div", "ros-controls ros-toolbar", ...items, this.#more, ...kept, this.#menu);
    const resized = new ResizeObserver(() => this.#arrange());
    for (const element of [this.element, ...items]) resized.observe(element);
  }

  #arrange() {
    const room = this.element.clientWidth;
    if (!room) return;
    const inRow = this.#items.filter((item) => item.parentElement === this.element);
    this.#more.hidden = false;
    for (const item of [...inRow, this.#more, ...this.#kept]) this.#widths.set(item, item.offsetWidth);
    const gap = parseFloat(getComputedStyle(this.element).columnGap) || 0;
    const fits = (/** @type {HTMLElement[]} */ row) => {
      const shown = row.filter(({ hidden }) => !hidden);
      return shown.reduce((sum, item) => sum + (this.#widths.get(item) ?? 0) + gap, -gap) <= room;
    };
    let count = this.#items.length;
    if (!fits([...this.#items, ...this.#kept])) {
      while (count > 0 && !fits([...this.#items.slice(0, count), this.#more, ...this.#kept])) count -= 1;
    }
    const focused = document.activeElement;
    if (count !== inRow.length) {
      for (const item of this.#items.slice(0, count)) this.element.insertBefore(item, this.#more);
      this.#menu.replaceChildren(...this.#items.slice(count));
    }
    this.#more.hidden = this.#items.slice(count).every(({ hidden }) => hidden);
    if (this.#more.hidden) this.#menu.hidePopover();
    this.#place();
    this.#refocus(focused);
  }

  /** Give the focus back to what has been moved, or to what is in its place. @param {Element | null} focused */
  #refocus(focused) {
    if (!(focused instanceof HTMLElement) || !this.element.contains(focused)) return;
    if (focused.hidden) [...this.#items, ...this.#kept].find(({ hidden }) => !hidden)?.focus();
    else if (this.#menu.contains(focused) && !this.#menu.matches(":popover-open")) this.#more.focus();
    else if (document.activeElement !== focused) focused.focus();
  }

  /** Put the menu below its button, or above it where there is more room. */
  #place() {
    if (!this.#menu.matches(":popover-open")) return;
    const from = this.#more.getBoundingClientRect();
    const { offsetWidth: width, offsetHeight: height } = this.#menu;
    const below = from.bottom + GAP;
    const top = below + height + GAP > innerHeight && from.top > innerHeight - from.bottom ? from.top - GAP - height : below;
    const left = Math.min(Math.max(from.right - width, GAP), document.documentElement.clientWidth - width - GAP);
    // From the beginning of the page, so that the menu scrolls with its button.
    this.#menu.style.translate = `${left + scrollX}px ${top + scrollY}px`;
  }
}
