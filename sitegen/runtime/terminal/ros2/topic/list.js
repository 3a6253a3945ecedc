// @ts-check
// ros2 topic list, info, type and find.

import { DISCOVERY, endpoints, flag, isHidden } from "../verb.js";

/** @import { Qos, Ros } from "../../../protocol.js" */
/** @import { Verb } from "../verb.js" */

/** @param {Ros} ros @param {boolean} hidden */
function topics(ros, hidden) {
  return ros.graph.topics().filter(({ name }) => hidden || !isHidden(name));
}

/** @type {Verb} */
export const list = {
  name: "list",
  about: "Output a list of available topics",
  args: [
    ...DISCOVERY,
    flag("show_types", ["-t", "--show-types"], "Additionally show the topic type"),
    flag("count", ["-c", "--count-topics"], "Only display the number of topics discovered"),
    flag("all", ["--include-hidden-topics"], "Consider hidden topics as well"),
    flag("verbose", ["-v", "--verbose"], "List full details about each topic"),
  ],
  async run({ ros, out }, { show_types: typed, count, all, verbose, hidden }) {
    const found = topics(ros, all || hidden);
    if (count) {
      await out(`${found.length}\n`);
    } else if (verbose && found.length) {
      for (const [title, word, side] of /** @type {const} */ ([
        ["Published", "publisher", "publishers"], ["Subscribed", "subscriber", "subscriptions"]])) {
        const lines = found.filter((topic) => topic[side].length).map(({ name, types, [side]: { length } }) =>
          ` * ${name} [${types.join(", ")}] ${length} ${word}${length > 1 ? "s" : ""}\n`);
        await out(`${title} topics:\n${lines.join("")}\n`);
      }
    } else {
      for (const { name, types } of found) await out(typed ? `${name} [${types.join(", ")}]\n` : `${name}\n`);
    }
  },
};

/** @type {Verb} */
export const info = {
  name: "info",
  about: "Print information about a topic",
  args: [
    ...DISCOVERY,
    { name: "topic_name", help: "Name of the ROS topic to get info (e.g. '/chatter')", complete: "topic" },
    flag("verbose", ["--verbose", "-v"], "Prints detailed information like the node name, node namespace, topic type, topic type hash, GUID, and QoS Profile of the publishers and subscribers to this topic"),
  ],
  async run({ ros, out, shell }, { topic_name: name, verbose }) {
    const hashes = verbose ? await shell.interfaces.hashes() : {};
    const described = (/** @type {ReturnType<typeof endpoints>[number]} */ one) => endpointInfo(one, "Topic", hashes);
    const topic = topics(ros, true).find((one) => one.name === name);
    if (!topic) return `Unknown topic '${name}'`;
    const end = verbose ? "\n\n" : "\n";
    const { types, publishers, subscriptions } = topic;
    const type = types.length === 1 ? types[0] : `[${types.map((one) => `'${one}'`).join(", ")}]`;
    await out(`Type: ${type}${end}`);
    await out(`Publisher count: ${publishers.length}${end}`);
    if (verbose) for (const one of endpoints(ros, { kind: "publisher", name })) await out(`${described(one)}${end}`);
    await out(`Subscription count: ${subscriptions.length}${end}`);
    if (verbose) for (const one of endpoints(ros, { kind: "subscription", name })) await out(`${described(one)}${end}`);
    return 0;
  },
};

/**
 * Describe an endpoint as rclpy does. @param {ReturnType<typeof endpoints>[number]} endpoint
 * @param {"Topic" | "Service"} what @param {Record<string, string>} hashes of types
 */
export function endpointInfo({ kind, node, type, gid, qos }, what, hashes) {
  const at = node.lastIndexOf("/");
  return [
    `Node name: ${node.slice(at + 1)}`,
    `Node namespace: ${node.slice(0, at) || "/"}`,
    `${what} type: ${type}`,
    `${what} type hash: ${hashes[type] ?? "INVALID"}`,
    `Endpoint type: ${KINDS[kind]}`,
    `GID: ${gidText(gid)}`,
    "QoS profile:",
    ...qosLines(qos),
  ].join("\n");
}

/** @type {Record<string, string>} */
const KINDS = { publisher: "PUBLISHER", subscription: "SUBSCRIPTION", client: "CLIENT", service: "SERVER" };

/** @param {Qos} qos */
function qosLines(qos) {
  return [
    `  Reliability: ${qos.reliable ? "RELIABLE" : "BEST_EFFORT"}`,
    `  History (Depth): ${qos.keepAll ? "KEEP_ALL" : `KEEP_LAST (${qos.depth})`}`,
    `  Durability: ${qos.transientLocal ? "TRANSIENT_LOCAL" : "VOLATILE"}`,
    `  Lifespan: ${duration(qos.lifespan)}`,
    `  Deadline: ${duration(qos.deadline)}`,
    `  Liveliness: ${qos.manual ? "MANUAL_BY_TOPIC" : "AUTOMATIC"}`,
    `  Liveliness lease duration: ${duration(qos.lease)}`,
  ];
}

/** @param {number} milliseconds */
function duration(milliseconds) {
  return Number.isFinite(milliseconds) ? `${Math.round(milliseconds * 1e6)} nanoseconds` : "Infinite";
}

/** A gid as the sixteen bytes of upstream's. @param {number} gid */
function gidText(gid) {
  const bytes = new Uint8Array(16);
  const view = new DataView(bytes.buffer);
  view.setUint32(8, Math.floor(gid / 2 ** 32));
  view.setUint32(12, gid % 2 ** 32);
  return Array.from(bytes, (byte) => byte.toString(16).padStart(2, "0")).join(".");
}

/** @type {Verb} */
export const type = {
  name: "type",
  about: "Print a topic's type",
  args: [
    ...DISCOVERY,
    { name: "topic_name", help: "Name of the ROS topic to get type (e.g. '/chatter')", complete: "topic" },
  ],
  async run({ ros, out }, { topic_name: name, hidden }) {
    const topic = topics(ros, hidden).find((one) => one.name === name);
    if (!topic) return 1;
    for (const one of topic.types) await out(`${one}\n`);
    return 0;
  },
};

/** @type {Verb} */
export const find = {
  name: "find",
  about: "Output a list of available topics of a given type",
  args: [
    ...DISCOVERY,
    { name: "topic_type", help: "Name of the ROS topic type to filter for (e.g. 'std_msg/msg/String')", complete: "message" },
    flag("count", ["-c", "--count-topics"], "Only display the number of topics discovered"),
    flag("all", ["--include-hidden-topics"], "Consider hidden topics as well"),
  ],
  async run({ ros, out }, { topic_type: wanted, count, all, hidden }) {
    const found = topics(ros, all || hidden).filter(({ types }) => types.includes(wanted));
    if (count) await out(`${found.length}\n`);
    else for (const { name } of found) await out(`${name}\n`);
  },
};
