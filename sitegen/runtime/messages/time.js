// @ts-check
// The time as messages have it.

import { now } from "../protocol.js";

/** The time now, as builtin_interfaces/msg/Time. */
export function stamp() {
  return timeOfMs(now());
}

/** Return a time in ms as builtin_interfaces/msg/Time. @param {number} ms since 1970 */
export function timeOfMs(ms) {
  const sec = Math.floor(ms / 1000);
  return { sec, nanosec: Math.min(999_999_999, Math.round((ms - sec * 1000) * 1e6)) };
}

/** Return a time in ns. @param {{sec: number, nanosec: number}} stamp */
export function nanoseconds({ sec, nanosec }) {
  return BigInt(sec) * 1_000_000_000n + BigInt(nanosec);
}
