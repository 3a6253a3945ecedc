// @ts-check
// The server of an action: three services and two topics, and the states of its goals.

import { hex } from "../messages/hex.js";
import { nanoseconds, stamp } from "../messages/time.js";

/** @import { PageNode, Publisher } from "../protocol.js" */
/**
 * @typedef {{accepted?(goal: ServedGoal): boolean, execute(goal: ServedGoal): void,
 *   cancel?(goal: ServedGoal): boolean}} Handlers `accepted` and `cancel` may refuse; `execute` begins the work
 */

/** States of action_msgs/msg/GoalStatus. */
export const STATUS = Object.freeze({
  unknown: 0, accepted: 1, executing: 2, canceling: 3, succeeded: 4, canceled: 5, aborted: 6,
});
const LATCHED = { depth: 1, reliable: true, transientLocal: true };
/** Goals that have ended are remembered for clients that ask later, at most this many. */
const REMEMBERED = 100;
/** More goals at a time are rejected. */
const MOST = 1000;
/** Return codes of action_msgs/srv/CancelGoal. */
const [NONE, REJECTED, UNKNOWN, TERMINATED] = [0, 1, 2, 3];

/** A goal that a client sent. */
export class ServedGoal {
  #server;
  #settle = (/** @type {{status: number, result: any}} */ _) => {};
  /** @type {number} */
  status = STATUS.accepted;
  stamp = stamp();
  /** @type {Promise<{status: number, result: any}>} */
  ended = new Promise((resolve) => { this.#settle = resolve; });

  /** @param {ActionServer} server @param {Uint8Array} uuid @param {any} request */
  constructor(server, uuid, request) {
    this.#server = server;
    this.uuid = uuid;
    this.id = hex(uuid);
    this.request = request;
  }

  get isActive() {
    return this.status <= STATUS.canceling;
  }

  /** @param {any} feedback */
  publish(feedback) {
    if (this.isActive) this.#server.publishFeedback(this, feedback);
  }

  /** End the goal. @param {number} status @param {any} result */
  finish(status, result) {
    if (!this.isActive) return;
    this.status = status;
    this.#settle({ status, result });
    this.#server.changed();
  }
}

export class ActionServer {
  #handlers;
  /** By id. @type {Map<string, ServedGoal>} */
  #goals = new Map();
  /** @type {Publisher} */
  #feedback;
  /** @type {Publisher} */
  #status;
  /** @type {(() => void)[]} */
  #ends;

  /** @param {PageNode} raw @param {string} name @param {string} type @param {Handlers} handlers */
  constructor(raw, name, type, handlers) {
    this.#handlers = handlers;
    this.#feedback = raw.advertise(`${name}/_action/feedback`, `${type}_FeedbackMessage`, { reliable: true });
    this.#status = raw.advertise(`${name}/_action/status`, "action_msgs/msg/GoalStatusArray", LATCHED);
    this.#ends = [
      raw.serve(`${name}/_action/send_goal`, `${type}_SendGoal`, (request) => this.#take(request)),
      raw.serve(`${name}/_action/cancel_goal`, "action_msgs/srv/CancelGoal", (request) => this.#cancel(request)),
      raw.serve(`${name}/_action/get_result`, `${type}_GetResult`, (request) => this.#answer(request)),
      () => this.#feedback.close(),
      () => this.#status.close(),
    ];
    this.changed();
  }

  /** End the server; goals that are still active are aborted. */
  async close() {
    for (const goal of this.#goals.values()) goal.finish(STATUS.aborted, {});
    // The results of these goals are sent first.
    await Promise.resolve();
    setTimeout(() => this.#ends.forEach((end) => end()));
  }

  /** @param {ServedGoal} goal @param {any} feedback */
  publishFeedback({ uuid }, feedback) {
    this.#feedback.publish({ goal_id: { uuid }, feedback });
  }

  /** Publish the states of all goals. */
  changed() {
    const ended = [...this.#goals.values()].filter((goal) => !goal.isActive);
    for (const { id } of ended.slice(0, Math.max(0, ended.length - REMEMBERED))) this.#goals.delete(id);
    this.#status.publish({
      status_list: [...this.#goals.values()].map(({ uuid, stamp: at, status }) => ({
        goal_info: { goal_id: { uuid }, stamp: at }, status,
      })),
    });
  }

  /** @param {any} request of the service send_goal */
  #take({ goal_id: { uuid }, goal: request }) {
    const goal = new ServedGoal(this, uuid, request);
    const active = [...this.#goals.values()].filter((one) => one.isActive).length;
    const accepted = !this.#goals.has(goal.id) && active < MOST && (this.#handlers.accepted?.(goal) ?? true);
    if (accepted) {
      this.#goals.set(goal.id, goal);
      this.changed();
      // The client learns first that the goal was accepted.
      setTimeout(() => {
        if (goal.status === STATUS.accepted) goal.status = STATUS.executing;
        this.changed();
        this.#handlers.execute(goal);
      });
    }
    return { accepted, stamp: goal.stamp };
  }

  /** @param {any} request of the service get_result */
  async #answer({ goal_id: { uuid } }) {
    const goal = this.#goals.get(hex(uuid));
    return goal ? goal.ended : { status: STATUS.unknown, result: {} };
  }

  /** @param {any} request of the service cancel_goal */
  #cancel({ goal_info: { goal_id: { uuid }, stamp: at } }) {
    const all = uuid.every((/** @type {number} */ byte) => byte === 0);
    const until = nanoseconds(at);
    const goal = this.#goals.get(hex(uuid));
    if (!all && !goal && until === 0n) return { return_code: UNKNOWN, goals_canceling: [] };
    if (goal && !goal.isActive && until === 0n) return { return_code: TERMINATED, goals_canceling: [] };
    const wanted = [...this.#goals.values()].filter((one) => one.isActive && (one === goal ||
      (all && until === 0n) || (until > 0n && nanoseconds(one.stamp) <= until)));
    const canceling = wanted.filter((one) => {
      const agreed = one.status === STATUS.canceling || (this.#handlers.cancel?.(one) ?? true);
      if (agreed && one.isActive) one.status = STATUS.canceling;
      return agreed;
    });
    if (canceling.length) this.changed();
    return {
      return_code: canceling.length || !wanted.length ? NONE : REJECTED,
      goals_canceling: canceling.map((one) => ({ goal_id: { uuid: one.uuid }, stamp: one.stamp })),
    };
  }
}
