// @ts-check
// ros2 service: list, types, calls and events of services.

import { FLOAT } from "../args/parse.js";
import { serviceNames } from "../args/words.js";
import { Failure, pause } from "../shell/shell.js";
import { echo } from "./topic/echo.js";
import { filled } from "./filled.js";
import { repr } from "./python.js";
import { readValues } from "./topic/pub.js";
import { absolute, checkName, DISCOVERY, endpoints, flag, fullType, isHidden, option, QOS_OPTIONS, until } from "./verb.js";

/** @import { Ros } from "../../protocol.js" */
/** @import { Group, Verb } from "./verb.js" */

/** The services that have a server. @param {Ros} ros @param {boolean} hidden */
function services(ros, hidden) {
  const served = new Set(serviceNames(ros));
  return ros.graph.services().filter(({ name, servers }) => (served.has(name) || (hidden && servers.length)) && (hidden || !isHidden(name)));
}

const HIDDEN = flag("all", ["--include-hidden-services"], "Consider hidden services as well");

/** @type {Verb} */
const list = {
  name: "list",
  about: "Output a list of available services",
  args: [
    ...DISCOVERY,
    flag("typed", ["-t", "--show-types"], "Additionally show the service type"),
    flag("count", ["-c", "--count-services"], "Only display the number of services discovered"),
    HIDDEN,
  ],
  async run({ ros, out }, { typed, count, all, hidden }) {
    const found = services(ros, all || hidden);
    if (count) await out(`${found.length}\n`);
    else for (const { name, types } of found) await out(typed ? `${name} [${types.join(", ")}]\n` : `${name}\n`);
  },
};

/** @type {Verb} */
const type = {
  name: "type",
  about: "Output a service's type",
  args: [...DISCOVERY, { name: "service_name", help: "Name of the ROS service to get type (e.g. '/talker/list_parameters')", complete: "service" }],
  async run({ ros, out }, { service_name: name }) {
    const service = services(ros, true).find((one) => one.name === name);
    if (!service) return 1;
    for (const one of service.types) await out(`${one}\n`);
    return 0;
  },
};

/** @type {Verb} */
const find = {
  name: "find",
  about: "Output a list of available services of a given type",
  args: [
    ...DISCOVERY,
    { name: "service_type", help: "Name of the ROS service type to filter for (e.g. 'rcl_interfaces/srv/ListParameters')", complete: "serviceType" },
    flag("count", ["-c", "--count-services"], "Only display the number of services discovered"),
    HIDDEN,
  ],
  async run({ ros, out }, { service_type: wanted, count, all, hidden }) {
    const found = services(ros, all || hidden).filter(({ types }) => types.includes(wanted));
    if (count) await out(`${found.length}\n`);
    else for (const { name } of found) await out(`${name}\n`);
  },
};

/** @type {Verb} */
const info = {
  name: "info",
  about: "Print information about a service",
  args: [
    { name: "service_name", help: "Name of the ROS service to get info (e.g. '/add_two_ints')", complete: "service" },
    ...DISCOVERY,
    flag("verbose", ["-v", "--verbose"], "Prints detailed information like the node name and node namespace of the servers and clients"),
  ],
  async run({ ros, out }, { service_name: name, verbose }) {
    const service = ros.graph.services().find((one) => one.name === name);
    if (!service) return `Unknown service '${name}'`;
    const { types, clients, servers } = service;
    await out(`Type: ${types.length === 1 ? types[0] : `[${types.map((one) => `'${one}'`).join(", ")}]`}\n`);
    await out(`Clients count: ${clients.length}\n`);
    await out(`Services count: ${servers.length}\n`);
    if (!verbose) return 0;
    for (const one of [...endpoints(ros, { kind: "client", name }), ...endpoints(ros, { kind: "service", name })]) {
      const at = one.node.lastIndexOf("/");
      await out(`\nNode name: ${one.node.slice(at + 1)}\nNode namespace: ${one.node.slice(0, at) || "/"}\nService type: ${one.type}\nEndpoint type: ${one.kind === "client" ? "CLIENT" : "SERVER"}\n`);
    }
    return 0;
  },
};

/** @type {Verb} */
const call = {
  name: "call",
  about: "Call a service",
  args: [
    { name: "service_name", help: "Name of the ROS service to call to (e.g. '/add_two_ints')", complete: "service" },
    { name: "service_type", help: "Type of the ROS service (e.g. 'std_srvs/srv/Empty')", complete: "serviceType" },
    { name: "values", count: "?", initial: "{}", help: "Values to fill the service request with in YAML format (e.g. '{a: 1, b: 2}'), otherwise the service request will be published with default values", complete: "serviceRequest" },
    option("rate", ["-r", "--rate"], "Repeat the call at a specific rate in Hz", { metavar: "N", type: { name: "positive_float", read: positive } }),
    ...QOS_OPTIONS,
  ],
  async run(io, { service_name: given, service_type: typeGiven, values, rate }) {
    const { ros, out, signal } = io;
    checkName(given, "service");
    const name = absolute(given);
    const service = fullType(typeGiven, "srv");
    if (!ros.types[`${service}_Request`]) throw new Failure("The passed service type is invalid");
    const request = filled(readValues(values, `${service}_Request`, io), `${service}_Request`, ros.types);
    const ready = () => endpoints(ros, { kind: "service", name }).some((one) => one.type === service);
    if (!ready()) await out("waiting for service to become available...\n");
    for (;;) {
      await until(io, ready);
      await out(`requester: making request: ${repr(request, `${service}_Request`, ros.types)}\n\n`);
      const response = await ros.call(name, service, request, Infinity, signal);
      await out(`response:\n${repr(response, `${service}_Response`, ros.types)}\n\n`);
      if (!rate) return;
      await pause(1000 / rate, signal);
    }
  },
};

/** @type {Verb} */
const echoEvents = {
  name: "echo",
  about: "Echo a service",
  args: [
    { name: "service_name", help: "Name of the ROS service to echo (e.g. '/add_two_ints')", complete: "service" },
    { name: "service_type", count: "?", help: "Type of the ROS service (e.g. 'example_interfaces/srv/AddTwoInts')", complete: "serviceType" },
    ...echo.args.filter(({ flags }) => flags && !flags.includes("--field") && !flags.includes("--raw")),
  ],
  async run(io, { service_name: name, ...args }) {
    const topic = `${absolute(name)}/_service_event`;
    if (!io.ros.graph.topics().some((one) => one.name === topic)) {
      return `No service event topic for '${name}': its node does not publish what the service does (introspection)`;
    }
    return echo.run(io, { ...args, topic_name: topic, message_type: undefined });
  },
};

/** @param {string} text */
function positive(text) {
  const value = FLOAT.read(text);
  if (!(value > 0)) throw new Error("value must be positive");
  return value;
}

/** @type {Group} */
export const SERVICE = {
  name: "service",
  about: "Various service related sub-commands",
  shared: [flag("hidden", ["--include-hidden-services"], "Consider hidden services as well")],
  verbs: [call, echoEvents, find, info, list, type],
};
