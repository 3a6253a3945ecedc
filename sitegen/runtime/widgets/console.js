// @ts-check
// What a node prints, how it is, and its keyboard if it reads one.

import { create } from "../elements.js";
import { showKeyboard } from "../keyboard.js";
import { showLines } from "../lines.js";
import { say, states } from "../words.js";

/** @import { Ros } from "../protocol.js" */

/**
 * Show the lines of a node; `lines` is how many stay, the oldest leave.
 * @param {HTMLElement} element
 * @param {Ros} ros
 * @param {{node: string, lines?: number}} options
 * @returns {() => void} unmount
 */
export function mount(element, ros, { node: name, lines: limit = 1000 }) {
  const node = ros.nodes.get(name);
  if (!node) throw new Error(`console: no node '${name}' in this page`);

  const state = create("span", "ros-state");
  const title = create("div", "ros-node", create("span", "ros-name", name), state);
  element.replaceChildren(create("div", "ros-bar", title));
  const hasButtons = element.parentElement?.querySelector('[data-ros-widget="buttons"]');
  const endLines = showLines(element, node, limit, {
    stopped: hasButtons ? say("Press Start to run {}", name) : say("Not running"),
    starting: say("Starting…"),
    running: say("Running, nothing printed yet"),
    stopping: say("Stopping…"),
    failed: say("Failed"),
  });
  const endKeyboard = showKeyboard(element, node);

  const showState = () => {
    state.dataset.state = node.state;
    state.textContent = states[node.state];
  };
  node.addEventListener("state", showState);
  showState();

  return () => {
    node.removeEventListener("state", showState);
    endLines();
    endKeyboard();
    element.replaceChildren();
  };
}
