// @ts-check
// What a verb of `ros2` is, and what several of them need.

import { Failure, Interrupt, pause } from "../shell/shell.js";
import { FLOAT } from "../args/types.js";

/** @import { Endpoint, Ros } from "../../protocol.js" */
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

/** Options of verbs with a node of their own; in a page, all nodes are known at once. */
export const DIRECT = [
  option("spin_time", ["--spin-time"], "Spin time in seconds to wait for discovery (only applies when not using an already running daemon)", { type: FLOAT, initial: 0.5 }),
  flag("use_sim_time", ["-s", "--use-sim-time"], "Enable ROS simulation time"),
];

/** Options of verbs that ask upstream's daemon. */
export const DISCOVERY = [...DIRECT, flag("no_daemon", ["--no-daemon"], "Do not spawn nor use an already running daemon")];

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

/** Whether there is a type of this name. @param {Ros} ros @param {string} name */
export function isType(ros, name) {
  return Object.hasOwn(ros.types, name);
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

/**
 * A verb that a page does not have: it takes its arguments, and says so. @param {string} group @param {string} name
 * @param {string} about @param {string} instead what to do @param {Argument[]} args @returns {Verb}
 */
export function absent(group, name, about, instead, args) {
  return {
    name, about, args,
    async run() {
      throw new Failure(`ros2 ${group} ${name} is not available in a page: ${instead}`);
    },
  };
}

/** Return all that comes through a pipe or from a file. @param {Io} io */
export async function standardInput({ input, signal }) {
  if (!input) throw new Failure("--stdin: put a command and | before this one, or < and a file behind it");
  const lines = [];
  for await (const line of input.lines(signal)) lines.push(line);
  return lines.join("\n");
}

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
