// @ts-check
// ros2 service: list, types, calls and events of services.

import { FLOAT } from "../args/types.js";
import { serviceNames } from "../args/words.js";
import { Failure, pause } from "../shell/shell.js";
import { populated } from "./populate.js";
import { repr } from "./python.js";
import { qosOptions } from "./qos.js";
import { echoEvents } from "./service/echo.js";
import { endpointInfo } from "./topic/list.js";
import { fitted, valuesOf } from "./topic/pub.js";
import { absolute, checkName, DISCOVERY, endpoints, flag, fullType, isHidden, isType, option, until } from "./verb.js";

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
  args: [{ name: "service_name", help: "Name of the ROS service to get type (e.g. '/talker/list_parameters')", complete: "service" }],
  async run({ ros, out }, { service_name: name, hidden }) {
    const service = services(ros, hidden).find((one) => one.name === name);
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
    ...DISCOVERY,
    { name: "service_name", help: "Name of the ROS service to get info (e.g. '/add_two_ints')", complete: "service" },
    flag("verbose", ["--verbose", "-v"], "Prints detailed information like the node name, node namespace, topic type, topic type hash, GUID, and QoS Profile of the clients and servers to this service"),
  ],
  async run({ ros, out, shell }, { service_name: name, verbose, hidden }) {
    const service = ros.graph.services().find((one) => one.name === name && (hidden || !isHidden(name)));
    if (!service) return `Unknown service '${name}'`;
    const { types, clients, servers } = service;
    const end = verbose ? "\n\n" : "\n";
    const hashes = verbose ? await shell.interfaces.hashes() : {};
    const described = async (/** @type {"client" | "service"} */ kind) => {
      if (!verbose) return;
      for (const one of endpoints(ros, { kind, name })) await out(`${endpointInfo(one, "Service", hashes)}${end}`);
    };
    await out(`Type: ${types.length === 1 ? types[0] : `[${types.map((one) => `'${one}'`).join(", ")}]`}\n`);
    await out(`Clients count: ${clients.length}${end}`);
    await described("client");
    await out(`Services count: ${servers.length}${end}`);
    await described("service");
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
    { name: "values", count: "?", initial: "{}", group: "values", help: "Values to fill the service request with in YAML format (e.g. '{a: 1, b: 2}'), otherwise the service request will be published with default values", complete: "serviceRequest" },
    flag("stdin", ["--stdin"], "Read values from standard input", { group: "values" }),
    option("rate", ["-r", "--rate"], "Repeat the call at a specific rate in Hz", { metavar: "N", type: FLOAT }),
    ...qosOptions("publish", "default"),
  ],
  async run(io, args) {
    const { service_name: given, service_type: typeGiven, rate } = args;
    const { ros, out, signal } = io;
    if (rate !== undefined && !(rate > 0)) throw new Failure("rate must be greater than zero");
    checkName(given, "service");
    const name = absolute(given);
    const service = fullType(typeGiven, "srv");
    if (isType(ros, service) && !isType(ros, `${service}_Request`)) throw new Failure("The passed type is not a service");
    if (!isType(ros, `${service}_Request`)) throw new Failure("The passed service type is invalid");
    const values = await valuesOf(io, args);
    const { message: request } = fitted("Failed to populate field: ", () => populated(values, `${service}_Request`, ros.types));
    const ready = () => endpoints(ros, { kind: "service", name }).some((one) => one.type === service);
    if (!ready()) await out("waiting for service to become available...\n");
    for (;;) {
      const begun = performance.now();
      await until(io, ready);
      await out(`requester: making request: ${repr(request, `${service}_Request`, ros.types)}\n\n`);
      const response = await ros.call(name, service, request, Infinity, signal);
      await out(`response:\n${repr(response, `${service}_Response`, ros.types)}\n\n`);
      if (rate === undefined) return;
      await pause(Math.max(0, begun + 1000 / rate - performance.now()), signal);
    }
  },
};

/** @type {Group} */
export const SERVICE = {
  name: "service",
  about: "Various service related sub-commands",
  shared: [flag("hidden", ["--include-hidden-services"], "Consider hidden services as well")],
  verbs: [call, echoEvents, find, info, list, type],
};
