// @ts-check
// The lines of a program on their way to the terminal: as many as it can show, and word of those left out.

import { Broken } from "../shell/pipe.js";
import { Pace } from "./verb.js";

/** @import { Line, NodeHandle, Severity } from "../../protocol.js" */
/** @import { Io } from "../shell/shell.js" */
/** @import { Style } from "../shell/style.js" */

// Lines that wait to be shown; of a faster program, the oldest are left out.
const WAITING = 2000;
/** @type {Partial<Record<Severity, Style>>} */
const STYLES = { warn: "yellow", error: "red", fatal: "red", debug: "green" };

export class Output {
  #io;
  #node;
  #prefix;
  /** @type {Line[]} */
  #waiting = [];
  #dropped = 0;
  #listen;
  /** @type {Promise<void> | undefined} */
  #writing;

  /** @param {Io} io @param {NodeHandle} node @param {string} [prefix] of each line */
  constructor(io, node, prefix = "") {
    this.#io = io;
    this.#node = node;
    this.#prefix = prefix;
    this.#listen = (/** @type {Event} */ event) => this.#take(/** @type {CustomEvent<Line[]>} */ (event).detail);
    node.addEventListener("lines", this.#listen);
  }

  /** Show what waits, and no more. */
  async end() {
    this.#node.removeEventListener("lines", this.#listen);
    await this.#writing;
  }

  /** @param {Line[]} lines */
  #take(lines) {
    // The terminal has shown typed lines itself.
    for (const line of lines) if (line.severity !== "typed") this.#waiting.push(line);
    const over = this.#waiting.length - WAITING;
    if (over > 0) {
      this.#waiting.splice(0, over);
      this.#dropped += over;
    }
    this.#writing ??= this.#write().catch((error) => {
      if (!(error instanceof Broken)) throw error;
    }).finally(() => {
      this.#writing = undefined;
    });
  }

  async #write() {
    const pace = new Pace();
    const { out, err } = this.#io;
    for (let line; (line = this.#waiting.shift());) {
      // Not interrupted: the last lines of a program come after Ctrl-C.
      await pace.wait(new AbortController().signal);
      if (this.#dropped) {
        await err(`[${this.#dropped} lines left out]\n`, "faint");
        this.#dropped = 0;
      }
      // Logs go to the standard error output, as in ROS.
      const to = line.severity === "stdout" ? out : err;
      await to(`${this.#prefix}${line.text}\n`, STYLES[line.severity]);
    }
  }
}
