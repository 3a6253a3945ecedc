// @ts-check
// The events of an endpoint, as ROS 2 counts them.

/** @import { Policy } from "../protocol.js" */

/**
 * @typedef {"deadline" | "liveliness" | "incompatible" | "matched" | "lost" | "type"} EventKind
 * @typedef {{kind: EventKind, total: number, totalChange: number, current: number,
 *   currentChange: number, policy: Policy | ""}} Event
 *   `matched` counts endpoints. `liveliness` of a subscription counts publishers: in `total` those that are not alive,
 *   in `current` those that are. `policy` is the last incompatible one
 */

export class Status {
  /** @type {Map<EventKind, Event>} */
  #events = new Map();
  #changed;

  /** @param {() => void} changed called after each event */
  constructor(changed) {
    this.#changed = changed;
  }

  /**
   * Count an event.
   * @param {EventKind} kind @param {number} total @param {number} [current] @param {Policy | ""} [policy]
   */
  add(kind, total, current = 0, policy = "") {
    const event = this.#events.get(kind) ??
      { kind, total: 0, totalChange: 0, current: 0, currentChange: 0, policy };
    event.total += total;
    event.totalChange += total;
    event.current += current;
    event.currentChange += current;
    event.policy = policy;
    this.#events.set(kind, event);
    this.#changed();
  }

  /** Return the event of a kind if it has changed since the last call. @param {EventKind} kind */
  take(kind) {
    const event = this.#events.get(kind);
    if (!event || (event.totalChange === 0 && event.currentChange === 0)) return undefined;
    const taken = { ...event };
    event.totalChange = 0;
    event.currentChange = 0;
    return taken;
  }
}
