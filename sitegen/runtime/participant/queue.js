// @ts-check
// The messages that wait at an endpoint, oldest first.

/**
 * A message, and the name that its writer has in the page.
 * @typedef {{writer: number, sequence: number, timestamp: number, received: number,
 *   message: Uint8Array}} Received
 */

export class Queue {
  /** @type {(Received | undefined)[]} */
  #samples = [];
  #first = 0;
  #depth;

  /** @param {number} depth how many are kept; the oldest make room for the newest */
  constructor(depth) {
    this.#depth = depth;
  }

  /** Add the newest and return the one that made room for it, if any. @param {Received} sample */
  push(sample) {
    const full = this.#samples.length - this.#first >= this.#depth;
    const replaced = full ? this.shift() : undefined;
    this.#samples.push(sample);
    return replaced;
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
