// @ts-check
// ros2 topic pub: publish a message, once or again and again.

import { INT, POSITIVE_FLOAT } from "../../args/types.js";
import { Failure, pause } from "../../shell/shell.js";
import { isDictionary, populated, readYaml, Unfit } from "../populate.js";
import { repr } from "../python.js";
import { qosOf, qosOptions } from "../qos.js";
import { absolute, checkName, DIRECT, endpoints, flag, fullType, isType, option, Pace, standardInput, until } from "../verb.js";

/** @import { Publisher } from "../../../protocol.js" */
/** @import { Io } from "../../shell/shell.js" */
/** @import { Verb } from "../verb.js" */

// Timers of browsers are so far apart at least (ms); at a higher rate, several messages are published each time.
const LEAST = 4;

/** @type {import("../../args/parse.js").Type} */
const COUNT = { name: "nonnegative_int", read: (given) => {
  const value = INT.read(given);
  // argparse does not show the text of other errors than its own.
  if (value < 0) throw new Error("");
  return value;
} };

/** @type {Verb} */
export const pub = {
  name: "pub",
  about: "Publish a message to a topic",
  args: [
    { name: "topic_name", help: "Name of the ROS topic to publish to (e.g. '/chatter')", complete: "topic" },
    { name: "message_type", help: "Type of the ROS message (e.g. 'std_msgs/String')", complete: "topicMessage" },
    { name: "values", count: "?", initial: "{}", group: "values", help: "Values to fill the message with in YAML format (e.g. 'data: Hello World'), otherwise the message will be published with default values", complete: "field" },
    flag("stdin", ["--stdin"], "Read values from standard input", { group: "values" }),
    option("rate", ["-r", "--rate"], "Publishing rate in Hz (default: 1)", { metavar: "N", type: POSITIVE_FLOAT, initial: 1 }),
    option("print", ["-p", "--print"], "Only print every N-th published message (default: 1)", { metavar: "N", type: INT, initial: 1 }),
    flag("once", ["-1", "--once"], "Publish one message and exit", { group: "times" }),
    option("times", ["-t", "--times"], "Publish this number of times and then exit", { type: COUNT, initial: 0, group: "times" }),
    option("wait", ["-w", "--wait-matching-subscriptions"], "Wait until finding the specified number of matching subscriptions. Defaults to 1 when using \"-1\"/\"--once\"/\"--times\", otherwise defaults to 0.", { type: COUNT, metavar: "WAIT_MATCHING_SUBSCRIPTIONS" }),
    option("max_wait", ["--max-wait-time-secs"], "This sets the maximum wait time in seconds if --wait-until-matching-subscriptions is set. By default, this flag is not set meaning the subscriber will wait endlessly.", { type: POSITIVE_FLOAT, metavar: "MAX_WAIT_TIME_SECS" }),
    option("keep_alive", ["--keep-alive"], "Keep publishing node alive for N seconds after the last msg (default: 0.1)", { metavar: "N", type: POSITIVE_FLOAT, initial: 0.1 }),
    option("node_name", ["-n", "--node-name"], "Name of the created publishing node"),
    ...qosOptions("publish", "default"),
    ...DIRECT,
  ],
  async run(io, args) {
    const { ros } = io;
    checkName(args.topic_name, "topic");
    const topic = absolute(args.topic_name);
    const type = fullType(args.message_type, "msg");
    if (!isType(ros, type)) return "The passed message type is invalid";
    const values = await valuesOf(io, args);
    if (!isDictionary(values)) return "The passed value needs to be a dictionary in YAML format";
    const own = args.node_name ? ros.node(absolute(args.node_name)) : undefined;
    const publisher = (own ?? ros).advertise(topic, type, qosOf(args));
    try {
      const problem = await awaitSubscriptions(io, args, topic);
      if (problem) return problem;
      const { message, stamps } = fitted("Failed to populate field: ", () => populated(values, type, ros.types));
      await publish(io, args, publisher, () => {
        const now = performance.timeOrigin + performance.now();
        for (const stamp of stamps) stamp({ sec: Math.floor(now / 1000), nanosec: Math.floor((now % 1000) * 1e6) });
        return { message, shown: () => repr(message, type, ros.types) };
      });
      return 0;
    } finally {
      publisher.close();
      own?.leave();
    }
  },
};

/** The values of a message, a request or a goal: from the line, or from the pipe. @param {Io} io @param {any} args */
export async function valuesOf(io, args) {
  const given = args.stdin ? await standardInput(io) : args.values ?? args.goal;
  return fitted("", () => readYaml(given));
}

/**
 * Return what `make` returns; throw what Python says of values that do not fit.
 * @template T @param {string} what failed @param {() => T} make @param {(error: Unfit) => string} [shown]
 * @returns {T}
 */
export function fitted(what, make, shown = (error) => error.message) {
  try {
    return make();
  } catch (error) {
    throw error instanceof Unfit ? new Failure(`${what}${shown(error)}`) : error;
  }
}

/** Wait as long as the options ask for; return what went wrong. @param {Io} io @param {any} args @param {string} topic */
async function awaitSubscriptions(io, args, topic) {
  const wanted = args.wait ?? (args.once || args.times ? 1 : 0);
  if (!wanted && args.max_wait !== undefined) return "--max-wait-time-secs option is only effective with --wait-matching-subscriptions, --once or --times";
  const count = () => endpoints(io.ros, { kind: "subscription", name: topic }).length;
  const end = performance.now() + (args.max_wait ?? Infinity) * 1000;
  while (count() < wanted) {
    await io.out(`Waiting for at least ${wanted} matching subscription(s)...\n`);
    const next = Math.min(performance.now() + 1000, end);
    // Timers may be early.
    while (performance.now() < next) if (await until(io, () => count() >= wanted, next - performance.now())) return "";
    // Spelled as upstream has it.
    if (next === end) return `Timed out waiting for subscribers: Expected ${wanted} subcribers but only got ${count()} subscribers`;
  }
  return "";
}

/** @param {Io} io @param {any} args @param {Publisher} publisher @param {() => {message: any, shown(): string}} next */
async function publish({ out, signal }, args, publisher, next) {
  const times = args.once ? 1 : args.times;
  await out("publisher: beginning loop\n");
  const period = 1000 / args.rate;
  const pace = new Pace();
  let due = performance.now();
  for (let count = 1; ; count++) {
    const { message, shown } = next();
    if (args.print !== 0 && count % args.print === 0) await out(`publishing #${count}: ${shown()}\n\n`);
    publisher.publish(message);
    if (times && count >= times) break;
    due += period;
    const left = due - performance.now();
    // After a pause of the page, go on at the rate instead of catching up.
    if (left < -1000) due = performance.now();
    if (left > 0) await pause(Math.max(left, period < LEAST ? LEAST : 0), signal);
    else await pace.wait(signal);
  }
  await pause(args.keep_alive * 1000, signal);
}
