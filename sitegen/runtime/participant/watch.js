// @ts-check
// Watch that something happens in each period, for deadlines and leases.

import { now } from "../protocol.js";

// The longest time of a timer (ms).
const LONGEST = 0x7fffffff;

export class Watch {
  #period;
  #late;
  #repeats;
  #last = 0;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #timer;

  /**
   * Begin at the first `touch`.
   * @param {number} period in ms; Infinity watches nothing
   * @param {(periods: number) => void} late called with the number of periods without `touch`: more than one if the
   *   worker was busy
   * @param {boolean} repeats whether to go on after that, or to pause until the next `touch`
   */
  constructor(period, late, repeats) {
    this.#period = period;
    this.#late = late;
    this.#repeats = repeats;
  }

  /** What is watched has happened. */
  touch() {
    if (this.#period === Infinity) return;
    // A timer for each message would cost more than the message, so the running timer checks this time.
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
