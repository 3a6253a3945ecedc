// @ts-check
// An endpoint of this worker: which endpoints match it, what it sends and which messages wait at it.

import { Admission } from "./admission.js";
import { Calls } from "./calls.js";
import { Inbox } from "./inbox.js";
import { Reader } from "./reader.js";
import { Status } from "./status.js";
import { Writer } from "./writer.js";

/** @import { Endpoint, Policy, Qos, Refusal } from "../protocol.js" */
/** @import { Early } from "./admission.js" */
/** @import { Received } from "./queue.js" */
/** @import { Sample } from "./writer.js" */

/**
 * @typedef {{gid: number, peer: number, id: number, qos: Qos}} Remote an endpoint that matches a local one: its
 *   worker, and its id there
 * @typedef {{
 *   changed(): void,
 *   send(remote: Remote, sample: Sample, last: boolean): void,
 *   ask(remote: Remote, sample: Sample): void,
 *   credit(writer: number, records: number, bytes: number): void,
 *   refuse(writer: number, what: Refusal): void,
 *   early: Early,
 * }} Actions what an endpoint calls: after an event; to send a message, as Writer says, or a request; to give a sender
 *   credits; to tell that it drops what a writer had no right to send. `early` is how much waits for the news of its
 *   match
 */

export class Local {
  endpoint;
  /** @type {Remote[]} */
  remotes = [];
  status;
  /** Of a publisher. @type {Writer | undefined} */
  writer;
  /** Of a subscription. @type {Reader | undefined} */
  reader;
  /** Of a client. @type {Calls | undefined} */
  calls;
  /** Of a service or a client. @type {Inbox | undefined} */
  #inbox;
  #admission;
  /** The number of requests that a client has sent. */
  requests = 0;

  /** @param {Endpoint} endpoint @param {Actions} actions */
  constructor(endpoint, { changed, send, ask, credit, refuse, early }) {
    this.endpoint = endpoint;
    const { kind, name, qos } = endpoint;
    this.#admission = new Admission(kind, refuse, early);
    this.status = new Status(changed);
    if (kind === "publisher") {
      this.writer = new Writer(qos, this.status, send);
    } else if (kind === "subscription") {
      this.reader = new Reader(qos, this.status, credit, refuse);
    } else if (kind === "service" || kind === "client") {
      this.#inbox = new Inbox(kind === "service", credit, refuse);
      if (kind === "client") this.calls = new Calls(name, ask);
    }
  }

  /** Return whether the program missed a message, of those that were early. @param {Remote} remote */
  match(remote) {
    this.remotes.push(remote);
    this.status.add("matched", 1, 1);
    this.reader?.match(remote);
    this.writer?.match(remote);
    return this.#admission.match(remote.gid).map((sample) => this.#add(sample)).some(Boolean);
  }

  /** @param {number} gid of the other endpoint */
  unmatch(gid) {
    const at = this.remotes.findIndex((remote) => remote.gid === gid);
    if (at < 0) return;
    this.remotes.splice(at, 1);
    this.#admission.unmatch(gid);
    this.reader?.unmatch(gid);
    this.writer?.unmatch(gid);
    this.calls?.unmatch(gid);
    this.#inbox?.unmatch(gid);
    this.status.add("matched", 0, -1);
  }

  /** Another endpoint would match, but for `policy`. @param {Policy} policy */
  mismatch(policy) {
    this.status.add(policy === "TYPE" ? "type" : "incompatible", 1, 0, policy);
  }

  /** A client has sent a request. @param {number} sequence @param {number} server its gid */
  ask(sequence, server) {
    this.#admission.ask(sequence, server);
  }

  /**
   * Add a message that arrived, if its writer may send it. Return whether the program missed a message.
   * @param {Received} sample
   */
  push(sample) {
    return this.#admission.admits(sample) && this.#add(sample);
  }

  /**
   * A receiver has room for more. Return whether it may say so.
   * @param {number} gid @param {number} records @param {number} bytes
   */
  credit(gid, records, bytes) {
    return (this.writer ?? this.calls)?.credit(gid, records, bytes) || this.#admission.knows(gid);
  }

  /** A publisher has asserted its liveliness. @param {number} gid */
  hear(gid) {
    if (this.#admission.knows(gid)) this.reader?.hear(gid);
  }

  /** @param {Received} sample */
  #add(sample) {
    this.#inbox?.push(sample);
    if (!this.reader) return false;
    const { missed } = this.reader;
    this.reader.push(sample);
    return this.reader.missed > missed;
  }

  /** The oldest message that waits, which stays. */
  peek() {
    return (this.reader ?? this.#inbox)?.peek();
  }

  /** Remove the oldest message and return it. */
  take() {
    return (this.reader ?? this.#inbox)?.take();
  }

  close() {
    this.writer?.close();
    this.reader?.close();
  }
}
