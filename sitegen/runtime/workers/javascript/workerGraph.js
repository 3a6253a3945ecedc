// @ts-check
// The ROS graph, as a worker knows it.

import { incompatibility, sends } from "../../protocol.js";

/** @import { Endpoint, GraphView } from "../../protocol.js" */
/** @import { Participant } from "../../participant/participant.js" */
/** @import { Pending } from "./pending.js" */

/** Emits `change` once after all changes of one task. */
export class WorkerGraph extends EventTarget {
  #participant;
  #pending;
  #changing = false;

  /** @param {Participant} participant @param {Pending} pending told of those who listen, and of own endpoints */
  constructor(participant, pending) {
    super();
    this.#participant = participant;
    this.#pending = pending;
  }

  /** @param {string} type @param {any} listener @param {AddEventListenerOptions} [options] */
  addEventListener(type, listener, options) {
    super.addEventListener(type, listener, options);
    if (!options?.passive) this.#pending.add(listener);
  }

  /** @param {string} type @param {any} listener */
  removeEventListener(type, listener) {
    super.removeEventListener(type, listener);
    this.#pending.delete(listener);
  }

  /** Tell of changes, those of this worker included. */
  changed() {
    if (this.#changing) return;
    this.#changing = true;
    queueMicrotask(() => {
      this.#changing = false;
      this.dispatchEvent(new Event("change"));
    });
  }

  /** All endpoints. @type {GraphView["endpoints"]} */
  endpoints() {
    const known = this.#participant.look() ?? [];
    return known.map(({ gid, endpoint }) => ({ ...endpoint, gid, program: "", missed: 0 }));
  }

  /** The fully qualified names of all nodes, sorted. */
  nodes() {
    return this.endpoints().filter(({ kind }) => kind === "node").map(({ node }) => node).sort();
  }

  /** All topics, sorted by name, with their types and nodes. @type {GraphView["topics"]} */
  topics() {
    return this.#channels("publisher", "subscription").map(([name, ends]) => {
      const { senders, receivers } = sides(ends);
      return {
        name, types: types(ends), publishers: senders.map(({ node }) => node),
        subscriptions: receivers.map(({ node }) => node), missed: 0,
        mismatches: senders.flatMap((from) => receivers.flatMap((to) => {
          const policy = incompatibility(from, to);
          return policy ? [{ publisher: from.node, subscription: to.node, policy }] : [];
        })),
      };
    });
  }

  /** All services, sorted by name, with their types and nodes. @type {GraphView["services"]} */
  services() {
    return this.#channels("client", "service").map(([name, ends]) => {
      const { senders, receivers } = sides(ends);
      return {
        name, types: types(ends), servers: receivers.map(({ node }) => node), clients: senders.map(({ node }) => node),
      };
    });
  }

  /** Endpoints of two kinds by name, sorted. @param {Endpoint["kind"][]} kinds @returns {[string, Endpoint[]][]} */
  #channels(...kinds) {
    /** @type {Map<string, Endpoint[]>} */
    const found = new Map();
    for (const end of this.endpoints()) {
      if (kinds.includes(end.kind)) found.set(end.name, [...found.get(end.name) ?? [], end]);
    }
    return [...found].sort(([a], [b]) => (a < b ? -1 : 1));
  }
}

/** @param {Endpoint[]} ends */
function sides(ends) {
  return { senders: ends.filter(sends), receivers: ends.filter((one) => !sends(one)) };
}

/** @param {Endpoint[]} ends */
function types(ends) {
  return [...new Set(ends.map(({ type }) => type))];
}
