// @ts-check
// ros2 node: the nodes of the graph.

import { actionsOf } from "../../messages/actionClient.js";
import { DISCOVERY, endpoints, flag, isHidden } from "./verb.js";

/** @import { EndpointKind, Ros } from "../../protocol.js" */
/** @import { Group, Verb } from "./verb.js" */

/** @type {Verb} */
const list = {
  name: "list",
  about: "Output a list of available nodes",
  args: [
    ...DISCOVERY,
    flag("all", ["-a", "--all"], "Display all nodes even hidden ones"),
    flag("count", ["-c", "--count-nodes"], "Only display the number of nodes discovered"),
  ],
  async run({ ros, out, err }, { all, count }) {
    const names = ros.graph.nodes().filter((name) => all || !isHidden(name));
    if (count) {
      await out(`${names.length}\n`);
      return 0;
    }
    if (new Set(names).size < names.length) {
      await err("WARNING: Be aware that there are nodes in the graph that share an exact name, which can have unintended side effects.\n");
    }
    for (const name of names) await out(`${name}\n`);
    return 0;
  },
};

/** @type {Verb} */
const info = {
  name: "info",
  about: "Output information about a node",
  args: [
    ...DISCOVERY,
    { name: "node_name", help: "Fully qualified node name to request information", complete: "node" },
    flag("hidden", ["--include-hidden"], "Display hidden topics, services, and actions as well"),
  ],
  async run({ ros, out, err }, { node_name: node, hidden }) {
    const same = ros.graph.nodes().filter((name) => name === node && (hidden || !isHidden(name))).length;
    if (!same) return `Unable to find node '${node}'`;
    if (same > 1) {
      await err(`There are ${same} nodes in the graph with the exact name "${node}". You are seeing information about only one of them.\n`);
    }
    const entries = [
      ["Subscribers", named(ros, node, "subscription", hidden)],
      ["Publishers", named(ros, node, "publisher", hidden)],
      ["Service Servers", named(ros, node, "service", hidden)],
      ["Service Clients", named(ros, node, "client", hidden)],
      ["Action Servers", actions(ros, node, "service")],
      ["Action Clients", actions(ros, node, "client")],
    ];
    await out(`${node}\n`);
    for (const [title, lines] of entries) {
      await out(`  ${title}:\n`);
      await out(`${/** @type {string[]} */ (lines).map((line) => `    ${line}`).join("\n")}\n`);
    }
    return 0;
  },
};

/** @param {Ros} ros @param {string} node @param {EndpointKind} kind @param {boolean} hidden */
function named(ros, node, kind, hidden) {
  /** @type {Map<string, Set<string>>} */
  const found = new Map();
  for (const { name, type } of endpoints(ros, { node, kind })) {
    if (!hidden && isHidden(name)) continue;
    found.set(name, (found.get(name) ?? new Set()).add(type));
  }
  return [...found].sort(([one], [other]) => (one < other ? -1 : 1)).map(([name, types]) => `${name}: ${[...types].join(", ")}`);
}

/** @param {Ros} ros @param {string} node @param {"service" | "client"} kind */
function actions(ros, node, kind) {
  const end = "/_action/send_goal";
  return actionsOf(ros)
    .filter(({ name }) => endpoints(ros, { node, kind, name: name + end }).length)
    .map(({ name, types }) => `${name}: ${types.join(", ")}`);
}

/** @type {Group} */
export const NODE = { name: "node", about: "Various node related sub-commands", verbs: [info, list] };
