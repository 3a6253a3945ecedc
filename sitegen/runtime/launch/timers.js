// @ts-check
// The delays of launch files.

/** @import { Ros } from "../protocol.js" */

const CLOCK = "/clock";
const TYPE = "rosgraph_msgs/msg/Clock";

/** Resolve after `seconds`, or when `signal` aborts. @param {number} seconds @param {AbortSignal} signal @returns {Promise<void>} */
export function delay(seconds, signal) {
  return new Promise((resolve) => {
    const done = () => {
      clearTimeout(timer);
      resolve();
    };
    const timer = setTimeout(done, seconds * 1000);
    signal.addEventListener("abort", done, { once: true });
  });
}

/**
 * Resolve after `seconds` of the time on /clock, or when `signal` aborts. When time jumps back, they begin anew.
 * @param {Ros} ros @param {number} seconds @param {AbortSignal} signal @param {(text: string) => void} warn
 * @returns {Promise<void>}
 */
export function delayRosTime(ros, seconds, signal, warn) {
  if (!ros.types[TYPE]) {
    warn("no node of this page has simulated time; the timer follows the clock of the computer");
    return delay(seconds, signal);
  }
  return new Promise((resolve) => {
    let begin = Infinity;
    const done = () => {
      signal.removeEventListener("abort", done);
      unsubscribe();
      resolve();
    };
    const unsubscribe = ros.subscribe(CLOCK, TYPE, ({ clock }) => {
      const now = clock.sec + clock.nanosec / 1e9;
      begin = Math.min(begin, now);
      if (now - begin >= seconds) done();
    });
    signal.addEventListener("abort", done);
  });
}
