// @ts-check
// Start and stop a node, empty its consoles, and say how it is.

import { say, states } from "../ui/words.js";

/** @import {Ros} from "../protocol.js" */

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

  const title = document.createElement("div");
  title.className = "ros-node";
  const label = document.createElement("span");
  label.className = "ros-name";
  label.textContent = name;
  const state = document.createElement("span");
  state.className = "ros-state";
  state.setAttribute("aria-live", "polite");
  title.append(label, state);

  const start = button(say("Start"), "ros-start", () => node.start());
  const stop = button(say("Stop"), "ros-stop", () => node.stop());
  const clear = button(say("Clear"), "ros-clear", () => node.clear());
  const controls = document.createElement("div");
  controls.className = "ros-controls";
  controls.setAttribute("role", "group");
  controls.setAttribute("aria-label", name);
  controls.append(start, stop, clear);

  const bar = document.createElement("div");
  bar.className = "ros-bar";
  bar.append(title, controls);
  element.replaceChildren(bar);

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

/**
 * @param {string} text
 * @param {string} className
 * @param {() => void} press
 */
function button(text, className, press) {
  const element = document.createElement("button");
  element.type = "button";
  element.className = className;
  element.textContent = text;
  element.addEventListener("click", press);
  return element;
}
