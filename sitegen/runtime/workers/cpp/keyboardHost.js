// @ts-check
// The host functions by which a compiled program reads its standard input.

/** @import { FromWorker, Keyboard } from "../../protocol.js" */
/** @import { Printer } from "../printer.js" */

/** As host.h numbers them. @type {Keyboard[]} */
const KEYBOARDS = ["lines", "hidden", "keys", "raw"];

/**
 * @param {Uint8Array[]} typed input that was not read yet; an empty item is the end of input
 * @param {Printer} printer
 * @param {(message: FromWorker) => void} post to the page
 */
export function keyboardHost(typed, printer, post) {
  /** @type {Keyboard | undefined} */
  let told;
  return {
    /** @param {number} number an index of KEYBOARDS */
    reading(number) {
      const keyboard = KEYBOARDS[number] ?? "lines";
      if (keyboard === told) return;
      told = keyboard;
      printer.flush();
      post({ op: "reading", keyboard });
    },
    typed: () => typed[0]?.length ?? -1,
    /** @param {Uint8Array} heap @param {number} to @param {number} capacity */
    takeTyped(heap, to, capacity) {
      const [first] = typed;
      if (!first) return 0;
      const part = first.subarray(0, capacity);
      heap.set(part, to);
      if (part.length < first.length) typed[0] = first.subarray(capacity);
      else typed.shift();
      return part.length;
    },
  };
}
