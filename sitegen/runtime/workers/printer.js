// @ts-check
// What a program prints, on its way to the consoles: many lines in one message.

import { now } from "../protocol.js";

/** @import { FromWorker, Line, Severity } from "../protocol.js" */

const BATCH = 256;
// A program that prints and never waits shows so many of its lines at once in so many milliseconds, and those
// that come faster together. So it has shown what it printed when it begins to compute without a pause.
const AT_ONCE = 20;
const PAUSE = 50;

export class Printer {
  #post;
  /** @type {Line[]} */
  #lines = [];
  /** When the present milliseconds began, and how often it posted since. */
  #since = 0;
  #posts = 0;

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
   * Print a line of the log in the format of ROS.
   * @param {Severity} severity @param {string} logger @param {string} text
   * @param {number} stamp ms since 1970, the same as in the message on /rosout
   */
  log(severity, logger, text, stamp) {
    // Whole milliseconds apart: with them, a double has no room for nanoseconds.
    const whole = Math.floor(stamp);
    const nanoseconds = String(BigInt(whole) * 1_000_000n + BigInt(Math.round((stamp - whole) * 1e6)));
    const seconds = `${nanoseconds.slice(0, -9)}.${nanoseconds.slice(-9)}`;
    this.print(severity, `[${severity.toUpperCase()}] [${seconds}] [${logger}]: ${text}`);
  }

  /** Send what is held back. */
  flush() {
    if (this.#lines.length === 0) return;
    this.#post({ op: "lines", lines: this.#lines });
    this.#lines = [];
    this.#posts += 1;
  }
}
