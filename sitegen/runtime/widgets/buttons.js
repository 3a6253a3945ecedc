// @ts-check
// Buttons to start and stop a node and to clear its consoles, beside its state.

import { button, create, enable } from "../ui/elements.js";
import { createNeeds } from "../ui/needs.js";
import { NodeStateView } from "../ui/nodeState.js";
import { say } from "../ui/words.js";

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

  const listening = new AbortController();
  const { signal } = listening;
  const state = new NodeStateView(node, signal);
  state.label.setAttribute("aria-live", "polite");
  const title = create("div", "ros-node", create("span", "ros-name", name), state.label);
  const start = button(say("Start"), "ros-start", () => node.start());
  const stop = button(say("Stop"), "ros-stop", () => node.stop());
  const clear = button(say("Clear"), "ros-clear", () => node.clear());
  const controls = create("div", "ros-controls", start, stop, clear);
  controls.setAttribute("role", "group");
  controls.setAttribute("aria-label", name);
  const needs = createNeeds(ros, node, signal);
  element.replaceChildren(create("div", "ros-bar", title, controls), state.meter, needs);

  const show = () => {
    const over = node.state === "stopped" || node.state === "failed";
    enable([[start, over], [stop, !over && node.state !== "stopping"]]);
  };
  node.addEventListener("state", show, { signal });
  show();

  return () => {
    listening.abort();
    element.replaceChildren();
  };
}
