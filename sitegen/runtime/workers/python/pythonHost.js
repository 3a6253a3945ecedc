// @ts-check
// What the Python module ros_host offers: the worker's participant, with values that Python takes as they
// are. See clients/python/rclpy_backend.

import { now } from "../../protocol.js";
import { suspend } from "./stacks.js";

/** @import { EndpointKind, FromWorker, Keyboard, Qos, Severity, Typed } from "../../protocol.js" */
/** @import { EventKind } from "../../participant/status.js" */
/** @import { Participant } from "../../participant/participant.js" */
/** @import { Printer } from "../printer.js" */

/** @type {Record<number, Severity>} */
const SEVERITIES = { 10: "debug", 20: "info", 30: "warn", 40: "error", 50: "fatal" };

/**
 * @typedef {Pick<Participant, "create" | "destroy" | "publish" | "behind" | "assertLiveliness" | "request"
 *   | "respond" | "matched" | "has" | "filled" | "take" | "look" | "nameOf" | "events" | "takeEvent" | "wake">
 *   & {wait(milliseconds: number): Promise<number> | number}} Hosted what programs need of a participant
 */

/**
 * @param {Hosted} participant
 * @param {Printer} printer
 * @param {() => Typed | undefined} typed gives what was typed and not yet read
 * @param {(message: FromWorker) => void} post to the page
 * @param {(error: unknown) => void} [failed] called with what a thread ended by; without, there are no threads
 */
export function pythonHost(participant, printer, typed, post, failed) {
  let signal = 0;
  const arrived = (/** @type {number} */ number) => {
    signal ||= number;
  };
  return {
    stacks: failed !== undefined,
    object: Object.fromEntries,
    now,
    /**
     * @param {EndpointKind} kind @param {string} node @param {string} name @param {string} type
     * @param {Qos} qos
     */
    create: (kind, node, name, type, qos) => participant.create(kind, node, name, type, qos),
    /** @param {number} id */
    destroy: (id) => participant.destroy(id),
    /** @param {number} id @param {Uint8Array} message */
    publish: (id, message) => participant.publish(id, message),
    /** @param {number} id */
    behind: (id) => participant.behind(id),
    /** @param {number} id */
    assertLiveliness: (id) => participant.assertLiveliness(id),
    /** @param {number} id @param {Uint8Array} message */
    request: (id, message) => participant.request(id, message),
    /** @param {number} id @param {number} client @param {number} sequence @param {Uint8Array} message */
    respond: (id, client, sequence, message) => participant.respond(id, client, sequence, message),
    /** @param {number} id */
    matched: (id) => participant.matched(id),
    /** @param {number} id */
    has: (id) => participant.has(id),
    // How many events there were, and where messages wait. Text is what Python takes soonest.
    filled: () => [participant.events, ...participant.filled()].join(" "),
    /** @param {number} id */
    take: (id) => participant.take(id),
    look: () => participant.look(),
    /** @param {number} id */
    nameOf: (id) => participant.nameOf(id),
    events: () => participant.events,
    /** @param {number} id @param {EventKind} kind */
    takeEvent: (id, kind) => participant.takeEvent(id, kind),
    /** Wait, or who has stacks: begin to, and do so in the next poll(). @param {number} milliseconds */
    wait(milliseconds) {
      printer.flush();
      const wait = participant.wait(milliseconds);
      if (wait instanceof Promise) suspend(wait.then(arrived));
      else arrived(wait);
    },
    /** The signal that came in a wait, once. */
    signal() {
      const last = signal;
      signal = 0;
      return last;
    },
    wake: () => participant.wake(),
    typed,
    /** The program reads its keyboard. @param {Keyboard} keyboard how */
    reading(keyboard) {
      printer.flush();
      post({ op: "reading", keyboard });
    },
    /** A prompt waits for a line. @param {boolean} more whether the last one goes on */
    ready(more) {
      printer.flush();
      post({ op: "ready", more });
    },
    /** @param {string} text @param {string[]} words that it may become */
    complete: (text, words) => post({ op: "words", text, words }),
    /**
     * Run a Python function on a stack of its own, after the present one has come to wait.
     * @param {{callPromising(): Promise<unknown>, destroy(): void}} body
     */
    spawn(body) {
      setTimeout(() => body.callPromising().catch(failed).finally(() => body.destroy()));
    },
    /** @param {"stdout" | "stderr"} stream @param {string} line */
    print: (stream, line) => printer.print(stream, line),
    /** @param {number} severity @param {string} logger @param {string} text @param {number} stamp */
    log: (severity, logger, text, stamp) => printer.log(SEVERITIES[severity] ?? "info", logger, text, stamp),
  };
}
