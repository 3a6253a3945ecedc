// @ts-check
// The samples of one curve, the oldest of which are overwritten.

import { Extents } from "./extents.js";

// A curve starts with room for so many samples, and has at most MOST: two minutes at 1 kHz.
const FIRST = 1024;
export const MOST = 131_072;

export class Trace {
  /** Seconds, never falling. */
  #times = new Float64Array(FIRST);
  #values = new Float64Array(FIRST);
  /** Values of the horizontal axis, if that is not the time. @type {Float64Array | undefined} */
  #xs;
  #start = 0;
  size = 0;
  /** How many samples have been forgotten. With it, samples have numbers that stay: `first` is that of index 0. */
  first = 0;
  extents = new Extents(this);

  /** @param {boolean} against whether samples have an `x` */
  constructor(against = false) {
    if (against) this.#xs = new Float64Array(FIRST);
  }

  /** The number of the sample that comes next. */
  get end() {
    return this.first + this.size;
  }

  /** @param {number} time @param {number} value @param {number} [x] */
  push(time, value, x = 0) {
    if (this.size === this.#times.length) this.#grow();
    const at = this.#place(this.size);
    this.#times[at] = time;
    this.#values[at] = value;
    if (this.#xs) this.#xs[at] = x;
    this.size++;
  }

  /** Forget the samples before a time. @param {number} time */
  dropBefore(time) {
    this.#forget(this.find(time));
  }

  clear() {
    this.#forget(this.size);
  }

  /** The number of samples before a time. @param {number} time */
  find(time) {
    let [low, high] = [0, this.size];
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.time(middle) < time) low = middle + 1;
      else high = middle;
    }
    return low;
  }

  /** @param {number} index */
  time(index) {
    return /** @type {number} */ (this.#times[this.#place(index)]);
  }

  /** @param {number} index */
  value(index) {
    return /** @type {number} */ (this.#values[this.#place(index)]);
  }

  /** @param {number} index */
  x(index) {
    return /** @type {number} */ (this.#xs?.[this.#place(index)]);
  }

  /** The lengths of arrays are powers of two. @param {number} index */
  #place(index) {
    return (this.#start + index) & (this.#times.length - 1);
  }

  /** @param {number} count */
  #forget(count) {
    this.#start = this.#place(count);
    this.size -= count;
    this.first += count;
  }

  #grow() {
    if (this.size === MOST) {
      this.#forget(1);
      return;
    }
    this.#times = this.#doubled(this.#times);
    this.#values = this.#doubled(this.#values);
    if (this.#xs) this.#xs = this.#doubled(this.#xs);
    this.#start = 0;
  }

  /** @param {Float64Array} old */
  #doubled(old) {
    const larger = new Float64Array(2 * old.length);
    larger.set(old.subarray(this.#start));
    larger.set(old.subarray(0, this.#start), old.length - this.#start);
    return larger;
  }
}
