// @ts-check
// ros2 bag play: play a bag into the graph of the page, with the keys of rosbag2.

import { INT } from "../../args/types.js";
import { Failure, pause } from "../../shell/shell.js";
import { absolute, flag, isInterrupt, option } from "../verb.js";
import { checkRegex, error, log, openBag, READER } from "./open.js";

/** @import { Playback } from "../../../bag/playback.js" */
/** @import { Io } from "../../shell/shell.js" */
/** @import { Verb } from "../verb.js" */

const NODE = "rosbag2_player";
// As often as upstream's --clock without a number, in Hz.
const CLOCK = 40;
const KEYS = [
  "Adding keyboard callbacks.", "Press SPACE for Pause/Resume", "Press CURSOR_RIGHT for Play Next Message",
  "Press CURSOR_UP for Increase Rate 10%", "Press CURSOR_DOWN for Decrease Rate 10%",
];

/** @type {import("../../args/parse.js").Type} */
const POSITIVE = { name: "float", read: (text) => number(text, "> 0.0", (value) => value > 0) };
/** @type {import("../../args/parse.js").Type} */
const NATURAL = { name: "float", read: (text) => number(text, ">= 0.0", (value) => value >= 0) };

/** @type {import("../../args/parse.js").Type} */
const DECIMAL = { name: "float", read: (text) => number(text, "any", () => true) };

/** @type {Verb} */
export const play = {
  name: "play",
  about: "Play back ROS data from a bag",
  args: [
    ...READER,
    option("queue", ["--read-ahead-queue-size"], "Messages that are read ahead. A page reads ahead by itself, so this has no effect.", { type: INT }),
    option("rate", ["-r", "--rate"], "Rate at which to play back messages. Valid range > 0.0.", { type: POSITIVE, initial: 1 }),
    option("topics", ["--topics"], "Topics to replay, separated by spaces. At least one topic needs to be specified. If this parameter isn't specified, all topics will be replayed.", { count: "+", complete: "topic" }),
    option("regex", ["-e", "--regex"], "Replay only topics that match this regular expression."),
    option("exclude_regex", ["-x", "--exclude-regex"], "Leave out topics that match this regular expression."),
    option("exclude_topics", ["--exclude-topics"], "Topics not to replay, separated by spaces.", { count: "+" }),
    flag("loop", ["-l", "--loop"], "Start over at the end of the bag, until it is interrupted."),
    option("remap", ["-m", "--remap"], "Topics to be remapped, in the form 'old_topic1:=new_topic1 old_topic2:=new_topic2'.", { count: "+" }),
    option("clock", ["--clock"], "Publish to /clock at this frequency in Hz, 40 by default, as a source of ROS time. Without the option, it is not published.", { count: "?", type: POSITIVE, alone: CLOCK }),
    option("delay", ["-d", "--delay"], "Seconds to wait before playing.", { type: NATURAL, initial: 0 }),
    flag("keyless", ["--disable-keyboard-controls"], "Do not let keys control the player."),
    flag("paused", ["-p", "--start-paused"], "Start the player paused."),
    option("start_offset", ["--start-offset"], "Start this many seconds into the bag.", { type: NATURAL, initial: 0 }),
    option("duration", ["--playback-duration"], "Seconds to play; all if this is negative, which is the default. With an end as well, the later of both counts.", { type: DECIMAL, initial: -1 }),
    option("until", ["--playback-until-sec"], "Time at which playing ends, in seconds since 1970; at the end of the bag if this is negative, which is the default.", { type: DECIMAL, initial: -1 }),
  ],
  async run(io, args) {
    checkRegex(args.regex);
    checkRegex(args.exclude_regex);
    const topics = args.topics.map(absolute);
    const { name, playback } = await openBag(io, "play", args.bag_path, {
      topics: topics.length ? topics : undefined, regex: args.regex, exclude: args.exclude_topics.map(absolute),
      excludeRegex: args.exclude_regex, remap: remaps(args.remap), clock: args.clock ?? false, loop: args.loop, rate: args.rate,
    });
    try {
      await tell(io, playback, name, topics);
      return await attend(io, playback, args);
    } finally {
      playback.close();
    }
  },
};

/** @param {string} text @param {string} range @param {(value: number) => boolean} test */
function number(text, range, test) {
  const value = text.trim() ? Number(text) : NaN;
  if (Number.isNaN(value)) throw new Error(`${text} is not the valid type (float)`);
  if (!test(value) || value === Infinity) throw new Error(`${text} is not in the valid range (${range})`);
  return value;
}

/** @param {string[]} rules */
function remaps(rules) {
  return Object.fromEntries(rules.map((rule) => {
    const [, from, to] = /^([\w/~]+):=([\w/~]+)$/.exec(rule) ?? [];
    if (!from || !to) throw new Failure(error(`'${rule}' is not a remapping of the form old:=new`));
    return [absolute(from), absolute(to)];
  }));
}

/** Say what is played, and what is not. @param {Io} io @param {Playback} playback @param {string} name @param {string[]} topics */
async function tell(io, { summary, refused }, name, topics) {
  await log(io, "INFO", "rosbag2_storage", `Opened database '${name}' for READ_ONLY.`);
  const tracks = summary?.tracks ?? [];
  for (const { id, topic } of tracks) {
    const why = refused.get(id);
    if (why) await log(io, "WARN", NODE, `Ignoring a topic '${topic}', reason: ${why}.`);
  }
  for (const topic of topics) {
    if (!tracks.some((track) => track.topic === topic)) await log(io, "WARN", NODE, `The bag has no topic '${topic}'.`);
  }
}

/** Play until the end or Ctrl-C. @param {Io} io @param {Playback} playback @param {any} args */
async function attend(io, playback, args) {
  const { rate, delay, keyless, paused } = args;
  await log(io, "INFO", NODE, `Set rate to ${rate}`);
  const { signal, keys } = io;
  const giving = keys && !keyless;
  // Before they are told, so that none is lost.
  const endKeys = giving ? keys(controls(io, playback, rate, !paused)) : () => {};
  if (giving) for (const text of KEYS) await log(io, "INFO", NODE, text);
  try {
    await pause(delay * 1000, signal);
    playback.setPart(partOf(args, (playback.summary?.start ?? 0) / 1000));
    if (!paused) playback.play();
    await ended(playback, signal);
  } catch (reason) {
    // As upstream, which ends in good order.
    if (isInterrupt(reason)) return 0;
    throw reason;
  } finally {
    endKeys();
  }
  return 0;
}

/** Return the part to play: of two ends, the later one counts. @param {any} args @param {number} start of the bag, in s since 1970 */
function partOf({ start_offset: from, duration, until }, start) {
  const ends = [...(duration < 0 ? [] : [from + duration]), ...(until < 0 ? [] : [until - start])];
  return ends.length > 0 ? { from, to: Math.max(from, ...ends) } : { from };
}

/** @param {Playback} playback @param {AbortSignal} signal @returns {Promise<void>} */
function ended(playback, signal) {
  return new Promise((resolve, reject) => {
    const look = () => playback.state.ended && resolve();
    playback.addEventListener("state", look);
    playback.addEventListener("fail", () => reject(new Failure(error(playback.failure))));
    signal.addEventListener("abort", () => reject(signal.reason), { once: true });
    if (signal.aborted) reject(signal.reason);
    look();
  });
}

/**
 * Return what keys do. The state of the playback comes from its worker a moment later, so it is kept here.
 * @param {Io} io @param {Playback} playback @param {number} rate at the start @param {boolean} playing at the start
 */
function controls(io, playback, rate, playing) {
  const say = (/** @type {string} */ text) => log(io, "INFO", NODE, text);
  const change = (/** @type {number} */ factor) => {
    rate *= factor;
    playback.setRate(rate);
    say(`Set rate to ${Number(rate.toPrecision(6))}`);
  };
  /** @type {Record<string, () => void>} */
  const actions = {
    "\x03": () => {
      io.err("^C\n");
      io.shell.interrupt();
    },
    " ": () => {
      playing = !playing;
      say(playing ? "Resuming play." : "Pausing play.");
      if (playing) playback.play();
      else playback.pause();
    },
    "\x1b[C": () => playback.step(),
    "\x1b[A": () => change(1.1),
    "\x1b[B": () => change(0.9),
  };
  return (/** @type {string} */ data) => {
    for (const [key] of data.matchAll(/\x1b\[[A-Z]|[^]/g)) actions[key]?.();
  };
}
