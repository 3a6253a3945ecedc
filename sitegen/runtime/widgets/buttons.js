// @ts-check
// Buttons to start and stop a node and to clear its consoles, beside its state.

import { button, create, enable } from "../ui/elements.js";
import { place } from "../place.js";
import { createNeeds } from "../ui/needs.js";
import { NodeStateView } from "../ui/nodeState.js";
import { say } from "../ui/words.js";

/** @import { NodeHandle, Ros } from "../protocol.js" */

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
  const options = optionsOf(element, ros, node, signal);
  const controls = create("div", "ros-controls", start, stop, clear, options.button);
  controls.setAttribute("role", "group");
  controls.setAttribute("aria-label", name);
  const needs = createNeeds(ros, node, signal);
  element.replaceChildren(create("div", "ros-bar", title, controls), state.meter, needs, options.place);

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

/**
 * A button that opens a form of the node's parameters, remaps and arguments, and the place of the form.
 * @param {HTMLElement} element @param {Ros} ros @param {NodeHandle} node @param {AbortSignal} signal
 */
function optionsOf(element, ros, node, signal) {
  const hold = create("div", "ros-options-place");
  hold.hidden = true;
  /** @type {object | undefined} */
  let chosen;
  /** @type {Promise<any> | undefined} */
  let form;
  // Few visitors open it, so pages load its module only then.
  const load = () => form ??= import(place("widgets/buttons/options.js")).then(({ OptionsForm }) => {
    const made = new OptionsForm(node, (/** @type {object | undefined} */ options) => {
      chosen = options;
      press.classList.toggle("ros-chosen", Boolean(options));
    });
    if (!signal.aborted) hold.replaceChildren(made.element);
    return made;
  });
  const press = button("", "ros-options-button", async () => {
    hold.hidden = !hold.hidden;
    press.ariaExpanded = String(!hold.hidden);
    await load();
    if (!hold.hidden) hold.querySelector("input")?.focus();
  });
  signal.addEventListener("abort", () => form && node.override(undefined));
  press.title = say("Parameters, remaps and arguments");
  press.setAttribute("aria-label", say("Options"));
  press.hidden = !node.configurable;
  press.ariaExpanded = "false";
  ros.keep(element, { options: "object" }, () => ({ options: chosen }), async (state, odd) => {
    if (!state.options) return;
    hold.hidden = false;
    press.ariaExpanded = "true";
    if (!(await load()).set(state.options)) odd();
  });
  return { button: press, place: hold };
}
