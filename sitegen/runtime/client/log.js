// @ts-check
// The log of a node: lines on /rosout, and in the console of the browser.

import { ROSOUT } from "../graphNames.js";
import { ROSOUT_QOS } from "../protocol.js";
import { say } from "../ui/words.js";

/** @import { PageNode, Publisher } from "../protocol.js" */
/** @import { Clock } from "./clock.js" */
/** @import { Surroundings } from "./surroundings.js" */
/** @typedef {keyof typeof LEVELS} Level */

const TYPE = "rcl_interfaces/msg/Log";
/** The constants of rcl_interfaces/msg/Log. */
const LEVELS = Object.freeze({ debug: 10, info: 20, warn: 30, error: 40, fatal: 50 });

export class Log {
  #raw;
  #surroundings;
  #clock;
  #name;
  /** @type {Publisher | undefined} */
  #publisher;
  /** @type {Level} */
  #level = "info";

  /** @param {PageNode} raw @param {Surroundings} surroundings @param {() => Clock} clock @param {string} node its name */
  constructor(raw, surroundings, clock, node) {
    this.#raw = raw;
    this.#surroundings = surroundings;
    this.#clock = clock;
    // As ROS names the loggers of nodes.
    this.#name = node.slice(1).replaceAll("/", ".");
  }

  /** The lowest severity that is logged, "info" at first. */
  get level() {
    return this.#level;
  }

  set level(level) {
    if (!Object.hasOwn(LEVELS, level)) {
      throw new Error(say("unknown log level '{}'; known are {}", String(level), Object.keys(LEVELS).join(", ")));
    }
    this.#level = level;
  }

  /** @param {unknown} text */
  debug(text) {
    this.#write("debug", text);
  }

  /** @param {unknown} text */
  info(text) {
    this.#write("info", text);
  }

  /** @param {unknown} text */
  warn(text) {
    this.#write("warn", text);
  }

  /** @param {unknown} text */
  error(text) {
    this.#write("error", text);
  }

  /** @param {unknown} text */
  fatal(text) {
    this.#write("fatal", text);
  }

  /** Announce the publisher of /rosout. */
  announce() {
    if (this.#publisher) return this.#publisher;
    this.#surroundings.check(ROSOUT, TYPE);
    return (this.#publisher = this.#raw.advertise(ROSOUT, TYPE, ROSOUT_QOS));
  }

  /** @param {Level} level @param {unknown} text */
  #write(level, text) {
    if (LEVELS[level] < LEVELS[this.#level]) return;
    const msg = String(text);
    console[level === "fatal" ? "error" : level](`[${this.#name}] ${msg}`);
    if (this.#surroundings.closed.aborted) return;
    this.announce().publish({ stamp: this.#clock().now(), level: LEVELS[level], name: this.#name, msg });
  }
}
