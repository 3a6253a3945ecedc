// @ts-check
// The ROS graph, as a worker knows it.

import { servicesOf, topicsOf } from "../../participant/summary.js";
import { sends } from "../../protocol.js";

/** @import { Endpoint, GraphView } from "../../protocol.js" */
/** @import { Participant } from "../../participant/participant.js" */
/** @import { Pending } from "./pending.js" */

/** @typedef {{endpoint: Endpoint}} Seen */

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
    return topicsOf(this.#channels("publisher", "subscription"), () => 0);
  }

  /** All services, sorted by name, with their types and nodes. @type {GraphView["services"]} */
  services() {
    return servicesOf(this.#channels("client", "service"));
  }

  /** Endpoints of two kinds by name. @param {Endpoint["kind"][]} kinds */
  #channels(...kinds) {
    /** @type {Map<string, {senders: Seen[], receivers: Seen[]}>} */
    const found = new Map();
    for (const seen of this.#participant.look() ?? []) {
      const { kind, name } = seen.endpoint;
      if (!kinds.includes(kind)) continue;
      const sides = found.get(name) ?? { senders: [], receivers: [] };
      (sends(seen.endpoint) ? sides.senders : sides.receivers).push(seen);
      found.set(name, sides);
    }
    return found;
  }
}
