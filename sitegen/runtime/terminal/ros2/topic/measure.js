// @ts-check
// ros2 topic hz, bw and delay.

import { Codec } from "../../../messages/codec.js";
import { Failure, pause } from "../../shell/shell.js";
import { absolute, checkName, DISCOVERY, fittingQos, flag, option, QOS_OPTIONS, qosOf, until } from "../verb.js";

/** @import { MessageInfo } from "../../../protocol.js" */
/** @import { Io } from "../../shell/shell.js" */
/** @import { Verb } from "../verb.js" */

/** @type {import("../../args/parse.js").Type} */
const POSITIVE = { name: "positive_int", read: (text) => {
  if (!/^\d+$/.test(text) || Number(text) <= 0) throw new Error("value must be a positive integer");
  return Number(text);
} };
const WINDOW = (/** @type {number} */ initial) =>
  option("window", ["--window", "-w"], `window size, in # of messages, for calculating rate, string to (default: ${initial})`, { metavar: "WINDOW", type: POSITIVE, initial });
const TOPIC = /** @type {const} */ ({ name: "topic_name", complete: "topic" });

/** @type {Verb} */
export const hz = {
  name: "hz",
  about: "Print the average publishing rate to screen",
  args: [
    ...DISCOVERY,
    { ...TOPIC, help: "Name of the ROS topic to listen to (e.g. '/chatter')" },
    WINDOW(10_000),
    option("filter", ["--filter"], "only measure messages matching the specified Python expression", { metavar: "EXPR" }),
    flag("wall_time", ["--wall-time"], "calculates rate using wall time which can be helpful when clock is not published during simulation"),
    ...QOS_OPTIONS,
  ],
  async run(io, args) {
    if (args.filter) throw new Failure("ros2 topic hz: --filter takes Python, which this terminal does not run");
    const times = new Times(args.window);
    let last = 0;
    await follow(io, args, (_, { received }) => {
      if (last) times.add((received - last) / 1000);
      last = received;
    }, () => {
      const { count, mean, least, most, deviation } = times.read();
      if (!count) return "";
      return `average rate: ${(mean > 0 ? 1 / mean : 0).toFixed(3)}\n\tmin: ${least.toFixed(3)}s max: ${most.toFixed(3)}s std dev: ${deviation.toFixed(5)}s window: ${count}\n`;
    });
  },
};

/** @type {Verb} */
export const delay = {
  name: "delay",
  about: "Display delay of topic from timestamp in header",
  args: [...DISCOVERY, { ...TOPIC, help: "Topic name to calculate the delay for" }, WINDOW(10_000), ...QOS_OPTIONS],
  async run(io, args) {
    const times = new Times(args.window);
    const { ros } = io;
    const codec = new Codec(ros.types);
    const type = ros.graph.topics().find(({ name }) => name === absolute(args.topic_name))?.types[0] ?? "";
    if (type && !ros.types[type]?.fields.some(({ name, type: of }) => name === "header" && of === "std_msgs/msg/Header")) {
      throw new Failure("msg does not have header");
    }
    await follow(io, args, (bytes, { received }) => {
      const { stamp } = codec.read(type, bytes).header;
      times.add(received / 1000 - stamp.sec - stamp.nanosec / 1e9);
    }, () => {
      const { count, mean, least, most, deviation } = times.read();
      if (!count) return "";
      return `average delay: ${mean.toFixed(3)}\n\tmin: ${least.toFixed(3)}s max: ${most.toFixed(3)}s std dev: ${deviation.toFixed(5)}s window: ${count}\n`;
    });
  },
};

/** @type {Verb} */
export const bw = {
  name: "bw",
  about: "Display bandwidth used by topic",
  args: [...DISCOVERY, { ...TOPIC, help: "Topic name to monitor for bandwidth utilization" }, WINDOW(100), ...QOS_OPTIONS],
  async run(io, args) {
    /** @type {{time: number, size: number}[]} */
    let found = [];
    await follow(io, args, (bytes, { received }) => {
      found.push({ time: received, size: bytes.length });
      if (found.length > 2 * args.window) found = found.slice(-args.window);
    }, () => {
      const all = found.slice(-args.window);
      const [first] = all;
      if (!first || all.length < 2) return "";
      const sizes = all.map(({ size }) => size);
      const total = sizes.reduce((sum, size) => sum + size, 0);
      const rate = total / ((performance.timeOrigin + performance.now() - first.time) / 1000);
      const [by, unit] = rate < 1000 ? [1, "B"] : rate < 1e6 ? [1e3, "KB"] : [1e6, "MB"];
      const text = (/** @type {number} */ value) => `${(value / by).toFixed(2)} ${unit}`;
      return `${text(rate)}/s from ${all.length} messages\n\tMessage size mean: ${text(total / all.length)} min: ${text(Math.min(...sizes))} max: ${text(Math.max(...sizes))}\n`;
    }, (topic) => `Subscribed to [${topic}]\n`);
  },
};

/**
 * Take the messages of a topic and print a summary each second, until Ctrl-C.
 * @param {Io} io @param {any} args
 * @param {(bytes: Uint8Array, info: MessageInfo) => void} take
 * @param {() => string} summary "" to print nothing
 * @param {(topic: string) => string} [begin] what to print first
 */
async function follow(io, args, take, summary, begin = () => "") {
  const { ros, signal, out } = io;
  checkName(args.topic_name, "topic");
  const topic = absolute(args.topic_name);
  const type = () => ros.graph.topics().find(({ name }) => name === topic)?.types[0] ?? "";
  if (!type()) {
    await out(`WARNING: topic [${topic}] does not appear to be published yet\n`);
    await until(io, () => type() !== "");
  }
  let [fresh, failed] = [false, /** @type {unknown} */ (undefined)];
  const end = ros.subscribeBytes(topic, type(), (bytes, info) => {
    try {
      take(bytes, info);
    } catch (error) {
      failed = error;
    }
    fresh = true;
  }, qosOf(args, { ...fittingQos(ros, topic), depth: 1000 }));
  try {
    await out(begin(topic));
    for (;;) {
      await pause(1000, signal);
      if (failed) throw failed;
      // As upstream, which prints when a message has come.
      if (fresh) await out(summary());
      fresh = false;
    }
  } finally {
    end();
  }
}

/** The last values, and their statistics. */
class Times {
  #window;
  /** @type {number[]} */
  #values = [];

  /** @param {number} window */
  constructor(window) {
    this.#window = window;
  }

  /** @param {number} value */
  add(value) {
    this.#values.push(value);
    if (this.#values.length > 2 * this.#window) this.#values = this.#values.slice(-this.#window);
  }

  read() {
    const all = this.#values.slice(-this.#window);
    const count = all.length;
    const mean = all.reduce((sum, value) => sum + value, 0) / (count || 1);
    const deviation = Math.sqrt(all.reduce((sum, value) => sum + (value - mean) ** 2, 0) / (count || 1));
    const [least, most] = all.reduce(([low, high], value) => [Math.min(low, value), Math.max(high, value)], [Infinity, -Infinity]);
    return { count, mean, deviation, least, most };
  }
}
