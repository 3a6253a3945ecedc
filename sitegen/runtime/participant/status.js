// @ts-check
// What has happened at an endpoint, as the events of ROS 2 tell it: counts, and how they changed.

/** @import { Policy } from "../protocol.js" */

/**
 * @typedef {"deadline" | "liveliness" | "incompatible" | "matched" | "lost" | "type"} EventKind
 * @typedef {{kind: EventKind, total: number, totalChange: number, current: number,
 *   currentChange: number, policy: Policy | ""}} Event
 *   `matched` counts endpoints, `liveliness` of a subscription publishers: those not alive in `total`, those
 *   alive in `current`; `policy` is the last that did not suit
 */

export class Status {
  /** @type {Map<EventKind, Event>} */
  #events = new Map();
  #changed;

  /** @param {() => void} changed called at each event */
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

  /** What there is to tell of one kind, and how it changed since it was taken the last time. @param {EventKind} kind */
  take(kind) {
    const event = this.#events.get(kind);
    if (!event || (event.totalChange === 0 && event.currentChange === 0)) return undefined;
    const taken = { ...event };
    event.totalChange = 0;
    event.currentChange = 0;
    return taken;
  }
}
