// @ts-check
// A terminal at the bottom of the window, which opens when a visitor runs a command of the text.

import { place } from "../place.js";
import { bringIntoView, offerCommands } from "./terminal/offers.js";

/** @import { Ros } from "../protocol.js" */
/** @import { Opened, Options } from "./terminal/terminals.js" */

/**
 * @param {HTMLElement} element
 * @param {Ros} ros
 * @param {Options} options
 * @returns {() => void} unmount
 */
export function mount(element, ros, options) {
  const panel = /** @type {HTMLElement} */ (element.closest(".ros-panel"));
  /** The terminal while it is open. @type {Promise<Opened> | undefined} */
  let opened;
  /** @type {HTMLElement | undefined} */
  let pressed;
  const close = () => {
    panel.hidden = true;
    opened?.then((terminal) => terminal.close(), () => {});
    opened = undefined;
    pressed?.focus();
  };
  const unoffer = offerCommands((text, by) => {
    pressed = by;
    panel.hidden = false;
    opened ??= import(place("widgets/terminal.js")).then(({ open }) => open(element, ros, options, close));
    opened.then((terminal) => {
      terminal.enter(text);
      bringIntoView(by);
    }, (error) => {
      console.error(error);
      // The next press tries again.
      close();
    });
  });
  return () => {
    unoffer();
    pressed = undefined;
    close();
  };
}
