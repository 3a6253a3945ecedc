// @ts-check
// The managed nodes of the page: their states, and buttons for the transitions that are available.

import { arrange, create, setText } from "../ui/elements.js";
import { whileNear } from "../ui/looking.js";
import { say } from "../ui/words.js";
import { ManagedNode, TYPES, managedNodes } from "./lifecycle/node.js";

/** @import { Ros } from "../protocol.js" */

const NONE = say("No managed nodes now. They appear when they start.");

/**
 * Show all managed nodes, or only those in `show`.
 * @param {HTMLElement} element
 * @param {Ros} ros
 * @param {{show?: string[] | null}} options full names
 * @returns {() => void} unmount
 */
export function mount(element, ros, { show }) {
  /** @type {Map<string, ManagedNode>} */
  const nodes = new Map();
  let seen = false;
  const list = create("ul", "ros-managed-list");
  const hint = create("p", "ros-hint");
  const bar = create("div", "ros-bar", create("span", "ros-title", say("Managed nodes")));
  element.replaceChildren(bar, create("div", "ros-list", list, hint));
  const missing = TYPES.find((type) => !ros.types[type]);

  const look = () => {
    const running = missing ? [] : managedNodes(ros);
    const names = running.filter((name) => !show || show.includes(name));
    for (const [name, node] of nodes) {
      if (names.includes(name)) continue;
      node.close();
      nodes.delete(name);
    }
    for (const name of names) {
      const node = nodes.get(name) ?? new ManagedNode(ros, name);
      nodes.set(name, node);
      if (seen) node.follow();
    }
    arrange(list, names.map((name) => /** @type {ManagedNode} */ (nodes.get(name)).element));
    hint.hidden = names.length > 0;
    setText(hint, missing ? say("no node on this page uses {}", missing.replace("_Request", "")) : NONE);
  };
  const unlook = whileNear(element, () => {
    seen = true;
    ros.graph.addEventListener("change", look);
    look();
    return () => {
      seen = false;
      ros.graph.removeEventListener("change", look);
      for (const node of nodes.values()) node.rest();
    };
  });
  look();
  return () => {
    unlook();
    for (const node of nodes.values()) node.close();
    element.replaceChildren();
  };
}
