// @ts-check
// The change of a number per second.

export class Derivative {
  #before = { time: NaN, value: NaN };

  /**
   * Return the change since the value before, undefined if there is none.
   * @param {number} time (s) @param {number} value
   */
  of(time, value) {
    const { time: since, value: old } = this.#before;
    // Messages that arrive together have the same time: there is no change to measure between them.
    if (time === since) return undefined;
    this.#before = { time, value };
    return Number.isNaN(since) ? undefined : (value - old) / (time - since);
  }

  /** Forget the value before. */
  clear() {
    this.#before = { time: NaN, value: NaN };
  }
}
