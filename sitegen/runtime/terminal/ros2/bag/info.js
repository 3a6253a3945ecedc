// @ts-check
// ros2 bag info: what is in a bag.

import { flag } from "../verb.js";
import { openBag, READER } from "./open.js";

/** @import { Summary, Track } from "../../../bag/orders.js" */
/** @import { Verb } from "../verb.js" */

const EVENTS = "/_service_event";

/** @type {Verb} */
export const info = {
  name: "info",
  about: "Print information about a bag to the screen",
  args: [...READER, flag("topic_name", ["-t", "--topic-name"], "Only display topic names.")],
  async run(io, { bag_path: given, topic_name: brief }) {
    const { name, playback } = await openBag(io, "info", given);
    playback.close();
    const { summary } = playback;
    if (!summary) return;
    const topics = summary.tracks.filter((track) => !isService(track));
    if (brief) for (const { topic } of topics) await io.out(`${topic}\n`);
    else await io.out(described(name.split("/").at(-1) ?? name, summary, topics));
  },
};

/** Whether a topic has the events of a service. @param {Track} track */
function isService({ topic, type }) {
  return topic.endsWith(EVENTS) && type.includes("/srv/") && type.endsWith("_Event");
}

/** @param {string} file @param {Summary} summary @param {Track[]} topics */
function described(file, { from, to, count, size, tracks }, topics) {
  const services = tracks.filter(isService);
  const topicLines = topics.map(({ topic, type, count: own, why }) =>
    `Topic: ${topic} | Type: ${type} | Count: ${own} | Serialization Format: ${why ? "unknown" : "cdr"}\n`);
  const serviceLines = services.map(({ topic, type, count: own }) =>
    `Service: ${topic.slice(0, -EVENTS.length)} | Type: ${type.slice(0, -"_Event".length)} | Event Count: ${own} | Serialization Format: cdr\n`);
  const facts = {
    Files: file, "Bag size": sizeText(size), "Storage id": "mcap",
    // It is in the metadata of the folder, which is not in the file.
    "ROS Distro": "unknown",
    Duration: `${seconds(to - from)}s`, Start: timeText(from), End: timeText(to), Messages: count,
  };
  return [
    "\n", ...Object.entries(facts).map(([key, value]) => `${`${key}:`.padEnd(19)}${value}\n`),
    "Topic information: ", topicLines.join(" ".repeat(19)) || "\n",
    `Service:           ${services.length}\n`,
    "Service information: ", serviceLines.join(" ".repeat(21)) || "\n",
  ].join("");
}

/** @param {bigint} nanoseconds */
function seconds(nanoseconds) {
  return `${nanoseconds / 1_000_000_000n}.${fraction(nanoseconds)}`;
}

/** @param {bigint} nanoseconds */
function fraction(nanoseconds) {
  return String(nanoseconds % 1_000_000_000n).padStart(9, "0");
}

/** A time of the clock as C++'s "%b %e %Y %H:%M:%S" has it. @param {bigint} nanoseconds */
function timeText(nanoseconds) {
  const date = new Date(Number(nanoseconds / 1_000_000n));
  const [, month, , year] = date.toString().split(" ");
  const time = date.toTimeString().slice(0, 8);
  return `${month} ${String(date.getDate()).padStart(2)} ${year} ${time}.${fraction(nanoseconds)} (${seconds(nanoseconds)})`;
}

/** @param {number} bytes */
function sizeText(bytes) {
  const units = ["B", "KiB", "MiB", "GiB", "TiB"];
  let [size, unit] = [bytes, 0];
  while (size >= 1024 && unit < units.length - 1) {
    size /= 1024;
    unit += 1;
  }
  return `${size.toFixed(unit ? 1 : 0)} ${units[unit]}`;
}
