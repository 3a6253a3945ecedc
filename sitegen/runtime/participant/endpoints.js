// @ts-check
// The endpoints of a worker. Those that match each other find each other here, without the page.

import { gidOf, incompatibility, sends } from "../protocol.js";
import { Local } from "./local.js";

/** @import { Endpoint, EndpointKind } from "../protocol.js" */
/** @import { Actions } from "./local.js" */

/** Who receives from whom. @type {Partial<Record<EndpointKind, EndpointKind>>} */
const RECEIVER = { publisher: "subscription", client: "service" };

export class Endpoints {
  #worker;
  #apart;
  /** @type {Map<number, Local>} */
  #locals = new Map();
  #nextId = 1;

  /** @param {number} worker its id @param {boolean} apart whether they do not match each other */
  constructor(worker, apart) {
    this.#worker = worker;
    this.#apart = apart;
  }

  /** @param {number} id */
  get(id) {
    return this.#locals.get(id);
  }

  /** Whether there was ever an endpoint of this id: ids are not used again. @param {number} id */
  knew(id) {
    return id > 0 && id < this.#nextId;
  }

  /** In the order of their creation, by id. */
  entries() {
    return this.#locals.entries();
  }

  /**
   * Add an endpoint and match it with the others.
   * @param {Omit<Endpoint, "id">} description @param {(id: number) => Actions} actionsOf
   */
  add(description, actionsOf) {
    const endpoint = { id: this.#nextId++, ...description };
    const local = new Local(endpoint, actionsOf(endpoint.id));
    this.#locals.set(endpoint.id, local);
    if (!this.#apart) for (const other of this.#locals.values()) this.#meet(local, other);
    return endpoint;
  }

  /** Remove an endpoint; return whether it existed. @param {number} id */
  remove(id) {
    const local = this.#locals.get(id);
    if (!local) return false;
    this.#locals.delete(id);
    local.close();
    for (const { peer, id: other } of local.remotes) {
      if (peer === this.#worker) this.#locals.get(other)?.unmatch(gidOf(this.#worker, id));
    }
    return true;
  }

  /** Match two endpoints, if they are the ends of one topic or service. @param {Local} a @param {Local} b */
  #meet(a, b) {
    const [sender, receiver] = sends(a.endpoint) ? [a, b] : [b, a];
    const [from, to] = [sender.endpoint, receiver.endpoint];
    if (to.kind !== RECEIVER[from.kind] || from.name !== to.name) return;
    const policy = incompatibility(from, to);
    for (const [mine, { id, qos }] of /** @type {const} */ ([[receiver, from], [sender, to]])) {
      if (policy) mine.mismatch(policy);
      else mine.match({ gid: gidOf(this.#worker, id), peer: this.#worker, id, qos });
    }
  }
}
