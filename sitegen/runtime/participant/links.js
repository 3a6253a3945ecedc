// @ts-check
// The links of a worker to all workers that it exchanges messages with, itself included.

import { now } from "../protocol.js";
import { Link } from "./link.js";

/** @import { FromPeer, Head } from "../protocol.js" */
/** @import { Listener } from "./link.js" */

export class Links {
  #listenerOf;
  /** By the id of the worker. @type {Map<number, Link | Loopback>} */
  #links = new Map();

  /** @param {number} worker its id @param {(peer: number) => Listener} listenerOf */
  constructor(worker, listenerOf) {
    this.#listenerOf = listenerOf;
    this.#links.set(worker, new Loopback(listenerOf(worker)));
  }

  /** @param {number} peer @param {MessagePort} port */
  open(peer, port) {
    this.#links.set(peer, new Link(port, this.#listenerOf(peer)));
  }

  /**
   * The other worker is gone: receive what it had sent, then call `closed`.
   * @param {number} peer @param {() => void} closed
   */
  close(peer, closed) {
    this.#links.get(peer)?.end(closed);
    this.#links.delete(peer);
  }

  /** Take nothing more of another worker, and send it nothing. @param {number} peer */
  cut(peer) {
    this.#links.get(peer)?.cut();
    this.#links.delete(peer);
  }

  /**
   * Send a message, as Outbox.send does.
   * @param {number} peer @param {Head} head @param {Uint8Array} message @param {boolean} own
   */
  send(peer, head, message, own) {
    this.#links.get(peer)?.send(head, message, own);
  }

  /** @param {number} peer @param {FromPeer} message */
  tell(peer, message) {
    this.#links.get(peer)?.tell(message);
  }

  /** Send what is held back. @param {number} [peer] only to this worker */
  flush(peer) {
    if (peer !== undefined) this.#links.get(peer)?.flush();
    else for (const link of this.#links.values()) link.flush();
  }
}

/** The link of a worker to itself, without a port. */
class Loopback {
  #listener;

  /** @param {Listener} listener */
  constructor(listener) {
    this.#listener = listener;
  }

  /** @param {Head} head @param {Uint8Array} message @param {boolean} own whether the message need not be copied */
  send(head, message, own) {
    this.#listener.deliver(head, own ? message : message.slice(), now());
    this.#listener.wake(); // another thread of the program may wait for it
  }

  /** @param {FromPeer} message */
  tell(message) {
    const { writer, reader } = message;
    if (message.op === "credit") this.#listener.credit(writer, reader, message.records, message.bytes);
    else this.#listener.hear(writer, reader);
    this.#listener.wake();
  }

  flush() {}

  end() {}

  cut() {}
}
