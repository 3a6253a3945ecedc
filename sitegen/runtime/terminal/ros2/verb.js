// @ts-check
// What a verb of `ros2` is, and what several of them need.

import { Failure, Interrupt, pause } from "../shell/shell.js";
import { DEFAULT_QOS } from "../../protocol.js";

/** @import { Endpoint, Qos, Ros } from "../../protocol.js" */
/** @import { Argument } from "../args/parse.js" */
/** @import { Io } from "../shell/shell.js" */

/**
 * A verb: `about` is its line in the help of the command. `run` returns the status, or a text that says what failed.
 * @typedef {{name: string, about: string, args: Argument[],
 *   run(io: Io, args: any): Promise<number | string | void>}} Verb
 * A command of `ros2`: one with verbs, or without, such as `run`.
 * @typedef {{name: string, about: string, verbs?: Verb[], shared?: Argument[], verb?: Omit<Verb, "name" | "about">}} Group
 */

/** ros2's status after Ctrl-C: the number of the signal. */
export const SIGINT = 2;

/** @param {string} name @param {string[]} flags @param {string} help @param {Partial<Argument>} [more] @returns {Argument} */
export function flag(name, flags, help, more) {
  return { name, flags, help, count: "flag", ...more };
}

/** @param {string} name @param {string[]} flags @param {string} help @param {Partial<Argument>} [more] @returns {Argument} */
export function option(name, flags, help, more) {
  return { name, flags, help, ...more };
}

/** Options that ask for the discovery of nodes, which is immediate in a page. */
export const DISCOVERY = [
  option("spin_time", ["--spin-time"], "Spin time in seconds to wait for discovery (only applies when not using an already running daemon)"),
  flag("use_sim_time", ["-s", "--use-sim-time"], "Enable ROS simulation time"),
  flag("no_daemon", ["--no-daemon"], "Do not spawn nor use an already running daemon"),
];

/** Whether a topic, service, action or node is hidden: a part of its name begins with an underscore. @param {string} name */
export function isHidden(name) {
  return name.split("/").some((part) => part.startsWith("_"));
}

/** Return a name in the root namespace. @param {string} name */
export function absolute(name) {
  if (name.startsWith("/")) return name;
  return `/${name.replace(/^~\//, "")}`;
}

/** Throw what upstream prints about an invalid name. @param {string} name @param {string} kind */
export function checkName(name, kind) {
  const at = name.search(/[^\w/~{}]|\/\/|\/\d|^\d|\/$/);
  if (name && at < 0) return;
  throw new Failure(`Invalid ${kind} name: '${name}'${name ? `\n${" ".repeat(21 + at)}^` : ""}`);
}

/** Return the definition of a type. Throws a Failure. @param {Ros} ros @param {string} type @param {string} what failed */
export function defined(ros, type, what) {
  const found = ros.types[type];
  if (!found) throw new Failure(what);
  return found;
}

/** Return a type in its full form: std_msgs/String is short for std_msgs/msg/String. @param {string} type @param {string} kind */
export function fullType(type, kind) {
  return /^[^/]+\/[^/]+$/.test(type) ? type.replace("/", `/${kind}/`) : type;
}

/** The endpoints of a topic or service, or of a node. @param {Ros} ros @param {Partial<Endpoint>} wanted */
export function endpoints(ros, wanted) {
  return ros.graph.endpoints().filter((one) =>
    Object.entries(wanted).every(([key, value]) => one[/** @type {keyof Endpoint} */ (key)] === value));
}

/**
 * Wait until something is true of the graph.
 * @param {Io} io @param {() => boolean} test @param {number} [milliseconds] the longest time
 * @returns {Promise<boolean>} whether it is
 */
export async function until({ ros, signal }, test, milliseconds = Infinity) {
  if (test()) return true;
  const found = new AbortController();
  const look = () => test() && found.abort(new Found());
  ros.graph.addEventListener("change", look);
  try {
    await pause(Math.min(milliseconds, 2 ** 31 - 1), AbortSignal.any([signal, found.signal]));
    return test();
  } catch (error) {
    if (error instanceof Found) return true;
    throw error;
  } finally {
    ros.graph.removeEventListener("change", look);
  }
}

class Found extends Error {}

/** Wait for Ctrl-C. @param {AbortSignal} signal @returns {Promise<never>} */
export function forever(signal) {
  return new Promise((_, reject) => {
    if (signal.aborted) reject(signal.reason);
    signal.addEventListener("abort", () => reject(signal.reason), { once: true });
  });
}

/** Whether an error is Ctrl-C. @param {unknown} error */
export function isInterrupt(error) {
  return error instanceof Interrupt;
}

/** QoS options of topic commands. */
export const QOS_OPTIONS = [
  option("qos_profile", ["--qos-profile"], "Quality of service preset profile", { choices: ["unknown", "default", "system_default", "sensor_data", "services_default", "parameters", "parameter_events", "action_status_default", "best_available"] }),
  option("qos_depth", ["--qos-depth"], "Queue size setting (overrides depth value of --qos-profile option)", { metavar: "N", type: { name: "int", read: natural } }),
  option("qos_history", ["--qos-history"], "History of samples setting (overrides history value of --qos-profile option)", { choices: ["system_default", "keep_last", "keep_all", "unknown"] }),
  option("qos_reliability", ["--qos-reliability"], "Quality of service reliability setting (overrides reliability value of --qos-profile option)", { choices: ["system_default", "reliable", "best_effort", "unknown", "best_available"] }),
  option("qos_durability", ["--qos-durability"], "Quality of service durability setting (overrides durability value of --qos-profile option)", { choices: ["system_default", "transient_local", "volatile", "unknown", "best_available"] }),
];

/** @type {Record<string, Partial<Qos>>} */
const PROFILES = {
  sensor_data: { depth: 5, reliable: false },
  parameters: { depth: 1000 },
  parameter_events: { depth: 1000 },
  action_status_default: { depth: 1, transientLocal: true },
};

/**
 * Return the QoS that options ask for. @param {any} args @param {Partial<Qos>} [fitting] what fits the other side
 * @returns {Qos}
 */
export function qosOf(args, fitting = {}) {
  const qos = { ...DEFAULT_QOS, ...(args.qos_profile ? PROFILES[args.qos_profile] : fitting) };
  if (args.qos_depth !== undefined) qos.depth = args.qos_depth;
  if (args.qos_history) qos.keepAll = args.qos_history === "keep_all";
  if (args.qos_reliability) qos.reliable = args.qos_reliability === "reliable";
  if (args.qos_durability) qos.transientLocal = args.qos_durability === "transient_local";
  return qos;
}

/** @param {string} text */
function natural(text) {
  if (!/^\d+$/.test(text)) throw new Error("");
  return Number(text);
}

/**
 * Return the policies of a subscription that fit all publishers of a topic, as `ros2 topic echo` chooses them.
 * @param {Ros} ros @param {string} topic
 */
export function fittingQos(ros, topic) {
  const publishers = endpoints(ros, { kind: "publisher", name: topic });
  const all = (/** @type {"reliable" | "transientLocal"} */ policy) => publishers.length > 0 && publishers.every(({ qos }) => qos[policy]);
  return { reliable: all("reliable"), transientLocal: all("transientLocal") };
}

/** Work in slices, so that the page can draw: wait from time to time. */
export class Pace {
  #since = performance.now();

  /** @param {AbortSignal} signal */
  async wait(signal) {
    if (signal.aborted) throw signal.reason;
    if (performance.now() - this.#since < 8) return;
    await pause(8, signal);
    this.#since = performance.now();
  }
}
