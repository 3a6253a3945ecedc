// @ts-check
// A worker's part in the ROS graph: its endpoints, its links to other workers, what it knows of the graph, and
// waiting.

import { BUDGETS } from "../budgets.js";
import { gidOf, now, splitGid } from "../protocol.js";
import { Early } from "./admission.js";
import { Announced } from "./announced.js";
import { Endpoints } from "./endpoints.js";
import { Links } from "./links.js";
import { Refusals } from "./refusals.js";
import { Surroundings } from "./surroundings.js";
import { Waiting } from "./waiting.js";

/** @import { EndpointKind, FromWorker, Head, Neighbour, Qos, ToWorker } from "../protocol.js" */
/** @import { Listener } from "./link.js" */
/** @import { Actions } from "./local.js" */
/** @import { Received } from "./queue.js" */
/** @import { EventKind } from "./status.js" */
/** @import { Sample } from "./writer.js" */

const SIGINT = 2;
// Messages that subscriptions missed are reported to the page at most this often (ms).
const REPORT = 500;

export class Participant {
  #id;
  #post;
  #endpoints;
  #links;
  #waiting = new Waiting();
  #surroundings;
  #announced;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #report;
  #early = new Early();
  #refusals;
  #largest;
  /** The number of events so far, of all endpoints: unless it has changed, there is no new one. */
  events = 0;

  /**
   * @param {number} id of this worker in the page
   * @param {(message: FromWorker) => void} post to the page
   * @param {boolean} [apart] whether its own endpoints do not match each other: they stand for others, elsewhere
   * @param {number} [largest] the size of the largest frame that it takes, in bytes
   */
  constructor(id, post, apart = false, largest = Infinity) {
    this.#id = id;
    this.#largest = largest;
    this.#refusals = new Refusals(post, (peer) => this.#cut(peer));
    this.#post = post;
    this.#endpoints = new Endpoints(id, apart);
    this.#links = new Links(id, (peer) => this.#listenerOf(peer));
    this.#surroundings = new Surroundings(post);
    this.#announced = new Announced(post);
  }

  /**
   * Announce an endpoint and return its id.
   * @param {EndpointKind} kind @param {string} node @param {string} name @param {string} type
   * @param {Qos} qos
   */
  create(kind, node, name, type, qos) {
    const endpoint = this.#endpoints.add({ kind, node, name, type, qos }, (id) => this.#actionsOf(id));
    this.#surroundings.changes += 1;
    this.#post({ op: "create", endpoint });
    this.#announced.note();
    return endpoint.id;
  }

  /** @param {number} id */
  destroy(id) {
    if (!this.#endpoints.remove(id)) return;
    this.#surroundings.changes += 1;
    this.#post({ op: "destroy", id });
  }

  /** The number of endpoints that match `id` now. @param {number} id */
  matched(id) {
    return this.#endpoints.get(id)?.remotes.length ?? 0;
  }

  /**
   * Send a copy of `message` to all subscriptions that match the publisher `id`. Return false if the publisher keeps
   * all messages and its history is full.
   * @param {number} id @param {Uint8Array} message
   * @param {boolean} [latched] whether it was sent long ago, so that it is for transient local subscriptions only
   */
  publish(id, message, latched) {
    return this.#endpoints.get(id)?.writer?.publish(message, latched) ?? true;
  }

  /** Whether a reliable subscription has not yet got all messages of the publisher `id`. @param {number} id */
  behind(id) {
    return this.#endpoints.get(id)?.writer?.behind ?? false;
  }

  /** Assert that the publisher `id` is alive. @param {number} id */
  assertLiveliness(id) {
    for (const { peer, id: reader } of this.#endpoints.get(id)?.writer?.assert() ?? []) {
      this.#links.tell(peer, { op: "alive", writer: id, reader });
    }
  }

  /**
   * Send a copy of a request from the client `id` to a matching server, if there is one, as soon as it has room. Return
   * the sequence number, which the response will have, too. Throws an Error if too many requests wait.
   * @param {number} id @param {Uint8Array} message
   */
  request(id, message) {
    const local = this.#endpoints.get(id);
    if (!local) return 0;
    const sequence = ++local.requests;
    const server = local.remotes[0];
    if (server) {
      local.ask(sequence, server.gid);
      local.calls?.request(server, { sequence, timestamp: now(), size: message.length, message });
    }
    return sequence;
  }

  /**
   * Send a copy of a response from the server `id` to a client.
   * @param {number} id @param {number} client its gid @param {number} sequence of the request
   * @param {Uint8Array} message
   */
  respond(id, client, sequence, message) {
    if (!this.#endpoints.get(id)) return;
    this.#ask(id, splitGid(client), { sequence, timestamp: now(), message });
  }

  /**
   * Set or remove the content filter of the subscription `id`.
   * @param {number} id @param {((message: Uint8Array) => boolean) | undefined} filter
   */
  filter(id, filter) {
    const reader = this.#endpoints.get(id)?.reader;
    if (reader) reader.filter = filter;
  }

  /** The oldest message that waits at the endpoint `id`, which stays. @param {number} id */
  next(id) {
    return this.#endpoints.get(id)?.peek();
  }

  /** Whether a message waits at the endpoint `id`. @param {number} id */
  has(id) {
    return this.next(id) !== undefined;
  }

  /** The ids of all endpoints where messages wait. */
  filled() {
    return [...this.#endpoints.entries()].flatMap(([id, local]) => (local.peek() ? [id] : []));
  }

  /** Remove the oldest message that waits and return it. @param {number} id @returns {Received | undefined} */
  take(id) {
    return this.#endpoints.get(id)?.take();
  }

  /**
   * Return the event of a kind at the endpoint `id`, if it has changed since the last call.
   * @param {number} id @param {EventKind} kind
   */
  takeEvent(id, kind) {
    return this.#endpoints.get(id)?.status.take(kind);
  }

  /** The gid of the endpoint `id`. @param {number} id */
  gid(id) {
    return gidOf(this.#id, id);
  }

  /** The number of changes of the graph that this worker knows of. */
  get changes() {
    return this.#surroundings.changes;
  }

  /**
   * Return all endpoints of the graph, those of this worker first; undefined until the page has answered.
   * @returns {Neighbour[] | undefined}
   */
  look() {
    const others = this.#surroundings.look();
    if (!others) return undefined;
    const own = [...this.#endpoints.entries()].map(([id, { endpoint }]) => ({ gid: this.gid(id), endpoint }));
    return [...own, ...others];
  }

  /** Send everything that is held back, because the program ends. */
  finish() {
    this.#announced.release();
    this.flush();
  }

  /** Send what is held back. */
  flush() {
    this.#links.flush();
  }

  /** Send what is held back, then wait, as Waiting.wait does. @param {number} milliseconds */
  wait(milliseconds) {
    this.flush();
    return this.#waiting.wait(milliseconds);
  }

  /** The number of wake-ups. */
  get wakes() {
    return this.#waiting.wakes;
  }

  /** End all waits. */
  wake() {
    this.#waiting.wake();
  }

  /** Handle a message of the page. @param {ToWorker} message */
  receive(message) {
    switch (message.op) {
      case "link":
        this.#links.open(message.peer, message.port);
        break;
      case "unlink":
        this.#links.close(message.peer, () => {
          for (const [, { reader }] of this.#endpoints.entries()) reader?.forget(message.peer);
        });
        break;
      case "match": {
        const { local, peer, remote: id, qos } = message;
        if (this.#refusals.of(peer) >= BUDGETS.refused) break;
        const missed = this.#endpoints.get(local)?.match({ gid: gidOf(peer, id), peer, id, qos });
        if (missed) this.#reportMissed();
        this.#links.flush(peer);
        break;
      }
      case "unmatch":
        this.#endpoints.get(message.local)?.unmatch(gidOf(message.peer, message.remote));
        break;
      case "graph":
        this.#surroundings.change(message.come, message.gone);
        break;
      case "settled":
        this.#announced.settled();
        this.flush();
        break;
      case "incompatible":
        this.#endpoints.get(message.local)?.mismatch(message.policy);
        break;
      case "stop":
        this.#waiting.raise(SIGINT);
        break;
    }
    this.wake();
  }

  /** @param {number} id of an endpoint @returns {Actions} */
  #actionsOf(id) {
    return {
      changed: () => {
        this.events += 1;
        this.wake();
      },
      send: (remote, sample, last) => this.#send(id, remote, sample, last),
      ask: (remote, sample) => this.#ask(id, remote, sample),
      credit: (writer, records, bytes) => {
        const { peer, id: there } = splitGid(writer);
        this.#links.tell(peer, { op: "credit", writer: there, reader: id, records, bytes });
      },
      refuse: (writer, what) => this.#refusals.add(splitGid(writer).peer, what),
      early: this.#early,
    };
  }

  /** @param {number} peer @returns {Listener} */
  #listenerOf(peer) {
    return {
      deliver: (head, message, received) => this.#deliver(peer, head, message, received),
      credit: (writer, reader, records, bytes) => {
        const right = this.#of(peer, writer)?.credit(gidOf(peer, reader), records, bytes);
        if (right === false) this.#refusals.add(peer, "news");
        this.#links.flush(peer);
      },
      // A publisher may know of the match before its subscription does.
      hear: (writer, reader) => this.#of(peer, reader)?.hear(gidOf(peer, writer)),
      wake: () => this.wake(),
      refuse: (what) => this.#refusals.add(peer, what),
      largest: this.#largest,
    };
  }

  /**
   * Call `then` when subscriptions that are there already match the publishers that were created before, at once if they
   * do. @param {() => void} then
   */
  whenAnnounced(then) {
    if (this.#announced.known) then();
    else this.#announced.hold(then);
  }

  /**
   * Send a request or a response. The receiver may answer to an endpoint that was created just before, so it must know
   * of that first.
   * @param {number} id @param {{peer: number, id: number}} remote @param {Omit<Sample, "size">} sample
   */
  #ask(id, remote, sample) {
    if (remote.peer === this.#id || this.#announced.known) {
      this.#send(id, remote, sample);
      return;
    }
    // The program continues, and may reuse the memory of its message.
    const copy = { ...sample, message: sample.message.slice() };
    this.#announced.hold(() => this.#send(id, remote, copy));
  }

  /**
   * @param {number} id @param {{peer: number, id: number}} remote @param {Omit<Sample, "size">} sample
   * @param {boolean} [own] whether the message need not be copied, see Outbox.send
   */
  #send(id, { peer, id: reader }, { sequence, timestamp, message }, own = false) {
    this.#links.send(peer, { reader, writer: id, sequence, timestamp }, message, own);
  }

  /** @param {number} peer @param {Head} head @param {Uint8Array} message @param {number} received */
  #deliver(peer, { reader, writer, sequence, timestamp }, message, received) {
    // The receiver may have been destroyed while the message was in transit.
    const local = this.#of(peer, reader);
    const missed = local?.push({ writer: gidOf(peer, writer), sequence, timestamp, received, message });
    if (missed) this.#reportMissed();
  }

  /** The endpoint that another worker means; one may be gone, but not unknown. @param {number} peer @param {number} id */
  #of(peer, id) {
    const local = this.#endpoints.get(id);
    if (!local && !this.#endpoints.knew(id)) this.#refusals.add(peer, "unmatched");
    return local;
  }

  /** Have nothing more to do with a worker that went on sending what it had no right to send. @param {number} peer */
  #cut(peer) {
    this.#links.cut(peer);
    for (const [, local] of this.#endpoints.entries()) {
      for (const { gid } of local.remotes.filter((remote) => remote.peer === peer)) local.unmatch(gid);
    }
  }

  #reportMissed() {
    this.#report ??= setTimeout(() => {
      this.#report = undefined;
      for (const [id, { reader }] of this.#endpoints.entries()) {
        if (reader?.missed) this.#post({ op: "missed", id, count: reader.missed });
      }
    }, REPORT);
  }
}
