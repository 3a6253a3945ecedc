// @ts-check
// Send the output of a program to the page, in batches.

import { now } from "../protocol.js";

/** @import { FromWorker, Line, Severity } from "../protocol.js" */
/** @import { Format, Where } from "./environment.js" */

const BATCH = 256;
// In each period of PAUSE ms, the first AT_ONCE lines are sent immediately and further ones in batches. So the output
// of a program is visible before it begins to compute without waiting.
const AT_ONCE = 20;
const PAUSE = 50;

export class Printer {
  #post;
  /** @type {Line[]} */
  #lines = [];
  /** The beginning of the present period, and the number of messages since. */
  #since = 0;
  #posts = 0;
  /** How log messages become lines, if not as usual. @type {Format | undefined} */
  format;

  /** @param {(message: FromWorker) => void} post to the page */
  constructor(post) {
    this.#post = post;
  }

  /** @param {Severity} severity @param {string} text */
  print(severity, text) {
    this.#lines.push({ severity, text });
    if (now() - this.#since > PAUSE) {
      this.#since = now();
      this.#posts = 0;
    }
    if (this.#lines.length >= BATCH || this.#posts < AT_ONCE) this.flush();
  }

  /**
   * Print a log message in the format of ROS.
   * @param {Severity} severity @param {string} logger @param {string} text
   * @param {number} stamp ms since 1970, the same as in the message on /rosout
   * @param {Where} [where] in the source
   */
  log(severity, logger, text, stamp, where) {
    // Separate the whole milliseconds: a double has no room for them and for nanoseconds.
    const whole = Math.floor(stamp);
    const nanoseconds = String(BigInt(whole) * 1_000_000n + BigInt(Math.round((stamp - whole) * 1e6)));
    const seconds = `${nanoseconds.slice(0, -9)}.${nanoseconds.slice(-9)}`;
    this.print(
      severity,
      this.format?.(severity, logger, text, seconds, where)
        ?? `[${severity.toUpperCase()}] [${seconds}] [${logger}]: ${text}`,
    );
  }

  /** Send what is held back. */
  flush() {
    if (this.#lines.length === 0) return;
    this.#post({ op: "lines", lines: this.#lines });
    this.#lines = [];
    this.#posts += 1;
  }
}
