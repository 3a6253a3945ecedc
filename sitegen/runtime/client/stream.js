// @ts-check
// Values that arrive over time, as an async iterator. It keeps the newest ones until they are asked for.

/** @template Value */
export class Stream {
  /** @type {Value[]} */
  #waiting = [];
  /** @type {((result: IteratorResult<Value>) => void)[]} */
  #asking = [];
  /** @type {(() => void) | undefined} */
  #stop;
  #most;
  /** @type {(AbortSignal | undefined)[]} */
  #signals;
  #aborted = () => this.#end(true);
  #ended = false;

  /**
   * @param {(push: (value: Value) => void, end: () => void) => () => void} begin called at once; returns what stops it
   * @param {{most?: number, signal?: AbortSignal}} [options] `most` is how many values are kept, 100 by default;
   *   `signal` ends the stream
   * @param {AbortSignal} [closed] of the node, which ends it, too
   */
  constructor(begin, { most = 100, signal } = {}, closed) {
    this.#most = most;
    this.#signals = [signal, closed];
    if (this.#signals.some((one) => one?.aborted)) {
      this.#ended = true;
      return;
    }
    this.#stop = begin((value) => this.#push(value), () => this.#end(false));
    if (this.#ended) this.#stop();
    else for (const one of this.#signals) one?.addEventListener("abort", this.#aborted);
  }

  [Symbol.asyncIterator]() {
    return this;
  }

  /** @returns {Promise<IteratorResult<Value>>} */
  next() {
    const [value] = this.#waiting.splice(0, 1);
    if (value !== undefined) return Promise.resolve({ value, done: false });
    if (this.#ended) return Promise.resolve({ value: undefined, done: true });
    return new Promise((resolve) => this.#asking.push(resolve));
  }

  /** End the stream; `for await` calls this when its loop is left. @returns {Promise<IteratorResult<Value>>} */
  return() {
    this.#end(true);
    return Promise.resolve({ value: undefined, done: true });
  }

  /** @param {Value} value */
  #push(value) {
    if (this.#ended) return;
    const ask = this.#asking.shift();
    if (ask) {
      ask({ value, done: false });
      return;
    }
    this.#waiting.push(value);
    if (this.#waiting.length > this.#most) this.#waiting.shift();
  }

  /** @param {boolean} drop whether the values that wait are dropped */
  #end(drop) {
    if (drop) this.#waiting = [];
    if (this.#ended) return;
    this.#ended = true;
    // A signal may last much longer.
    for (const one of this.#signals) one?.removeEventListener("abort", this.#aborted);
    this.#stop?.();
    for (const ask of this.#asking.splice(0)) ask({ value: undefined, done: true });
  }
}
