// @ts-check
// The messages of a subscription, at most one in a while.

/** @template Message */
export class Throttle {
  #send;
  #rate = 0;
  #length = 0;
  /** @type {Message[]} */
  #queue = [];
  #last = -Infinity;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #timer;

  /** @param {(message: Message) => void} send */
  constructor(send) {
    this.#send = send;
  }

  /** @param {number} rate ms between messages @param {number} length of the queue, 0 for none */
  set(rate, length) {
    this.#rate = rate;
    this.#length = length;
    if (!length || !rate) this.#flush();
  }

  /** Send a message now or later; without a queue, one that comes too early is dropped. @param {Message} message */
  push(message) {
    const wait = this.#last + this.#rate - performance.now();
    if (wait <= 0 && !this.#queue.length) {
      this.#now(message);
      return;
    }
    if (!this.#length) return;
    this.#queue.push(message);
    if (this.#queue.length > this.#length) this.#queue.shift();
    this.#timer ??= setTimeout(() => this.#next(), Math.max(0, wait));
  }

  close() {
    clearTimeout(this.#timer);
    this.#queue = [];
  }

  #next() {
    this.#timer = undefined;
    const [message] = this.#queue.splice(0, 1);
    if (message !== undefined) this.#now(message);
    if (this.#queue.length) this.#timer = setTimeout(() => this.#next(), this.#rate);
  }

  /** @param {Message} message */
  #now(message) {
    this.#last = performance.now();
    this.#send(message);
  }

  #flush() {
    clearTimeout(this.#timer);
    this.#timer = undefined;
    for (const message of this.#queue.splice(0)) this.#now(message);
  }
}
