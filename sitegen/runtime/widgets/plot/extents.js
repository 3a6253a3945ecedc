// @ts-check
// The smallest and the largest values of a trace against x, without looking at all samples each time.

import { isDrawn } from "./outline.js";

/** @import { Trace } from "./trace.js" */

/** @typedef {{left: number, right: number, low: number, high: number}} Extent Infinity and -Infinity if it is empty */

// The extent of so many samples is kept.
const BLOCK = 1024;

export class Extents {
  #trace;
  /** By the number of a block, those of whole blocks. @type {Map<number, Extent>} */
  #blocks = new Map();

  /** @param {Trace} trace */
  constructor(trace) {
    this.#trace = trace;
  }

  /** The extent of all samples. @returns {Extent} */
  get whole() {
    const { first, end } = this.#trace;
    for (const block of this.#blocks.keys()) if (block * BLOCK < first) this.#blocks.delete(block);
    const whole = empty();
    for (let from = first; from < end;) {
      const until = Math.min((Math.floor(from / BLOCK) + 1) * BLOCK, end);
      include(whole, this.#of(from, until));
      from = until;
    }
    return whole;
  }

  /** @param {number} from the number of a sample @param {number} until at most the end of its block */
  #of(from, until) {
    const block = until - from === BLOCK ? from / BLOCK : -1;
    const known = this.#blocks.get(block);
    if (known) return known;
    const found = empty();
    for (let number = from; number < until; number++) {
      const index = number - this.#trace.first;
      const [x, y] = [this.#trace.x(index), this.#trace.value(index)];
      if (isDrawn(x) && isDrawn(y)) include(found, { left: x, right: x, low: y, high: y });
    }
    if (block >= 0) this.#blocks.set(block, found);
    return found;
  }
}

/** @returns {Extent} */
export function empty() {
  return { left: Infinity, right: -Infinity, low: Infinity, high: -Infinity };
}

/** Enlarge an extent by another. @param {Extent} extent @param {Extent} other */
export function include(extent, other) {
  extent.left = Math.min(extent.left, other.left);
  extent.right = Math.max(extent.right, other.right);
  extent.low = Math.min(extent.low, other.low);
  extent.high = Math.max(extent.high, other.high);
}
