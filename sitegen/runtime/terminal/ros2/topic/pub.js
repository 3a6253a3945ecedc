// @ts-check
// ros2 topic pub: publish a message, once or again and again.

import { fromYaml } from "../../../messages/yamlReader.js";
import { filled } from "../filled.js";
import { FLOAT, INT } from "../../args/parse.js";
import { Failure, pause } from "../../shell/shell.js";
import { repr } from "../python.js";
import { absolute, checkName, endpoints, flag, fullType, option, QOS_OPTIONS, qosOf, until } from "../verb.js";

/** @import { Io } from "../../shell/shell.js" */
/** @import { Verb } from "../verb.js" */

// Messages are at least so far apart (ms), which is what timers of browsers can do.
const LEAST = 4;

/** @type {import("../../args/parse.js").Type} */
const POSITIVE = { name: "positive_float", read: (text) => {
  const value = FLOAT.read(text);
  if (!(value > 0)) throw new Error("value must be positive");
  return value;
} };
/** @type {import("../../args/parse.js").Type} */
const COUNT = { name: "nonnegative_int", read: (text) => {
  const value = INT.read(text);
  if (value < 0) throw new Error("value must be positive or zero");
  return value;
} };

/** @type {Verb} */
export const pub = {
  name: "pub",
  about: "Publish a message to a topic",
  args: [
    { name: "topic_name", help: "Name of the ROS topic to publish to (e.g. '/chatter')", complete: "topic" },
    { name: "message_type", help: "Type of the ROS message (e.g. 'std_msgs/String')", complete: "topicMessage" },
    { name: "values", count: "?", initial: "{}", help: "Values to fill the message with in YAML format (e.g. 'data: Hello World'), otherwise the message will be published with default values", complete: "field" },
    option("rate", ["-r", "--rate"], "Publishing rate in Hz (default: 1)", { metavar: "N", type: POSITIVE, initial: 1 }),
    option("print", ["-p", "--print"], "Only print every N-th published message (default: 1)", { metavar: "N", type: INT, initial: 1 }),
    flag("once", ["-1", "--once"], "Publish one message and exit"),
    option("times", ["-t", "--times"], "Publish this number of times and then exit", { type: COUNT, initial: 0 }),
    option("wait", ["-w", "--wait-matching-subscriptions"], "Wait until finding the specified number of matching subscriptions. Defaults to 1 when using \"-1\"/\"--once\"/\"--times\", otherwise defaults to 0.", { metavar: "WAIT_MATCHING_SUBSCRIPTIONS", type: COUNT }),
    option("max_wait", ["--max-wait-time-secs"], "This sets the maximum wait time in seconds if --wait-matching-subscriptions is set. By default, this flag is not set meaning the subscriber will wait endlessly.", { metavar: "MAX_WAIT_TIME_SECS", type: POSITIVE }),
    option("keep_alive", ["--keep-alive"], "Keep publishing node alive for N seconds after the last msg (default: 0.1)", { metavar: "N", type: FLOAT, initial: 0.1 }),
    option("node_name", ["-n", "--node-name"], "Name of the created publishing node"),
    ...QOS_OPTIONS,
  ],
  async run(io, args) {
    const { ros } = io;
    checkName(args.topic_name, "topic");
    const topic = absolute(args.topic_name);
    const type = fullType(args.message_type, "msg");
    if (!ros.types[type]) return "The passed message type is invalid";
    const message = filled(readValues(args.values, type, io), type, ros.types);
    const publisher = ros.advertise(topic, type, qosOf(args));
    try {
      return await publish(io, args, topic, () => {
        publisher.publish(message);
        return repr(message, type, ros.types);
      });
    } finally {
      publisher.close();
    }
  },
};

/** Parse the values of a message or request. @param {string} values @param {string} type @param {Io} io */
export function readValues(values, type, { ros }) {
  try {
    return fromYaml(values, type, ros.types);
  } catch (error) {
    const said = error instanceof Error ? error.message : String(error);
    if (/^expected the fields of/.test(said)) throw new Failure("The passed value needs to be a dictionary in YAML format");
    throw new Failure(`Failed to populate field: ${said}`);
  }
}

/** @param {Io} io @param {any} args @param {string} topic @param {() => string} send returns repr() of the message */
async function publish(io, args, topic, send) {
  const { ros, out, signal } = io;
  const times = args.once ? 1 : args.times;
  const wanted = args.wait ?? (times ? 1 : 0);
  const found = () => endpoints(ros, { kind: "subscription", name: topic }).length >= wanted;
  const start = performance.now();
  while (!found()) {
    if (args.max_wait !== undefined && performance.now() - start > args.max_wait * 1000) {
      return `Timed out waiting for subscribers: Expected ${wanted} subscribers but only got ${endpoints(ros, { kind: "subscription", name: topic }).length} subscribers`;
    }
    await out(`Waiting for at least ${wanted} matching subscription(s)...\n`);
    await until(io, found, 1000);
  }
  await out("publisher: beginning loop\n");
  const period = Math.max(1000 / args.rate, LEAST);
  for (let count = 1; ; count++) {
    const begun = performance.now();
    const text = send();
    if (args.print > 0 && count % args.print === 0) await out(`publishing #${count}: ${text}\n\n`);
    if (times && count >= times) break;
    await pause(Math.max(0, period - (performance.now() - begun)), signal);
  }
  await pause(args.keep_alive * 1000, signal);
  return 0;
}
