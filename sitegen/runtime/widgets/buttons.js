// @ts-check
// Buttons to start and stop a node and to clear its consoles, beside its state.

import { button, create } from "../ui/elements.js";
import { say, states } from "../ui/words.js";

/** @import { Ros } from "../protocol.js" */

/**
 * Show the controls of a node.
 * @param {HTMLElement} element
 * @param {Ros} ros
 * @param {{node: string}} options
 * @returns {() => void} unmount
 */
export function mount(element, ros, { node: name }) {
  const node = ros.nodes.get(name);
  if (!node) throw new Error(`buttons: no node '${name}' on this page`);

  const state = create("span", "ros-state");
  state.setAttribute("aria-live", "polite");
  const title = create("div", "ros-node", create("span", "ros-name", name), state);
  const start = button(say("Start"), "ros-start", () => node.start());
  const stop = button(say("Stop"), "ros-stop", () => node.stop());
  const clear = button(say("Clear"), "ros-clear", () => node.clear());
  const controls = create("div", "ros-controls", start, stop, clear);
  controls.setAttribute("role", "group");
  controls.setAttribute("aria-label", name);
  element.replaceChildren(create("div", "ros-bar", title, controls));

  const show = () => {
    const over = node.state === "stopped" || node.state === "failed";
    start.disabled = !over;
    stop.disabled = over || node.state === "stopping";
    state.dataset.state = node.state;
    state.textContent = states[node.state];
  };
  node.addEventListener("state", show);
  show();

  return () => {
    node.removeEventListener("state", show);
    element.replaceChildren();
  };
}
