// @ts-check
// A terminal in which `ros2` works on the nodes of the page.

import { bringIntoView, offerCommands } from "./terminal/offers.js";
import { open } from "./terminal/terminals.js";

/** @import { Ros } from "../protocol.js" */
/** @import { Options } from "./terminal/terminals.js" */

// For dock.js, which has no terminal before a visitor needs one.
export { open };

/** @param {HTMLElement} element @param {Ros} ros @param {Options} options @returns {() => void} unmount */
export function mount(element, ros, options) {
  const terminals = open(element, ros, options);
  const unoffer = offerCommands((text) => {
    bringIntoView(element);
    terminals.enter(text);
  });
  return () => {
    unoffer();
    terminals.close();
  };
}
