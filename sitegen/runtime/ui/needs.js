// @ts-check
// What a node waits for: the nodes that it needs and that do not run, with a button to start each.

import { button, create } from "./elements.js";
import { say } from "./words.js";

/** @import { NodeHandle, Ros } from "../protocol.js" */

/**
 * Create a note that is visible while `node` has been started and nodes that it needs do not run.
 * @param {Ros} ros
 * @param {NodeHandle} node
 * @param {AbortSignal} signal ends it
 */
export function createNeeds(ros, node, signal) {
  const element = create("div", "ros-needs");
  element.setAttribute("role", "status");
  const needed = node.needs.flatMap((name) => ros.nodes.get(name) ?? []);
  const show = () => {
    const missing = node.state === "stopped" ? [] : needed.filter(isOver);
    const names = missing.map(({ name }) => name);
    if (element.dataset.missing === names.join(" ")) return;
    element.dataset.missing = names.join(" ");
    if (!names.length) {
      element.replaceChildren();
      return;
    }
    const starts = missing.map((other) => button(say("Start {} first", other.name), "ros-start", () => other.start()));
    const text = create("span", "", say("{} needs {}.", node.name, names.join(", ")));
    element.replaceChildren(text, create("div", "ros-controls", ...starts));
  };
  for (const one of [node, ...needed]) one.addEventListener("state", show, { signal });
  show();
  return element;
}

/** @param {NodeHandle} node */
function isOver({ state }) {
  return state === "stopped" || state === "failed";
}
