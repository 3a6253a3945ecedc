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
   * @param {(periods: number) => void} late called after so many periods without `touch`; more than one where
   *   the worker could not look before
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
    const periods = Math.floor((now() - this.#last) / this.#period);
    if (periods > 0) {
      this.#last += periods * this.#period;
      this.#late(periods);
      if (!this.#repeats) return;
    }
    if (this.#period !== Infinity) this.#arm();
  }
}
