// @ts-check
// ros2 topic bw: the bandwidth of a topic.

import { DIRECT } from "../verb.js";
import { awaitType, follow, QOS, windowOption } from "./measure.js";

/** @import { Verb } from "../verb.js" */

/** @type {Verb} */
export const bw = {
  name: "bw",
  about: "Display bandwidth used by topic",
  args: [
    { name: "topic", help: "Topic name to monitor for bandwidth utilization", complete: "topic" },
    windowOption("maximum window size, in # of messages, for calculating rate ", 100, { metavar: "WINDOW" }),
    ...DIRECT,
    ...QOS,
  ],
  async run(io, args) {
    const { topic: name, window: size } = args;
    const type = await awaitType(io, name);
    /** @type {{time: number, size: number}[]} */
    let found = [];
    const take = (/** @type {Uint8Array} */ bytes, /** @type {{received: number}} */ { received }) => {
      found.push({ time: received, size: bytes.length });
      if (found.length > 2 * size) found = found.slice(-size);
    };
    await io.out(`Subscribed to [${name}]\n`);
    await follow(io, args, [{ name, type, take }], () => summary(found.slice(-size)));
  },
};

/** @param {{time: number, size: number}[]} found */
function summary(found) {
  const [first] = found;
  if (!first || found.length < 2) return "";
  const sizes = found.map(({ size }) => size);
  const total = sizes.reduce((sum, size) => sum + size, 0);
  const rate = total / ((performance.timeOrigin + performance.now() - first.time) / 1000);
  const [by, unit, digits] = rate < 1000 ? [1, "B", 0] : rate < 1e6 ? [1e3, "KB", 2] : [1e6, "MB", 2];
  const text = (/** @type {number} */ value) => `${(value / by).toFixed(digits)} ${unit}`;
  const [mean, least, most] = [total / found.length, Math.min(...sizes), Math.max(...sizes)].map(text);
  return `${text(rate)}/s from ${found.length} messages\n\tMessage size mean: ${mean} min: ${least} max: ${most}\n`;
}
