// @ts-check
// A worker's part of the ROS graph: its endpoints, its links to other workers, and waiting.

import { fromPageId, incompatibility, now, pageId, readRecords, sends } from "../protocol.js";
import { Outbox } from "./outbox.js";
import { Queue } from "./queue.js";
import { Waiting } from "./waiting.js";

/** @import { Endpoint, EndpointKind, FromWorker, Qos, ToWorker } from "../protocol.js" */

/**
 * @typedef {{peer: number, id: number}} Remote an endpoint that matches one of ours
 * @typedef {{sequence: number, timestamp: number, message: Uint8Array}} Kept
 * @typedef {{
 *   endpoint: Endpoint, remotes: Remote[], queue: Queue, sequence: number, kept: Kept[],
 * }} Local with the messages that a transient local publisher keeps for those who come late
 */

const SIGINT = 2;
/** Who receives from whom. @type {Partial<Record<EndpointKind, EndpointKind>>} */
const RECEIVER = { publisher: "subscription", client: "service" };

export class Participant {
  #id;
  #post;
  #warn;
  /** @type {Map<number, Local>} */
  #locals = new Map();
  #nextId = 1;
  /** @type {Map<number, Outbox>} */
  #outboxes = new Map();
  #waiting = new Waiting();

  /**
   * @param {number} id of this worker in the page
   * @param {(message: FromWorker) => void} post to the page
   * @param {(logger: string, text: string) => void} warn on the console of the node
   */
  constructor(id, post, warn) {
    this.#id = id;
    this.#post = post;
    this.#warn = warn;
  }

  /**
   * Announce an endpoint and return its id.
   * @param {EndpointKind} kind @param {string} node @param {string} name @param {string} type
   * @param {Qos} qos
   */
  create(kind, node, name, type, qos) {
    const endpoint = { id: this.#nextId++, kind, node, name, type, qos };
    // Requests and responses are bounded by who waits for them.
    const all = qos.keepAll || kind === "service" || kind === "client";
    const queue = new Queue(all ? Infinity : Math.max(qos.depth, 1));
    /** @type {Local} */
    const local = { endpoint, remotes: [], queue, sequence: 0, kept: [] };
    this.#locals.set(endpoint.id, local);
    for (const other of this.#locals.values()) this.#meet(local, other);
    this.#post({ op: "create", endpoint });
    return endpoint.id;
  }

  /** @param {number} id */
  destroy(id) {
    const local = this.#locals.get(id);
    if (!local) return;
    this.#locals.delete(id);
    for (const { peer, id: other } of local.remotes) {
      if (peer === this.#id) this.#unmatch(other, { peer, id });
    }
    this.#post({ op: "destroy", id });
  }

  /** How many endpoints match `id` now. @param {number} id */
  matched(id) {
    return this.#locals.get(id)?.remotes.length ?? 0;
  }

  /**
   * Send a copy of `message` to all subscriptions that match the publisher `id`.
   * @param {number} id @param {Uint8Array} message
   */
  publish(id, message) {
    const local = this.#locals.get(id);
    if (!local) return;
    const sequence = ++local.sequence;
    const timestamp = now();
    const { qos } = local.endpoint;
    if (qos.transientLocal) {
      local.kept.push({ sequence, timestamp, message: message.slice() });
      if (!qos.keepAll && local.kept.length > qos.depth) local.kept.shift();
    }
    for (const remote of local.remotes) this.#send(id, remote, { sequence, timestamp, message });
  }

  /**
   * Send a copy of a request from the client `id` to a server that matches, and return the number by
   * which its response will be known. Where no server is, no response will come.
   * @param {number} id @param {Uint8Array} message
   */
  request(id, message) {
    const local = this.#locals.get(id);
    if (!local) return 0;
    const sequence = ++local.sequence;
    const server = local.remotes[0];
    if (server) this.#send(id, server, { sequence, timestamp: now(), message });
    return sequence;
  }

  /**
   * Send a copy of a response from the server `id` to the client that asked.
   * @param {number} id @param {number} client the writer of the request @param {number} sequence of it
   * @param {Uint8Array} message
   */
  respond(id, client, sequence, message) {
    if (!this.#locals.has(id)) return;
    this.#send(id, fromPageId(client), { sequence, timestamp: now(), message });
  }

  /** The oldest message that waits at the endpoint `id`. @param {number} id */
  next(id) {
    return this.#locals.get(id)?.queue.peek();
  }

  /** Remove that message and return it. @param {number} id */
  take(id) {
    return this.#locals.get(id)?.queue.shift();
  }

  /** Send what is held back. */
  flush() {
    for (const outbox of this.#outboxes.values()) outbox.flush();
  }

  /** Send what is held back, then wait as `Waiting.wait` says. @param {number} milliseconds */
  wait(milliseconds) {
    this.flush();
    return this.#waiting.wait(milliseconds);
  }

  /** End all waits. */
  wake() {
    this.#waiting.wake();
  }

  /** Take what the page says about the graph. @param {ToWorker} message */
  receive(message) {
    switch (message.op) {
      case "link":
        message.port.onmessage = (event) => this.#receiveFrame(event.data);
        this.#outboxes.set(message.peer, new Outbox(message.port));
        break;
      case "unlink":
        this.#outboxes.get(message.peer)?.close();
        this.#outboxes.delete(message.peer);
        break;
      case "match": {
        const local = this.#locals.get(message.local);
        if (local) this.#match(local, { peer: message.peer, id: message.remote }, message.durable);
        this.#outboxes.get(message.peer)?.flush();
        break;
      }
      case "unmatch":
        this.#unmatch(message.local, { peer: message.peer, id: message.remote });
        break;
      case "incompatible":
        this.#tellIncompatible(this.#locals.get(message.local)?.endpoint, message.policy);
        break;
      case "stop":
        this.#waiting.raise(SIGINT);
        break;
    }
    this.wake();
  }

  /** Match endpoints of this worker, without asking the page. @param {Local} a @param {Local} b */
  #meet(a, b) {
    const [sender, receiver] = sends(a.endpoint) ? [a, b] : [b, a];
    const { endpoint: from } = sender;
    const { endpoint: to } = receiver;
    if (to.kind !== RECEIVER[from.kind] || from.name !== to.name || from.type !== to.type) return;
    const policy = incompatibility(from, to);
    if (policy) {
      this.#tellIncompatible(to, policy);
      this.#tellIncompatible(from, policy);
      return;
    }
    this.#match(receiver, { peer: this.#id, id: from.id }, false);
    const durable = from.qos.transientLocal && to.qos.transientLocal;
    this.#match(sender, { peer: this.#id, id: to.id }, durable);
  }

  /** @param {Local} local @param {Remote} remote @param {boolean} durable */
  #match(local, remote, durable) {
    local.remotes.push(remote);
    if (!durable) return;
    for (const kept of local.kept) this.#send(local.endpoint.id, remote, kept);
  }

  /** @param {number} id @param {Remote} remote */
  #unmatch(id, { peer, id: other }) {
    const remotes = this.#locals.get(id)?.remotes ?? [];
    const gone = remotes.findIndex((remote) => remote.peer === peer && remote.id === other);
    if (gone >= 0) remotes.splice(gone, 1);
  }

  /** @param {number} id @param {Remote} remote @param {Kept} sample */
  #send(id, remote, { sequence, timestamp, message }) {
    const head = { reader: remote.id, writer: pageId(this.#id, id), sequence, timestamp };
    if (remote.peer === this.#id) {
      this.#deliver(head, message.slice());
    } else {
      this.#outboxes.get(remote.peer)?.send(head, message);
    }
  }

  /**
   * Warn in the words of ROS, which people know and search for.
   * @param {Endpoint | undefined} endpoint @param {string} policy
   */
  #tellIncompatible(endpoint, policy) {
    if (!endpoint) return;
    const [other, does, sent] = endpoint.kind === "publisher"
      ? ["subscription", "requesting", "sent to it"]
      : ["publisher", "offering", "received from it"];
    this.#warn(
      endpoint.node.slice(1).replaceAll("/", "."),
      `New ${other} discovered on topic '${endpoint.name}', ${does} incompatible QoS. ` +
        `No messages will be ${sent}. Last incompatible policy: ${policy}`,
    );
  }

  /** @param {ArrayBuffer} frame */
  #receiveFrame(frame) {
    for (const record of readRecords(frame)) this.#deliver(record, record.message);
    this.wake();
  }

  /** @param {import("../protocol.js").Head} head @param {Uint8Array} message */
  #deliver({ reader, writer, sequence, timestamp }, message) {
    // A message may still be under way when its receiver goes.
    this.#locals.get(reader)?.queue.push({ writer, sequence, timestamp, received: now(), message });
  }
}
