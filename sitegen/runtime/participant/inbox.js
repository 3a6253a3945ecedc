// @ts-check
// The requests that wait at a service, with credits for clients, and the responses that wait at a client.

import { BUDGETS } from "../budgets.js";
import { Inflow } from "./inflow.js";
import { Queue } from "./queue.js";

/** @import { Refusal } from "../protocol.js" */
/** @import { Received } from "./queue.js" */

export class Inbox {
  // Nothing that arrived is dropped: clients have credits for requests, and ask for responses.
  #queue = new Queue(Infinity);
  /** By the gid of the client; only a service has any. @type {Map<number, Inflow>} */
  #inflows = new Map();
  #credits;
  #credit;
  #refuse;
  #bytes = 0;

  /**
   * @param {boolean} credits whether it is that of a service
   * @param {(sender: number, records: number, bytes: number) => void} credit tells a client what was taken
   * @param {(sender: number, what: Refusal) => void} refuse called when a message is dropped
   */
  constructor(credits, credit, refuse) {
    this.#credits = credits;
    this.#credit = credit;
    this.#refuse = refuse;
  }

  /** @param {Received} sample */
  push(sample) {
    const { writer, message } = sample;
    const room = this.#credits ? this.#inflow(writer).arrive(message.length) : this.#bytes < BUDGETS.responses;
    if (!room) {
      this.#refuse(writer, "overrun");
      return;
    }
    this.#bytes += message.length;
    this.#queue.push(sample);
  }

  peek() {
    return this.#queue.peek();
  }

  take() {
    const sample = this.#queue.shift();
    if (!sample) return undefined;
    const { writer, message } = sample;
    this.#bytes -= message.length;
    this.#inflows.get(writer)?.leave(message.length, writer, this.#credit);
    return sample;
  }

  /** A client is gone. @param {number} gid */
  unmatch(gid) {
    this.#inflows.delete(gid);
  }

  /** @param {number} client its gid */
  #inflow(client) {
    const known = this.#inflows.get(client) ?? new Inflow();
    this.#inflows.set(client, known);
    return known;
  }
}
