// @ts-check
// The time of a node, and what waits for it. As in ROS, a node uses the time on /clock if its parameter use_sim_time
// says so; the page itself uses it while somebody publishes it, as panels do.

import { RosClock } from "../messages/rosClock.js";
import { say } from "../ui/words.js";
import { endingWith } from "./ending.js";
import { Stream } from "./stream.js";

/** @import { PageNode } from "../protocol.js" */
/** @import { Surroundings } from "./surroundings.js" */

// The longest time that browsers can wait (ms).
const LONGEST = 2 ** 31 - 1;

export class Clock extends RosClock {
  #surroundings;
  /** What looks at the time when that changes. @type {Set<() => void>} */
  #watching = new Set();

  /** @param {PageNode} raw @param {Surroundings} surroundings */
  constructor(raw, surroundings) {
    super(raw);
    this.#surroundings = surroundings;
  }

  changed() {
    for (const look of [...this.#watching]) look();
  }

  /** The time now in ms. */
  get ms() {
    const { sec, nanosec } = this.now();
    return sec * 1000 + nanosec / 1e6;
  }

  /**
   * Call `callback` with the time each `period` ms, until the function that this returns is called. What was missed is
   * left out, and after a jump into the past, the next call is a period later.
   * @param {number} period @param {(time: {sec: number, nanosec: number}) => void} callback
   * @param {{signal?: AbortSignal}} [options] @returns {() => void}
   */
  timer(period, callback, { signal } = {}) {
    if (!(period > 0 && period < Infinity)) throw new RangeError(say("a period must be a positive number of ms"));
    let due = this.ms + period;
    /** @type {ReturnType<typeof setTimeout> | undefined} */
    let waiting;
    const look = () => {
      clearTimeout(waiting);
      const time = this.ms;
      if (time < due - period) due = time + period;
      const isDue = time >= due;
      if (isDue) due += period * (1 + Math.floor((time - due) / period));
      // With simulated time, the next message looks.
      if (!this.isSimulated) waiting = setTimeout(look, Math.min(LONGEST, Math.ceil(due - time)));
      if (isDue) run(callback, this.now());
    };
    this.#watching.add(look);
    look();
    return endingWith([signal, this.#surroundings.closed], () => {
      clearTimeout(waiting);
      this.#watching.delete(look);
    });
  }

  /**
   * Iterate over the time, each `period` ms. What comes while the loop is busy is left out but for the newest.
   * @param {number} period @param {{signal?: AbortSignal}} [options]
   * @returns {Stream<{sec: number, nanosec: number}>}
   */
  ticks(period, { signal } = {}) {
    return new Stream((push) => this.timer(period, push), { most: 1, signal }, this.#surroundings.closed);
  }

  /** Resolve after `ms`. @param {number} ms @param {{signal?: AbortSignal}} [options] @returns {Promise<void>} */
  async sleep(ms, { signal } = {}) {
    if (ms > 0) for await (const _ of this.ticks(ms, { signal })) return;
    signal?.throwIfAborted();
    this.#surroundings.closed.throwIfAborted();
  }
}

/** @param {(time: any) => void} callback @param {any} time */
function run(callback, time) {
  try {
    callback(time);
  } catch (error) {
    // The next call may succeed.
    console.error(error);
  }
}
