// @ts-check
// The buttons above the Python cells of a page.

import { button, create, enable } from "../ui/elements.js";
import { kernelOf } from "../ui/kernel.js";
import { NodeStateView } from "../ui/nodeState.js";
import { say } from "../ui/words.js";

/** @import { Ros } from "../protocol.js" */

/**
 * @param {HTMLElement} element
 * @param {Ros} ros
 * @param {{node: string, cells: number, interfaces?: string, resources?: Record<string, string>}} options the node that
 *   runs the cells, their number, and what panels below them need
 * @returns {() => void} unmount
 */
export function mount(element, ros, { node: name, cells, ...around }) {
  const node = ros.nodes.get(name);
  if (!node) throw new Error(`notebook: no node '${name}' on this page`);
  kernelOf(node).around = around;
  const listening = new AbortController();
  const state = new NodeStateView(node, listening.signal);
  state.label.setAttribute("aria-live", "polite");
  const runAll = button(say("Run all"), "ros-start", () => kernelOf(node).runAll(cells));
  const interrupt = button(say("Interrupt"), "ros-interrupt", () => node.interrupt());
  const reset = button(say("Restart"), "ros-stop", () => kernelOf(node).restart());
  reset.title = say("Start Python again, without the variables");
  const show = () => {
    const runs = node.state === "running";
    enable([[interrupt, runs], [reset, runs]]);
  };
  node.addEventListener("state", show, { signal: listening.signal });
  show();
  const controls = create("div", "ros-controls", runAll, interrupt, reset);
  controls.setAttribute("role", "group");
  controls.setAttribute("aria-label", say("Cells"));
  const title = create("div", "ros-node", create("span", "ros-title", say("Python")), state.label);
  element.replaceChildren(create("div", "ros-bar", title, controls), state.meter);
  return () => {
    listening.abort();
    element.replaceChildren();
  };
}
