// @ts-check
// A worker's part of the ROS graph: its endpoints, its links to other workers, and waiting.

import { now, readRecords } from "../protocol.js";
import { Outbox } from "./outbox.js";
import { Queue } from "./queue.js";

/** @import { Endpoint, EndpointKind, FromWorker, Qos, ToWorker } from "../protocol.js" */

/**
 * @typedef {{peer: number, id: number}} Remote an endpoint that matches one of ours
 * @typedef {{sequence: number, timestamp: number, message: Uint8Array}} Kept
 * @typedef {{
 *   endpoint: Endpoint, remotes: Remote[], queue: Queue, sequence: number, kept: Kept[],
 * }} Local with the messages that a transient local publisher keeps for those who come late
 */

const SIGINT = 2;
// Browsers make nested timers wait at least this long (ms); timers set by a message are not nested.
const TIMER_CLAMP = 5;

export class Participant {
  #id;
  #post;
  #warn;
  /** @type {Map<number, Local>} */
  #locals = new Map();
  #nextId = 1;
  /** @type {Map<number, Outbox>} */
  #outboxes = new Map();
  /** @type {Set<() => void>} */
  #waiters = new Set();
  #signal = 0;
  #turn = new MessageChannel();
  /** @type {(() => void)[]} */
  #turns = [];

  /**
   * @param {number} id of this worker in the page
   * @param {(message: FromWorker) => void} post to the page
   * @param {(logger: string, text: string) => void} warn on the console of the node
   */
  constructor(id, post, warn) {
    this.#id = id;
    this.#post = post;
    this.#warn = warn;
    this.#turn.port1.onmessage = () => this.#turns.shift()?.();
  }

  /**
   * Announce an endpoint and return its id.
   * @param {EndpointKind} kind @param {string} node @param {string} name @param {string} type
   * @param {Qos} qos
   */
  create(kind, node, name, type, qos) {
    const endpoint = { id: this.#nextId++, kind, node, name, type, qos };
    const queue = new Queue(qos.keepAll ? Infinity : Math.max(qos.depth, 1));
    this.#locals.set(endpoint.id, { endpoint, remotes: [], queue, sequence: 0, kept: [] });
    this.#post({ op: "create", endpoint });
    return endpoint.id;
  }

  /** @param {number} id */
  destroy(id) {
    if (this.#locals.delete(id)) this.#post({ op: "destroy", id });
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

  /** The oldest message that waits at the subscription `id`. @param {number} id */
  next(id) {
    return this.#locals.get(id)?.queue.peek();
  }

  /** Remove that message and return it. @param {number} id */
  take(id) {
    return this.#locals.get(id)?.queue.shift();
  }

  /**
   * Resolve when something happened, at the latest after `milliseconds`: 0 lets the event loop turn
   * once, a negative number sets no limit. The value is a signal that came, or 0.
   * @param {number} milliseconds @returns {Promise<number>}
   */
  wait(milliseconds) {
    for (const outbox of this.#outboxes.values()) outbox.flush();
    return new Promise((resolve) => {
      /** @type {ReturnType<typeof setTimeout> | undefined} */
      let timer;
      const done = () => {
        clearTimeout(timer);
        this.#waiters.delete(done);
        const signal = this.#signal;
        this.#signal = 0;
        resolve(signal);
      };
      if (milliseconds === 0 || this.#signal) {
        this.#nextTurn(done);
        return;
      }
      this.#waiters.add(done);
      const arm = () => {
        if (this.#waiters.has(done)) timer = setTimeout(done, milliseconds);
      };
      if (milliseconds < 0) return;
      if (milliseconds < TIMER_CLAMP) {
        this.#nextTurn(arm);
      } else {
        arm();
      }
    });
  }

  /** End all waits. */
  wake() {
    for (const done of [...this.#waiters]) done();
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
        const remote = { peer: message.peer, id: message.remote };
        local?.remotes.push(remote);
        if (!message.durable) break;
        for (const kept of local?.kept ?? []) this.#send(message.local, remote, kept);
        this.#outboxes.get(message.peer)?.flush();
        break;
      }
      case "unmatch": {
        const remotes = this.#locals.get(message.local)?.remotes ?? [];
        const gone = remotes.findIndex((r) => r.peer === message.peer && r.id === message.remote);
        if (gone >= 0) remotes.splice(gone, 1);
        break;
      }
      case "incompatible":
        this.#tellIncompatible(message.local, message.policy);
        break;
      case "stop":
        this.#signal = SIGINT;
        break;
    }
    this.wake();
  }

  /** @param {number} id @param {Remote} remote @param {Kept} sample */
  #send(id, remote, { sequence, timestamp, message }) {
    const publisher = this.#id * 0x10000 + id;
    const head = { reader: remote.id, publisher, sequence, timestamp };
    if (remote.peer === this.#id) {
      this.#deliver(head, message.slice());
    } else {
      this.#outboxes.get(remote.peer)?.send(head, message);
    }
  }

  /** In the words of ROS, which people know and search for. @param {number} id @param {string} policy */
  #tellIncompatible(id, policy) {
    const endpoint = this.#locals.get(id)?.endpoint;
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
  #deliver({ reader, publisher, sequence, timestamp }, message) {
    // A message may still be under way when its subscription goes.
    this.#locals
      .get(reader)
      ?.queue.push({ publisher, sequence, timestamp, received: now(), message });
  }

  /** @param {() => void} call */
  #nextTurn(call) {
    this.#turns.push(call);
    this.#turn.port2.postMessage(null);
  }
}
