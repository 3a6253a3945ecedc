// @ts-check
// ros2 lifecycle: the states and transitions of managed nodes.

import { Failure } from "../shell/shell.js";
import { absolute, DISCOVERY, flag, isHidden } from "./verb.js";

/** @import { Ros } from "../../protocol.js" */
/** @import { Io } from "../shell/shell.js" */
/** @import { Group, Verb } from "./verb.js" */

const SRV = "lifecycle_msgs/srv";
const GET_STATE = "/get_state";
const NODE = /** @type {const} */ ({ name: "node_name", help: "Name of the ROS node", complete: "lifecycleNode" });
const HIDDEN = flag("hidden", ["--include-hidden-nodes"], "Consider hidden nodes as well");

/** The full names of the managed nodes. @param {Ros} ros */
export function managedNodes(ros) {
  return ros.graph.services()
    .filter(({ name, types, servers }) => name.endsWith(GET_STATE) && types.includes(`${SRV}/GetState`) && servers.length)
    .map(({ name }) => name.slice(0, -GET_STATE.length)).sort();
}

/** @param {Ros} ros @param {string} given @param {boolean} hidden whether it may be hidden */
function nodeOf(ros, given, hidden) {
  const name = absolute(given);
  if (!managedNodes(ros).includes(name) || (!hidden && isHidden(name))) throw new Failure("Node not found");
  return name;
}

/** @param {Io} io @param {string} node @param {string} service @param {string} type @param {any} [request] */
function ask({ ros, signal }, node, service, type, request = {}) {
  return ros.call(`${node}/${service}`, `${SRV}/${type}`, request, Infinity, signal);
}

/** @type {Verb} */
const nodes = {
  name: "nodes",
  about: "Output a list of nodes with lifecycle",
  args: [
    ...DISCOVERY,
    flag("all", ["-a", "--all"], "Display all nodes even hidden ones"),
    flag("count", ["-c", "--count-nodes"], "Only display the number of nodes discovered"),
  ],
  async run({ ros, out }, { all, count }) {
    const found = managedNodes(ros).filter((name) => all || !isHidden(name));
    if (count) await out(`${found.length}\n`);
    else for (const name of found) await out(`${name}\n`);
  },
};

/** @type {Verb} */
const get = {
  name: "get",
  about: "Get lifecycle state for one or more nodes",
  args: [
    ...DISCOVERY,
    { ...NODE, count: "?", help: "Name of the ROS node. If no name is provided, then get the state for all nodes." },
    HIDDEN,
  ],
  async run(io, { node_name: given, hidden }) {
    const found = given ? [nodeOf(io.ros, given, hidden)] : managedNodes(io.ros).filter((name) => hidden || !isHidden(name));
    for (const node of found) {
      const { current_state: state } = await ask(io, node, "get_state", "GetState");
      await io.out(`${given ? "" : `${node}: `}${state.label} [${state.id}]\n`);
    }
  },
};

/** @type {Verb} */
const list = {
  name: "list",
  about: "Output a list of available transitions",
  args: [...DISCOVERY, NODE, HIDDEN, flag("all", ["-a", "--all"], "Display all existing transitions")],
  async run(io, { node_name: given, all, hidden }) {
    const node = nodeOf(io.ros, given, hidden);
    const [service, type] = all ? ["get_transition_graph", "GetAvailableTransitions"] : ["get_available_transitions", "GetAvailableTransitions"];
    const { available_transitions: found } = await ask(io, node, service, type);
    for (const { transition, start_state: start, goal_state: goal } of found) {
      await io.out(`- ${transition.label} [${transition.id}]\n\tStart: ${start.label}\n\tGoal: ${goal.label}\n`);
    }
  },
};

/** @type {Verb} */
const set = {
  name: "set",
  about: "Trigger lifecycle state transition",
  args: [...DISCOVERY, NODE, HIDDEN, { name: "transition", help: "The lifecycle transition" }],
  async run(io, { node_name: given, transition: wanted, hidden }) {
    const node = nodeOf(io.ros, given, hidden);
    const { available_transitions: available } = await ask(io, node, "get_available_transitions", "GetAvailableTransitions");
    const all = available.map((/** @type {any} */ { transition }) => transition);
    const transition = all.find((/** @type {any} */ { label }) => label === wanted) ?? all.find((/** @type {any} */ { id }) => String(id) === wanted);
    if (!transition) {
      const known = all.map((/** @type {any} */ { id, label }) => `- ${label} [${id}]`).join("\n");
      return `Unknown transition requested, available ones are:\n${known}`;
    }
    const { success } = await ask(io, node, "change_state", "ChangeState", { transition });
    // Upstream's status is that of success, too.
    await (success ? io.out("Transitioning successful\n") : io.err("Transitioning failed\n"));
    return 0;
  },
};

/** @type {Group} */
export const LIFECYCLE = { name: "lifecycle", about: "Various lifecycle related sub-commands", verbs: [get, list, nodes, set] };
