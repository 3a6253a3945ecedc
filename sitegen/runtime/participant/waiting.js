// @ts-check
// Waiting: what a program does until a message, a signal or a time comes.

// Browsers make nested timers wait at least this long (ms); timers set by a message are not nested.
const TIMER_CLAMP = 5;

export class Waiting {
  /** @type {Set<() => void>} */
  #waiters = new Set();
  #signal = 0;
  /** How often something happened. */
  wakes = 0;
  #turn = new MessageChannel();
  /** @type {(() => void)[]} */
  #turns = [];

  constructor() {
    this.#turn.port1.onmessage = () => this.#turns.shift()?.();
  }

  /**
   * Resolve when something happened, at the latest after `milliseconds`: 0 lets the event loop turn
   * once, a negative number sets no limit. The value is a signal that came, or 0.
   * @param {number} milliseconds @returns {Promise<number>}
   */
  wait(milliseconds) {
    return new Promise((resolve) => {
      /** @type {ReturnType<typeof setTimeout> | undefined} */
      let timer;
      const done = () => {
        clearTimeout(timer);
        this.#waiters.delete(done);
        resolve(this.#signal);
        this.#signal = 0;
      };
      if (milliseconds === 0 || this.#signal) {
        this.#nextTurn(done);
        return;
      }
      this.#waiters.add(done);
      const arm = () => {
        if (this.#waiters.has(done)) timer = setTimeout(done, milliseconds);
      };
      if (milliseconds < 0) return;
      if (milliseconds < TIMER_CLAMP) {
        this.#nextTurn(arm);
      } else {
        arm();
      }
    });
  }

  /** End all waits. */
  wake() {
    this.wakes += 1;
    for (const done of [...this.#waiters]) done();
  }

  /** Let the next wait, or the present one, end with `signal`. @param {number} signal */
  raise(signal) {
    this.#signal = signal;
    this.wake();
  }

  /** @param {() => void} call */
  #nextTurn(call) {
    this.#turns.push(call);
    this.#turn.port2.postMessage(null);
  }
}
