// @ts-check
// What the verbs of `ros2 bag` share: bags by name, and lines as the loggers of rosbag2 print them.

import { Playback } from "../../../bag/playback.js";
import { Failure } from "../../shell/shell.js";
import { option } from "../verb.js";

/** @import { Playing } from "../../../bag/orders.js" */
/** @import { Argument } from "../../args/parse.js" */
/** @import { Io } from "../../shell/shell.js" */

// As of argparse.
const WRONG = 2;

/** The bag of a verb that reads one, and its storage. @type {Argument[]} */
export const READER = [
  { name: "bag_path", help: "Bag to open", complete: "bag" },
  option("storage", ["-s", "--storage"], "Storage identifier to be used", { choices: ["mcap"] }),
];

/**
 * Open a bag by its name. The caller closes it.
 * @param {Io} io @param {string} verb @param {string} given @param {Playing} [playing] undefined to read what is in it only
 */
export async function openBag(io, verb, given, playing) {
  const { ros, shell, signal } = io;
  const found = await shell.bags.find(given);
  if (!found) {
    await io.err(`The bags of this page: ${(await shell.bags.names()).join(", ") || "none"}\n`, "faint");
    throw new Failure(`ros2 bag ${verb}: error: argument bag_path: Bag path '${given}' does not exist!`, WRONG);
  }
  const playback = new Playback(ros, found.source, playing, playing !== undefined);
  try {
    await new Promise((resolve, reject) => {
      if (signal.aborted) reject(signal.reason);
      signal.addEventListener("abort", () => reject(signal.reason), { once: true });
      playback.addEventListener("open", resolve, { once: true });
      playback.addEventListener("fail", () => reject(new Failure(error(playback.failure))), { once: true });
    });
  } catch (reason) {
    playback.close();
    throw reason;
  }
  return { name: found.name, playback };
}

/** What the commands of rosbag2 say of a mistake. @param {string} text */
export function error(text) {
  return `[ERROR] [ros2bag]: ${text}`;
}

const STYLES = /** @type {const} */ ({ INFO: "", WARN: "yellow", ERROR: "red" });

/** @param {Io} io @param {keyof typeof STYLES} level @param {string} logger @param {string} text */
export function log({ err }, level, logger, text) {
  const now = performance.timeOrigin + performance.now();
  const fraction = String(Math.floor((now % 1000) * 1e6)).padStart(9, "0");
  return err(`[${level}] [${Math.floor(now / 1000)}.${fraction}] [${logger}]: ${text}\n`, STYLES[level]);
}

/** Throw what is wrong with a regular expression, if anything is. @param {string | undefined} text */
export function checkRegex(text) {
  try {
    new RegExp(text ?? "");
  } catch {
    throw new Failure(error(`'${text}' is not a regular expression`));
  }
}
