// @ts-check
// A goal that this page sent.

import { isFinal } from "../messages/actionClient.js";
import { say } from "../ui/words.js";
import { endingWith, unlessAborted } from "./ending.js";
import { Stream } from "./stream.js";

/** @import { ActionClient, Goal as Known } from "../messages/actionClient.js" */

/** Why a goal has no result: it was rejected, canceled or aborted, or its server is gone. */
export class GoalError extends Error {
  /** @param {string} message @param {string} state @param {any} result what the server sent, if anything */
  constructor(message, state, result) {
    super(message);
    this.name = "GoalError";
    this.state = state;
    this.result = result;
  }
}

export class Goal {
  #client;
  #known;
  /** Feedback that nobody has asked for yet. @type {any[]} */
  #early = [];

  /** @param {ActionClient} client @param {Known} known @param {number} [kept] */
  constructor(client, known, kept = 100) {
    this.#client = client;
    this.#known = known;
    let before = known.feedback;
    const keep = (/** @type {Event} */ event) => {
      const goal = /** @type {CustomEvent<Known>} */ (event).detail;
      if (goal !== known || goal.feedback === before) return;
      before = goal.feedback;
      this.#early.push(before);
      if (this.#early.length > kept) this.#early.shift();
    };
    client.addEventListener("change", keep);
    this.#forget = () => client.removeEventListener("change", keep);
    known.ended.then(this.#forget);
  }

  #forget = () => {};

  get id() {
    return this.#known.id;
  }

  /**
   * "sending", "accepted", "executing", "canceling", or how it ended: "succeeded", "canceled", "aborted", "rejected",
   * "lost".
   */
  get state() {
    return this.#known.state;
  }

  /** Iterate over the feedback until the goal ends. @param {{most?: number, signal?: AbortSignal}} [options] */
  feedback(options) {
    return new Stream((push, end) => {
      for (const one of this.#early.splice(0)) push(one);
      this.#forget();
      let before = this.#known.feedback;
      const changed = (/** @type {Event} */ event) => {
        const goal = /** @type {CustomEvent<Known>} */ (event).detail;
        if (goal !== this.#known) return;
        if (goal.feedback !== before) push(before = goal.feedback);
        if (isFinal(goal.state)) end();
      };
      this.#client.addEventListener("change", changed);
      if (isFinal(this.state)) end();
      return () => this.#client.removeEventListener("change", changed);
    }, options);
  }

  /**
   * Resolve with the result; reject with a GoalError if the goal did not succeed, or with the reason of `signal`.
   * @param {{signal?: AbortSignal}} [options] @returns {Promise<any>}
   */
  async result({ signal } = {}) {
    await unlessAborted([signal], this.#known.ended);
    const { state, result, fault } = this.#known;
    if (state === "succeeded") return result;
    throw new GoalError(fault || say("the goal was {}", state), state, result);
  }

  /** Ask the server to cancel the goal. Reject if it refuses. @param {{signal?: AbortSignal}} [options] */
  cancel({ signal } = {}) {
    return unlessAborted([signal], this.#answered().then(() => this.#client.cancel(this.#known)));
  }

  /** Cancel the goal when `signal` aborts. @param {AbortSignal | undefined} signal */
  cancelWith(signal) {
    const end = endingWith([signal], () => {
      // The server may refuse, or be gone: the result tells how the goal ended.
      if (!isFinal(this.state)) this.cancel().catch(() => {});
    });
    this.#known.ended.then(end);
  }

  /** Resolve when the server has accepted or rejected the goal: before, it could not find it. @returns {Promise<void>} */
  #answered() {
    return new Promise((resolve) => {
      const look = () => {
        if (this.state === "sending") return;
        this.#client.removeEventListener("change", look);
        resolve();
      };
      this.#client.addEventListener("change", look);
      look();
    });
  }
}
