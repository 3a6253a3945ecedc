// @ts-check
// The messages that wait at an endpoint.

/**
 * A message; `writer` is the gid of the endpoint that sent it.
 * @typedef {{writer: number, sequence: number, timestamp: number, received: number,
 *   message: Uint8Array}} Received
 */

export class Queue {
  /** @type {(Received | undefined)[]} */
  #samples = [];
  #first = 0;
  #depth;

  /** @param {number} depth the largest number of messages; new ones replace the oldest */
  constructor(depth) {
    this.#depth = depth;
  }

  /** Add a message and return the one that it replaced, if any. @param {Received} sample */
  push(sample) {
    const full = this.#samples.length - this.#first >= this.#depth;
    const replaced = full ? this.shift() : undefined;
    this.#samples.push(sample);
    return replaced;
  }

  /** Return the oldest message, which stays. */
  peek() {
    return this.#samples[this.#first];
  }

  /** Remove the oldest message and return it. */
  shift() {
    const sample = this.#samples[this.#first];
    if (sample === undefined) return undefined;
    this.#samples[this.#first++] = undefined;
    // Array.shift would move all others: remove the empty front only when it is at least half of the array.
    if (this.#first * 2 >= this.#samples.length) {
      this.#samples.splice(0, this.#first);
      this.#first = 0;
    }
    return sample;
  }
}
