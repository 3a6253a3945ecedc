// @ts-check
// The messages that wait at an endpoint, oldest first.

/**
 * @typedef {{writer: number, sequence: number, timestamp: number, received: number,
 *   message: Uint8Array}} Sample
 */

export class Queue {
  /** @type {(Sample | undefined)[]} */
  #samples = [];
  #first = 0;
  #depth;

  /** @param {number} depth how many are kept; the oldest make room for the newest */
  constructor(depth) {
    this.#depth = depth;
  }

  /** @param {Sample} sample */
  push(sample) {
    if (this.#samples.length - this.#first >= this.#depth) this.shift();
    this.#samples.push(sample);
  }

  /** The oldest, which stays. */
  peek() {
    return this.#samples[this.#first];
  }

  /** Remove the oldest and return it. */
  shift() {
    const sample = this.#samples[this.#first];
    if (sample === undefined) return undefined;
    this.#samples[this.#first++] = undefined;
    // Array.shift moves all that remain: drop the empty front only when it is the larger half.
    if (this.#first * 2 >= this.#samples.length) {
      this.#samples.splice(0, this.#first);
      this.#first = 0;
    }
    return sample;
  }
}
