// @ts-check
// The host functions about the program itself: its arguments, its log and the exception that ends it.

import { now } from "../../protocol.js";
import { readText } from "./layout.js";

/** @import { Severity } from "../../protocol.js" */
/** @import { Printer } from "../printer.js" */

/** How many exceptions may be in flight. */
const REMEMBERED = 100;
/** @type {Record<number, Severity>} */
const SEVERITIES = { 10: "debug", 20: "info", 30: "warn", 40: "error", 50: "fatal" };

/**
 * @param {Printer} printer
 * @param {string[]} args the command line, beginning with the program's name
 * @param {(error: string, stack: string) => void} fail called with the text of an exception that left main(),
 *   and the stack where it was thrown, if known
 */
export function programHost(printer, args, fail) {
  const words = args.map((word) => new TextEncoder().encode(word));
  /** With --debug, the stacks where exceptions were thrown, by address. @type {Map<number, string>} */
  const stacks = new Map();
  let blamed = "";
  return {
    /**
     * @param {Uint8Array} heap @param {number} severity @param {number} logger @param {number} line
     * @param {number} [stamp] missing in programs compiled by an older sitegen
     */
    log(heap, severity, logger, line, stamp = now()) {
      printer.log(SEVERITIES[severity] ?? "info", readText(heap, logger), readText(heap, line), stamp);
    },
    /** @param {Uint8Array} heap @param {number} index @param {number} to @param {number} capacity */
    argument(heap, index, to, capacity) {
      const word = words[index];
      if (!word) return -1;
      if (to) heap.set(word.subarray(0, capacity), to);
      return word.length;
    },
    /** @param {Uint8Array} heap @param {number} message */
    fail: (heap, message) => fail(readText(heap, message), blamed),
    /** @param {number} exception its address */
    thrown(exception) {
      stacks.delete(exception);
      stacks.set(exception, new Error().stack ?? "");
      for (const oldest of stacks.keys()) {
        if (stacks.size <= REMEMBERED) break;
        stacks.delete(oldest);
      }
    },
    /** @param {number} exception its address */
    blame(exception) {
      blamed = stacks.get(exception) ?? "";
    },
  };
}
