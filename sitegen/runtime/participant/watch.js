// @ts-check
// A period in which something has to happen, and what is to be done when it has not: deadlines, leases.

import { now } from "../protocol.js";

// Timers know no longer time (ms).
const LONGEST = 0x7fffffff;

export class Watch {
  #period;
  #late;
  #repeats;
  #last = 0;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #timer;

  /**
   * It rests until the first `touch`.
   * @param {number} period in ms; with Infinity it always rests
   * @param {() => void} late called after a period without `touch`
   * @param {boolean} repeats whether each further period counts too, or it rests until the next `touch`
   */
  constructor(period, late, repeats) {
    this.#period = period;
    this.#late = late;
    this.#repeats = repeats;
  }

  /** It has happened. */
  touch() {
    if (this.#period === Infinity) return;
    // A timer for each message would cost more than the message: the one that runs looks here.
    this.#last = now();
    if (this.#timer === undefined) this.#arm();
  }

  close() {
    clearTimeout(this.#timer);
    this.#period = Infinity;
  }

  #arm() {
    const left = this.#last + this.#period - now();
    this.#timer = setTimeout(() => this.#check(), Math.min(Math.max(left, 0), LONGEST));
  }

  #check() {
    this.#timer = undefined;
    while (now() - this.#last >= this.#period) {
      this.#last += this.#period;
      this.#late();
      if (!this.#repeats) return;
    }
    if (this.#period !== Infinity) this.#arm();
  }
}
