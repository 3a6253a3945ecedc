// @ts-check
// What `ros2 topic hz`, `bw` and `delay` share: a subscription, and a summary each second.

import { pause } from "../../shell/shell.js";
import { POSITIVE_INT } from "../../args/types.js";
import { qosOptions, subscriptionQos } from "../qos.js";
import { absolute, checkName, option, until } from "../verb.js";
import { typeOfTopic } from "./echo.js";

/** @import { MessageInfo } from "../../../protocol.js" */
/** @import { Argument } from "../../args/parse.js" */
/** @import { Io } from "../../shell/shell.js" */

/** Messages of a fast topic, while the page draws. */
const DEPTH = 1000;

/** QoS options, which these verbs have since Kilted. */
export const QOS = qosOptions("subscribe", "sensor_data");

/** @param {string} help @param {number} initial @param {Partial<Argument>} [more] */
export function windowOption(help, initial, more) {
  return option("window", ["--window", "-w"], `${help}(default: ${initial})`, { type: POSITIVE_INT, initial, ...more });
}

/**
 * Wait until a topic is published, and return its type. @param {Io} io @param {string} name as it was given
 */
export async function awaitType(io, name) {
  checkName(name, "topic");
  const known = () => typeOfTopic(io.ros, name);
  if (!known()) {
    await io.out(`WARNING: topic [${name}] does not appear to be published yet\n`);
    await until(io, () => known() !== "");
  }
  return known();
}

/**
 * Take the messages of topics, and print a summary each second, until Ctrl-C.
 * @param {Io} io @param {any} args
 * @param {{name: string, type: string, take(bytes: Uint8Array, info: MessageInfo): void}[]} topics
 * @param {() => string} summary "" to print nothing
 */
export async function follow(io, args, topics, summary) {
  /** @type {(() => void)[]} */
  const ends = [];
  /** @type {unknown} */
  let failed;
  try {
    for (const { name, type, take } of topics) {
      const qos = await subscriptionQos(io, args, absolute(name));
      if (args.qos_depth === undefined) qos.depth = DEPTH;
      ends.push(io.ros.subscribeBytes(absolute(name), type, (bytes, info) => {
        try {
          take(bytes, info);
        } catch (error) {
          failed ??= error;
        }
      }, qos));
    }
    for (;;) {
      await pause(1000, io.signal);
      if (failed) throw failed;
      await io.out(summary());
    }
  } finally {
    for (const end of ends) end();
  }
}

/** The last values, and their statistics. */
export class Times {
  #window;
  /** @type {number[]} */
  #values = [];
  #fresh = false;

  /** @param {number} window */
  constructor(window) {
    this.#window = window;
  }

  /** @param {number} value */
  add(value) {
    this.#values.push(value);
    this.#fresh = true;
    if (this.#values.length > 2 * this.#window) this.#values = this.#values.slice(-this.#window);
  }

  /** Return the statistics: undefined if there is no value, and `fresh` if there is one since the last call. */
  read() {
    const all = this.#values.slice(-this.#window);
    const count = all.length;
    if (!count) return undefined;
    const fresh = this.#fresh;
    this.#fresh = false;
    const mean = all.reduce((sum, value) => sum + value, 0) / count;
    const deviation = Math.sqrt(all.reduce((sum, value) => sum + (value - mean) ** 2, 0) / count);
    const [least, most] = all.reduce(([low, high], value) => [Math.min(low, value), Math.max(high, value)], [Infinity, -Infinity]);
    return { count, mean, deviation, least, most, fresh };
  }
}
