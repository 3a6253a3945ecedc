// @ts-check
// The Python module ros_host, which clients/python/rclpy_backend imports: the worker's participant, the console
// and the keyboard, with values that Python can use without conversion.

import { now } from "../../protocol.js";
import { suspend } from "./stacks.js";

/** @import { FromWorker, Keyboard, Severity, Typed } from "../../protocol.js" */
/** @import { Participant } from "../../participant/participant.js" */
/** @import { Where } from "../environment.js" */
/** @import { Printer } from "../printer.js" */

/** @type {Record<number, Severity>} */
const SEVERITIES = { 10: "debug", 20: "info", 30: "warn", 40: "error", 50: "fatal" };

/** The methods of a participant that Python calls as they are. */
const FORWARDED = /** @type {const} */ ([
  "create", "destroy", "publish", "behind", "assertLiveliness", "request", "respond", "matched", "has", "take",
  "look", "gid", "takeEvent", "wake",
]);

/**
 * @typedef {Pick<Participant, (typeof FORWARDED)[number] | "filled" | "events">
 *   & {wait(milliseconds: number): Promise<number> | number}} Hosted the part of a participant that programs use
 */

/**
 * @param {Hosted} participant
 * @param {Printer} printer
 * @param {() => Typed | undefined} typed returns what was typed and not read yet
 * @param {(message: FromWorker) => void} post to the page
 * @param {(error: unknown) => void} [failed] called with what a thread threw; without it there are no threads
 */
export function pythonHost(participant, printer, typed, post, failed) {
  return {
    stacks: failed !== undefined,
    object: Object.fromEntries,
    now,
    ...Object.fromEntries(FORWARDED.map((name) => [name, participant[name].bind(participant)])),
    // The number of events and the ids where messages wait, as text, which Python converts fastest.
    filled: () => [participant.events, ...participant.filled()].join(" "),
    events: () => participant.events,
    ...waiting(participant, printer),
    ...keyboard(printer, typed, post),
    /**
     * Call a Python function on a stack of its own when the present one waits.
     * @param {{callPromising(): Promise<unknown>, destroy(): void}} body
     */
    spawn(body) {
      setTimeout(() => body.callPromising().catch(failed).finally(() => body.destroy()));
    },
    /** @param {"stdout" | "stderr"} stream @param {string} line */
    print: (stream, line) => printer.print(stream, line),
    /** @param {number} severity @param {string} logger @param {string} text @param {number} stamp @param {Where} where */
    log: (severity, logger, text, stamp, ...where) =>
      printer.log(SEVERITIES[severity] ?? "info", logger, text, stamp, where),
  };
}

/** @param {Hosted} participant @param {Printer} printer */
function waiting(participant, printer) {
  let signal = 0;
  const arrived = (/** @type {number} */ number) => {
    signal ||= number;
  };
  return {
    /** Wait; with stacks, only begin to wait, which continues in the next poll(). @param {number} milliseconds */
    wait(milliseconds) {
      printer.flush();
      const wait = participant.wait(milliseconds);
      if (wait instanceof Promise) suspend(wait.then(arrived));
      else arrived(wait);
    },
    /** Return the signal that arrived during a wait, once, or 0. */
    signal() {
      const last = signal;
      signal = 0;
      return last;
    },
  };
}

/** @param {Printer} printer @param {() => Typed | undefined} typed @param {(message: FromWorker) => void} post */
function keyboard(printer, typed, post) {
  return {
    typed,
    /** The program begins to read its standard input. @param {Keyboard} mode */
    reading(mode) {
      printer.flush();
      post({ op: "reading", keyboard: mode });
    },
    /** A prompt is ready for a line. @param {boolean} more whether it continues the last one */
    ready(more) {
      printer.flush();
      post({ op: "ready", more });
    },
    /** Send an answer of a notebook's kernel. @param {string} text in JSON */
    answer(text) {
      printer.flush();
      post({ op: "answer", text });
    },
    /** @param {string} text @param {string[]} words the completions of the text */
    complete: (text, words) => post({ op: "words", text, words }),
  };
}
