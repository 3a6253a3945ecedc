// @ts-check
// ros2 bag record: record topics to a bag, which the browser keeps.

import { Recording } from "../../../bag/recording.js";
import { folderOfPage, freshName } from "../../../bag/store.js";
import { INT } from "../../args/types.js";
import { Broken } from "../../shell/pipe.js";
import { Failure } from "../../shell/shell.js";
import { absolute, checkName, flag, option } from "../verb.js";
import { checkRegex, error, log } from "./open.js";

/** @import { Wanted } from "../../../bag/orders.js" */
/** @import { Io } from "../../shell/shell.js" */
/** @import { Verb } from "../verb.js" */

const NODE = "rosbag2_recorder";
// The largest recording without --max-bag-size, in bytes: as of the panel.
const LARGEST = 1e9;

/** @type {Verb} */
export const record = {
  name: "record",
  about: "Record ROS data to a bag",
  args: [
    { name: "positional", metavar: "topics", count: "*", help: "Topics to record, as of --topics.", complete: "topic" },
    option("output", ["-o", "--output"], "Name of the bag to create, defaults to one with the time."),
    option("storage", ["-s", "--storage"], "Storage identifier to be used, defaults to 'mcap'.", { choices: ["mcap"], initial: "mcap" }),
    option("topics", ["--topics"], "Space-delimited list of topics to record.", { count: "+", complete: "topic" }),
    flag("all", ["-a", "--all"], "Record all topics (Exclude hidden topic)."),
    flag("all_topics", ["--all-topics"], "Record all topics (Exclude hidden topic)."),
    option("regex", ["-e", "--regex"], "Record only topics containing provided regular expression. Note: --all and --all-topics will override --regex."),
    option("exclude_regex", ["-x", "--exclude", "--exclude-regex"], "Exclude topics containing provided regular expression."),
    option("exclude_topics", ["--exclude-topics"], "Space-delimited list of topics not being recorded.", { count: "+", complete: "topic" }),
    flag("hidden", ["--include-hidden-topics"], "Discover and record hidden topics as well."),
    option("size", ["-b", "--max-bag-size"], "Size in bytes at which the recording ends. Default: 0, which is 1 GB. A page does not split bags.", { type: INT, initial: 0 }),
  ],
  async run(io, args) {
    const wanted = wantedBy(args);
    const name = await nameFor(io, args.output);
    if (args.size > 0) await log(io, "WARN", NODE, `A page does not split bags: the recording ends at ${args.size} bytes.`);
    await log(io, "INFO", "rosbag2_storage", `Opened database '${name}' for READ_WRITE.`);
    const recording = new Recording(io.ros, folderOfPage(), name, wanted);
    await attend(io, recording, wanted);
    const { reason, size, limit, count, blob } = recording;
    if (blob) io.shell.bags.add(name, blob);
    if (reason) await log(io, size < limit ? "ERROR" : "WARN", NODE, reason);
    await log(io, "INFO", NODE, "Recording stopped");
    await io.err(`${count} messages, ${size} bytes ${blob ? "in memory only, until the page is closed" : "in this browser"}. Save them with: save ${name}\n`, "faint");
    return reason && size < limit ? 1 : 0;
  },
};

/** @param {any} args @returns {Wanted} */
function wantedBy({ positional, topics: named, all, all_topics: every, regex, exclude_regex: excludeRegex, exclude_topics: excluded, hidden, size }) {
  const topics = [...positional, ...named];
  for (const topic of topics) checkName(topic, "topic");
  checkRegex(regex);
  checkRegex(excludeRegex);
  if (!all && !every && !topics.length && !regex) {
    throw new Failure(error("Need to specify at least one option out of --all, --all-topics, --topics or --regex"));
  }
  if (size < 0) throw new Failure(error(`--max-bag-size: ${size} is negative`));
  const some = all || every ? {} : { topics: topics.length ? topics.map(absolute) : undefined, regex };
  return { ...some, exclude: excluded.map(absolute), excludeRegex, hidden, limit: size || LARGEST, compress: true };
}

/** Return the name of the file. @param {Io} io @param {string | undefined} given */
async function nameFor({ shell }, given) {
  const plain = given?.replace(/^\.\//, "").replace(/\/+$/, "").replace(/\.mcap$/, "");
  if (plain !== undefined && !/^\w[\w.-]{0,99}$/.test(plain)) {
    throw new Failure(error(`Output folder '${given}' needs a name of letters, digits, '_', '-' and '.': there are no folders here`));
  }
  const name = plain === undefined ? freshName() : `${plain}.mcap`;
  // Also a bag of the site: each name means one bag.
  if (await shell.bags.find(name)) throw new Failure(error(`Output folder '${plain ?? name}' already exists.`));
  return name;
}

/** Tell what is recorded, until it ends. @param {Io} io @param {Recording} recording @param {Wanted} wanted */
async function attend(io, recording, { topics, regex }) {
  const missing = new Set(topics);
  const tell = (/** @type {string} */ text) => log(io, "INFO", NODE, text).catch((reason) => {
    if (!(reason instanceof Broken)) throw reason;
    recording.stop();
  });
  const stop = () => recording.stop();
  const flush = () => recording.flush();
  recording.addEventListener("topic", (event) => {
    const { detail } = /** @type {CustomEvent<string>} */ (event);
    tell(`Subscribed to topic '${detail}'`);
    if (missing.delete(detail) && !missing.size && !regex) tell("All requested topics are subscribed. Stopping discovery...");
  });
  const ended = new Promise((resolve) => recording.addEventListener("end", resolve, { once: true }));
  // What waits to be written is not lost if the page ends.
  addEventListener("pagehide", flush);
  document.addEventListener("visibilitychange", flush);
  io.signal.addEventListener("abort", stop);
  if (io.signal.aborted) stop();
  await tell("Listening for topics...");
  await tell("Recording...");
  await ended;
  io.signal.removeEventListener("abort", stop);
  document.removeEventListener("visibilitychange", flush);
  removeEventListener("pagehide", flush);
}
