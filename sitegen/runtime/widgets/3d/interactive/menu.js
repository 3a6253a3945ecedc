// @ts-check
// The menu of an interactive marker.

import { button, create } from "../../../ui/elements.js";
import { say } from "../../../ui/words.js";

/** @import { Handle } from "./handle.js" */

// Others start programs on the robot's computer.
const FEEDBACK = 0;
const MOST = 200;

/**
 * Open the menu of a marker at the pointer.
 * @param {HTMLElement} area @param {Handle} handle @param {{offsetX: number, offsetY: number}} at
 * @param {(entry: number) => void} choose @param {HTMLElement | null} [back] what has the focus when it is closed
 * @returns {() => void} close it
 */
export function openMenu(area, { name, menu }, { offsetX, offsetY }, choose, back = area.querySelector("canvas")) {
  const closing = new AbortController();
  const list = create("div", "ros-marker-menu");
  list.setAttribute("role", "menu");
  list.setAttribute("aria-label", say("Menu of {}", name));
  const close = () => {
    closing.abort();
    list.remove();
  };
  add(list, menu.slice(0, MOST), 0, 0, (entry) => {
    close();
    back?.focus({ preventScroll: true });
    choose(entry);
  });
  list.style.insetInlineStart = `${Math.min(offsetX, Math.max(0, area.clientWidth - 180))}px`;
  list.style.insetBlockStart = `${Math.min(offsetY, Math.max(0, area.clientHeight - 120))}px`;
  const { signal } = closing;
  list.addEventListener("keydown", (event) => {
    if (event.key === "Escape") {
      close();
      back?.focus({ preventScroll: true });
    }
    const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (!step) return;
    event.preventDefault();
    const items = /** @type {HTMLElement[]} */ ([...list.querySelectorAll("button:enabled")]);
    items[(items.indexOf(/** @type {HTMLElement} */ (document.activeElement)) + step + items.length) % items.length]?.focus();
  }, { signal });
  document.addEventListener("pointerdown", ({ target }) => {
    if (target instanceof Node && !list.contains(target)) close();
  }, { signal, capture: true });
  area.append(list);
  list.querySelector("button")?.focus();
  return close;
}

/**
 * Add the entries below `parent`, and those below them.
 * @param {HTMLElement} list @param {any[]} entries @param {number} parent @param {number} depth
 * @param {(entry: number) => void} choose
 */
function add(list, entries, parent, depth, choose) {
  if (depth > 5) return;
  for (const { id, parent_id: above, title, command_type: type } of entries) {
    if (above !== parent || id === parent) continue;
    const group = entries.some((each) => each.parent_id === id);
    const item = button(title.slice(0, 100), "", () => choose(id));
    item.setAttribute("role", "menuitem");
    item.dataset.depth = String(depth);
    item.disabled = group || type !== FEEDBACK;
    list.append(item);
    if (group) add(list, entries, id, depth + 1, choose);
  }
}
