// @ts-check
// ros2 topic hz: the rates of topics.

import { Codec } from "../../../messages/codec.js";
import { isInterrupt, DIRECT, flag, option } from "../verb.js";
import { expression } from "./expression.js";
import { awaitType, follow, QOS, Times, windowOption } from "./measure.js";

/** @import { Verb } from "../verb.js" */

/** @type {Verb} */
export const hz = {
  name: "hz",
  about: "Print the average publishing rate to screen",
  args: [
    { name: "topic_name", count: "+", help: "Names of the ROS topic to listen to (e.g. '/chatter')", complete: "topic" },
    windowOption("window size, in # of messages, for calculating rate ", 10_000, { metavar: "WINDOW" }),
    option("filter_expr", ["--filter"], "only measure messages matching the specified Python expression", { metavar: "EXPR" }),
    flag("wall_time", ["--wall-time"], "calculates rate using wall time which can be helpful when clock is not published during simulation"),
    ...DIRECT,
    ...QOS,
  ],
  async run(io, args) {
    const { ros, out } = io;
    const codec = new Codec(ros.types);
    const filter = args.filter_expr === undefined ? undefined : expression(args.filter_expr);
    /** @type {string[]} */
    const names = args.topic_name;
    /** @type {(ReturnType<typeof measure> & {name: string, type: string})[]} */
    const measured = [];
    for (const name of names) {
      const type = await awaitType(io, name);
      measured.push({ name, type, ...measure(args.window, (bytes) => !filter || filter(codec.read(type, bytes), type, ros.types)) });
      if (names.length > 1) await out(`Subscribed to [${name}]\n`);
    }
    try {
      await follow(io, args, measured, () => {
        const rates = measured.flatMap(({ name, times }) => {
          const found = times.read();
          return found?.fresh ? [{ name, ...found }] : [];
        });
        return names.length > 1 ? table(rates) : rates.map(line).join("");
      });
    } catch (error) {
      // Upstream ends in good order once it has subscribed.
      if (!isInterrupt(error)) throw error;
    }
  },
};

/** @param {number} size of the window @param {(bytes: Uint8Array) => boolean} counts whether a message does */
function measure(size, counts) {
  const times = new Times(size);
  let last = 0;
  return {
    times,
    take(/** @type {Uint8Array} */ bytes, /** @type {{received: number}} */ { received }) {
      if (!counts(bytes)) return;
      if (last) times.add((received - last) / 1000);
      last = received;
    },
  };
}

/** @typedef {{name: string, count: number, mean: number, deviation: number, least: number, most: number}} Rate */

/** @param {number} mean */
function rate(mean) {
  return (mean > 0 ? 1 / mean : 0).toFixed(3);
}

/** @param {Rate} found */
function line({ count, mean, least, most, deviation }) {
  return `average rate: ${rate(mean)}\n\tmin: ${least.toFixed(3)}s max: ${most.toFixed(3)}s std dev: ${deviation.toFixed(5)}s window: ${count}\n`;
}

const HEADS = ["topic", "rate", "min_delta", "max_delta", "std_dev", "window"];

/** The rates of several topics. @param {Rate[]} rates */
function table(rates) {
  if (!rates.length) return "";
  const rows = rates.map(({ name, count, mean, least, most, deviation }) =>
    [name, rate(mean), least.toFixed(3), most.toFixed(3), deviation.toFixed(5), String(count)]);
  const widths = HEADS.map((head, column) => Math.max(head.length, ...rows.map((row) => row[column]?.length ?? 0)));
  const heads = HEADS.map((head, column) => centered(head, widths[column] ?? 0));
  const lines = rows.map((row) => row.map((cell, column) => cell.padEnd(widths[column] ?? 0)).join("   "));
  const rule = "=".repeat(widths.reduce((sum, width) => sum + width, 0) + 3 * (HEADS.length - 1));
  return `${[heads.join("   "), rule, ...lines].join("\n")}\n\n`;
}

/** str.center() of Python. @param {string} text @param {number} width */
function centered(text, width) {
  const space = Math.max(0, width - text.length);
  const before = Math.floor(space / 2) + (space & width & 1);
  return `${" ".repeat(before)}${text}${" ".repeat(space - before)}`;
}
