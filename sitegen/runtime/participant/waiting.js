// @ts-check
// Suspend a program until a message or a signal arrives or a time has passed.

// Browsers delay nested timers by at least this time (ms). Timers set in a message handler are not nested.
const TIMER_CLAMP = 5;

export class Waiting {
  /** @type {Set<() => void>} */
  #waiters = new Set();
  #signal = 0;
  /** The number of wake-ups. */
  wakes = 0;
  #turn = new MessageChannel();
  /** @type {(() => void)[]} */
  #turns = [];

  constructor() {
    this.#turn.port1.onmessage = () => this.#turns.shift()?.();
  }

  /**
   * Resolve at the next wake-up, or after `milliseconds`: 0 yields to the event loop once, a negative number sets no
   * limit. The value is the pending signal, or 0.
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

  /** End the present wait, or else the next one, with `signal`. @param {number} signal */
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
