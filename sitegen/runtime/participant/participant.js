// @ts-check
// A worker's part of the ROS graph: its endpoints, its links to other workers, and waiting.

import { fromPageId, incompatibility, now, pageId, sends } from "../protocol.js";
import { Announced } from "./announced.js";
import { Link } from "./link.js";
import { Queue } from "./queue.js";
import { Reader } from "./reader.js";
import { Status } from "./status.js";
import { Surroundings } from "./surroundings.js";
import { Waiting } from "./waiting.js";
import { Writer } from "./writer.js";

/** @import { Endpoint, EndpointKind, FromWorker, Head, Neighbour, Policy, Qos, ToWorker } from "../protocol.js" */
/** @import { Received } from "./queue.js" */
/** @import { EventKind } from "./status.js" */
/** @import { Sample } from "./writer.js" */

/**
 * @typedef {{name: number, peer: number, id: number, qos: Qos}} Remote an endpoint that matches one of
 *   ours; `name` is the one it has in the whole page
 * @typedef {{endpoint: Endpoint, remotes: Remote[], status: Status, writer?: Writer, reader?: Reader,
 *   queue?: Queue, sequence: number}} Local a publisher has a writer, a subscription a reader, services and
 *   clients a queue; `sequence` numbers the requests of a client
 */

const SIGINT = 2;
// What subscriptions missed is told to the page this often (ms) at most.
const REPORT = 500;
/** Who receives from whom. @type {Partial<Record<EndpointKind, EndpointKind>>} */
const RECEIVER = { publisher: "subscription", client: "service" };

export class Participant {
  #id;
  #post;
  /** @type {Map<number, Local>} */
  #locals = new Map();
  #nextId = 1;
  /** @type {Map<number, Link>} */
  #links = new Map();
  #waiting = new Waiting();
  #surroundings;
  #announced;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #report;
  /** How many events there were, of all endpoints: who remembers it knows whether to look for new ones. */
  events = 0;

  /**
   * @param {number} id of this worker in the page
   * @param {(message: FromWorker) => void} post to the page
   */
  constructor(id, post) {
    this.#id = id;
    this.#post = post;
    this.#surroundings = new Surroundings(post);
    this.#announced = new Announced(post);
  }

  /**
   * Announce an endpoint and return its id.
   * @param {EndpointKind} kind @param {string} node @param {string} name @param {string} type
   * @param {Qos} qos
   */
  create(kind, node, name, type, qos) {
    const endpoint = { id: this.#nextId++, kind, node, name, type, qos };
    const local = this.#local(endpoint);
    this.#locals.set(endpoint.id, local);
    this.#surroundings.changes += 1;
    for (const other of this.#locals.values()) this.#meet(local, other);
    this.#post({ op: "create", endpoint });
    this.#announced.note();
    return endpoint.id;
  }

  /** @param {number} id */
  destroy(id) {
    const local = this.#locals.get(id);
    if (!local) return;
    this.#locals.delete(id);
    this.#surroundings.changes += 1;
    local.writer?.close();
    local.reader?.close();
    for (const { peer, id: other } of local.remotes) {
      if (peer === this.#id) this.#unmatch(other, pageId(this.#id, id));
    }
    this.#post({ op: "destroy", id });
  }

  /** How many endpoints match `id` now. @param {number} id */
  matched(id) {
    return this.#locals.get(id)?.remotes.length ?? 0;
  }

  /**
   * Send a copy of `message` to all subscriptions that match the publisher `id`. False if it keeps all
   * and is full: its subscriptions must take some first.
   * @param {number} id @param {Uint8Array} message
   */
  publish(id, message) {
    return this.#locals.get(id)?.writer?.publish(message) ?? true;
  }

  /** Whether reliable subscriptions have not yet got all that `id` published. @param {number} id */
  behind(id) {
    return this.#locals.get(id)?.writer?.behind ?? false;
  }

  /** Say that the publisher `id` lives. @param {number} id */
  assertLiveliness(id) {
    for (const { peer, id: reader } of this.#locals.get(id)?.writer?.assert() ?? []) {
      if (peer === this.#id) {
        this.#locals.get(reader)?.reader?.hear(pageId(peer, id));
      } else {
        this.#links.get(peer)?.tell({ op: "alive", writer: id, reader });
      }
    }
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
    if (server) this.#ask(id, server, { sequence, timestamp: now(), message });
    return sequence;
  }

  /**
   * Send a copy of a response from the server `id` to the client that asked.
   * @param {number} id @param {number} client the writer of the request @param {number} sequence of it
   * @param {Uint8Array} message
   */
  respond(id, client, sequence, message) {
    if (!this.#locals.has(id)) return;
    this.#ask(id, fromPageId(client), { sequence, timestamp: now(), message });
  }

  /**
   * Give the program only those messages at the subscription `id` that pass `filter`, all without one.
   * @param {number} id @param {((message: Uint8Array) => boolean) | undefined} filter
   */
  filter(id, filter) {
    const reader = this.#locals.get(id)?.reader;
    if (reader) reader.filter = filter;
  }

  /** The oldest message that waits at the endpoint `id`. @param {number} id */
  next(id) {
    const local = this.#locals.get(id);
    return (local?.reader ?? local?.queue)?.peek();
  }

  /** Whether one waits there. @param {number} id */
  has(id) {
    return this.next(id) !== undefined;
  }

  /** The ids of endpoints where messages wait. */
  filled() {
    return [...this.#locals.keys()].filter((id) => this.has(id));
  }

  /** Remove that message and return it. @param {number} id @returns {Received | undefined} */
  take(id) {
    const local = this.#locals.get(id);
    return local?.reader ? local.reader.take() : local?.queue?.shift();
  }

  /** What happened at the endpoint `id` since it was asked the last time. @param {number} id @param {EventKind} kind */
  takeEvent(id, kind) {
    return this.#locals.get(id)?.status.take(kind);
  }

  /** The name that the endpoint `id` has in the page. @param {number} id */
  nameOf(id) {
    return pageId(this.#id, id);
  }

  /** How often the graph changed, as far as this worker knows. */
  get changes() {
    return this.#surroundings.changes;
  }

  /**
   * All endpoints of the graph, those of this worker first. Undefined the first times: then wait until the
   * page has told.
   * @returns {Neighbour[] | undefined}
   */
  look() {
    const others = this.#surroundings.look();
    if (!others) return undefined;
    const own = [...this.#locals].map(([id, { endpoint }]) => ({ name: this.nameOf(id), endpoint }));
    return [...own, ...others];
  }

  /** Send all that is held back: the program ends. */
  finish() {
    this.#announced.release();
    this.flush();
  }

  /** Send what is held back. */
  flush() {
    for (const link of this.#links.values()) link.flush();
  }

  /** Send what is held back, then wait as `Waiting.wait` says. @param {number} milliseconds */
  wait(milliseconds) {
    this.flush();
    return this.#waiting.wait(milliseconds);
  }

  /** How often something happened that ends waits. */
  get wakes() {
    return this.#waiting.wakes;
  }

  /** End all waits. */
  wake() {
    this.#waiting.wake();
  }

  /** Take what the page says about the graph. @param {ToWorker} message */
  receive(message) {
    switch (message.op) {
      case "link":
        this.#links.set(message.peer, this.#link(message.peer, message.port));
        break;
      case "unlink":
        this.#links.get(message.peer)?.end(() => {
          for (const { reader } of this.#locals.values()) reader?.forget(message.peer);
        });
        this.#links.delete(message.peer);
        break;
      case "match": {
        const { peer, remote: id, qos } = message;
        this.#match(message.local, { name: pageId(peer, id), peer, id, qos });
        this.#links.get(peer)?.flush();
        break;
      }
      case "unmatch":
        this.#unmatch(message.local, pageId(message.peer, message.remote));
        break;
      case "graph":
        this.#surroundings.change(message.come, message.gone);
        break;
      case "settled":
        this.#announced.settled();
        this.flush();
        break;
      case "incompatible":
        this.#mismatch(message.local, message.policy);
        break;
      case "stop":
        this.#waiting.raise(SIGINT);
        break;
    }
    this.wake();
  }

  /** @param {Endpoint} endpoint @returns {Local} */
  #local(endpoint) {
    const { id, kind, qos } = endpoint;
    const status = new Status(() => {
      this.events += 1;
      this.wake();
    });
    /** @type {Local} */
    const local = { endpoint, remotes: [], status, sequence: 0 };
    if (kind === "publisher") {
      local.writer = new Writer(qos, status, (remote, sample, last) => {
        this.#send(id, remote, sample, last);
      });
    } else if (kind === "subscription") {
      local.reader = new Reader(qos, status, (writer, records, bytes) => {
        this.#giveCredit(fromPageId(writer), id, records, bytes);
      });
    } else if (kind === "service" || kind === "client") {
      // Requests and responses are bounded by who waits for them.
      local.queue = new Queue(Infinity);
    }
    return local;
  }

  /** @param {number} peer @param {MessagePort} port */
  #link(peer, port) {
    return new Link(port, {
      deliver: (head, message, received) => this.#deliver(peer, head, message, received),
      credit: (writer, reader, records, bytes) => {
        this.#locals.get(writer)?.writer?.credit(pageId(peer, reader), records, bytes);
        this.#links.get(peer)?.flush();
      },
      hear: (writer, reader) => this.#locals.get(reader)?.reader?.hear(pageId(peer, writer)),
      wake: () => this.wake(),
      complain: (text) => this.#post({ op: "complain", peer, text }),
    });
  }

  /** Match endpoints of this worker, without asking the page. @param {Local} a @param {Local} b */
  #meet(a, b) {
    const [sender, receiver] = sends(a.endpoint) ? [a, b] : [b, a];
    const { endpoint: from } = sender;
    const { endpoint: to } = receiver;
    if (to.kind !== RECEIVER[from.kind] || from.name !== to.name) return;
    const policy = incompatibility(from, to);
    for (const { mine, other } of [{ mine: to, other: from }, { mine: from, other: to }]) {
      const { id, qos } = other;
      if (policy) {
        this.#mismatch(mine.id, policy);
      } else {
        this.#match(mine.id, { name: pageId(this.#id, id), peer: this.#id, id, qos });
      }
    }
  }

  /** @param {number} id @param {Remote} remote */
  #match(id, remote) {
    const local = this.#locals.get(id);
    if (!local) return;
    local.remotes.push(remote);
    local.status.add("matched", 1, 1);
    local.reader?.match(remote);
    local.writer?.match(remote);
  }

  /** @param {number} id @param {number} name of what matched */
  #unmatch(id, name) {
    const local = this.#locals.get(id);
    const gone = local?.remotes.findIndex((remote) => remote.name === name) ?? -1;
    if (!local || gone < 0) return;
    local.remotes.splice(gone, 1);
    local.reader?.unmatch(name);
    local.writer?.unmatch(name);
    local.status.add("matched", 0, -1);
  }

  /** @param {number} id @param {Policy} policy */
  #mismatch(id, policy) {
    this.#locals.get(id)?.status.add(policy === "TYPE" ? "type" : "incompatible", 1, 0, policy);
  }

  /**
   * Send a request or a response. What is done for it there may be told to an endpoint that is new here.
   * @param {number} id @param {{peer: number, id: number}} remote @param {Omit<Sample, "size">} sample
   */
  #ask(id, remote, sample) {
    if (remote.peer === this.#id || this.#announced.known) {
      this.#send(id, remote, sample);
      return;
    }
    // The program goes on, and may use the memory of its message again.
    const copy = { ...sample, message: sample.message.slice() };
    this.#announced.hold(() => this.#send(id, remote, copy));
  }

  /**
   * @param {number} id @param {{peer: number, id: number}} remote @param {Omit<Sample, "size">} sample
   * @param {boolean} [own] whether the message may be given away, with room for its head before it
   */
  #send(id, { peer, id: reader }, { sequence, timestamp, message }, own = false) {
    const head = { reader, writer: id, sequence, timestamp };
    if (peer === this.#id) {
      this.#deliver(peer, head, own ? message : message.slice(), now());
      this.wake(); // another thread of this program may wait for it
    } else {
      this.#links.get(peer)?.send(head, message, own);
    }
  }

  /** @param {number} peer @param {Head} head @param {Uint8Array} message @param {number} received */
  #deliver(peer, { reader, writer, sequence, timestamp }, message, received) {
    const local = this.#locals.get(reader);
    // A message may still be under way when its receiver goes.
    if (!local) return;
    const sample = { writer: pageId(peer, writer), sequence, timestamp, received, message };
    local.queue?.push(sample);
    if (!local.reader) return;
    const { missed } = local.reader;
    local.reader.push(sample);
    if (local.reader.missed > missed) this.#reportMissed();
  }

  /** @param {{peer: number, id: number}} writer @param {number} reader @param {number} records @param {number} bytes */
  #giveCredit({ peer, id: writer }, reader, records, bytes) {
    if (peer === this.#id) {
      this.#locals.get(writer)?.writer?.credit(pageId(peer, reader), records, bytes);
      this.wake();
    } else {
      this.#links.get(peer)?.tell({ op: "credit", writer, reader, records, bytes });
    }
  }

  #reportMissed() {
    this.#report ??= setTimeout(() => {
      this.#report = undefined;
      for (const [id, { reader }] of this.#locals) {
        if (reader?.missed) this.#post({ op: "missed", id, count: reader.missed });
      }
    }, REPORT);
  }
}
