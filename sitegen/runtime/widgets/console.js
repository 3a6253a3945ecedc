// @ts-check
// The output of a node with its state, and an input field if the program reads its standard input.

import { button, create } from "../ui/elements.js";
import { showLines } from "../ui/lines.js";
import { NodeStateView } from "../ui/nodeState.js";
import { place } from "../place.js";
import { say } from "../ui/words.js";

/** @import { Ros } from "../protocol.js" */

/**
 * Show the last `lines` lines of a node.
 * @param {HTMLElement} element
 * @param {Ros} ros
 * @param {{node: string, lines?: number}} options
 * @returns {() => void} unmount
 */
export function mount(element, ros, { node: name, lines: limit = 1000 }) {
  const node = ros.nodes.get(name);
  if (!node) throw new Error(`console: no node '${name}' on this page`);

  const listening = new AbortController();
  const { signal } = listening;
  const state = new NodeStateView(node, signal);
  const title = create("div", "ros-node", create("span", "ros-name", name), state.label);
  // Beside buttons, which have their own, the theme hides the bar.
  const clear = button(say("Clear"), "ros-clear", () => node.clear());
  element.replaceChildren(create("div", "ros-bar", title, create("div", "ros-controls", clear)));
  const beside = (/** @type {string} */ kind) => element.parentElement?.querySelector(`[data-ros-widget="${kind}"]`);
  const start = beside("buttons") ? say("Press Start to run {}", name) : say("Not running");
  const shown = showLines(element, node, limit, {
    stopped: beside("editor") ? say("Press Run to run {}", name) : start,
    starting: say("Starting…"),
    running: say("Running, no output yet"),
    stopping: say("Stopping…"),
    failed: say("Failed"),
  });

  ros.keep(element, { find: "string", folded: "boolean" }, () => shown.state, (state) => void shown.restore(state));

  let endKeyboard = () => {};
  node.addEventListener("reading", async () => {
    // Few programs read input, so pages load this module only when one does.
    const { showKeyboard } = await import(place("ui/keyboard.js"));
    if (!signal.aborted) endKeyboard = showKeyboard(element, node);
  }, { signal, once: true });

  return () => {
    listening.abort();
    shown.close();
    endKeyboard();
    element.replaceChildren();
  };
}
