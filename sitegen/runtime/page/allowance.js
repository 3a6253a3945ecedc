// @ts-check
// A budget for each second, and for what comes at once.

export class Allowance {
  #rate;
  #burst;
  #left;
  #since;

  /** @param {{rate: number, burst: number}} budget units a second, and at once @param {number} time in ms */
  constructor({ rate, burst }, time) {
    this.#rate = rate / 1000;
    this.#burst = burst;
    this.#left = burst;
    this.#since = time;
  }

  /**
   * Spend `units`; return false, and spend nothing, if fewer are left.
   * @param {number} units @param {number} time in ms
   */
  spend(units, time) {
    this.#left = Math.min(this.#burst, this.#left + (time - this.#since) * this.#rate);
    this.#since = time;
    if (units > this.#left) return false;
    this.#left -= units;
    return true;
  }
}
