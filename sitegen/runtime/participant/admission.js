// @ts-check
// Which messages an endpoint takes: those of the endpoints that match it and, at a client, the responses to its requests.
// Workers may run any program, and a link lets them address every endpoint of each other.

/** @import { EndpointKind } from "../protocol.js" */
/** @import { Received } from "./queue.js" */

// Messages and the news of matches come by different ways. A message may be this much before the beginning, or behind
// the end, of a match (ms).
const GRACE = 2000;
// The most messages that wait for the news of their match. Genuine publishers send no more before the first credits.
const EARLY = { records: 4096, bytes: 64 * 1024 * 1024 };
// The most requests whose responses are expected. A server may never answer.
const ASKED = 65_536;

export class Admission {
  #ofClient;
  #refuse;
  /** The gids of endpoints that match, or did so a moment ago. @type {Set<number>} */
  #known = new Set();
  /** Messages of other endpoints, by the gid of the writer. @type {Map<number, Received[]>} */
  #early = new Map();
  #waiting = { records: 0, bytes: 0 };
  /** The gids of the servers that were asked, by the number of the request. @type {Map<number, number>} */
  #asked = new Map();

  /** @param {EndpointKind} kind @param {(writer: number, what: string) => void} refuse called when a message is dropped */
  constructor(kind, refuse) {
    this.#ofClient = kind === "client";
    this.#refuse = refuse;
  }

  /** An endpoint matches: return its messages that came before. @param {number} gid */
  match(gid) {
    this.#known.add(gid);
    return this.#release(gid);
  }

  /** An endpoint matches no more. @param {number} gid */
  unmatch(gid) {
    setTimeout(() => this.#known.delete(gid), GRACE);
  }

  /** A request was sent. @param {number} sequence @param {number} server its gid */
  ask(sequence, server) {
    this.#asked.set(sequence, server);
    if (this.#asked.size > ASKED) this.#asked.delete(/** @type {number} */ (this.#asked.keys().next().value));
  }

  /** Return whether a message is to be taken now; one that is early waits for its match. @param {Received} sample */
  admits(sample) {
    const { writer, sequence } = sample;
    if (!this.#ofClient) {
      if (this.#known.has(writer)) return true;
      this.#hold(sample);
      return false;
    }
    if (this.#asked.get(sequence) !== writer) {
      this.#refuse(writer, "a response to a request that it was not sent");
      return false;
    }
    return this.#asked.delete(sequence);
  }

  /** Whether an endpoint matches. @param {number} gid */
  knows(gid) {
    return this.#known.has(gid);
  }

  /** @param {Received} sample */
  #hold(sample) {
    const { writer, message } = sample;
    const { records, bytes } = this.#waiting;
    if (records >= EARLY.records || bytes + message.length > EARLY.bytes) {
      this.#refuse(writer, "messages to an endpoint that does not match");
      return;
    }
    this.#waiting = { records: records + 1, bytes: bytes + message.length };
    const early = this.#early.get(writer);
    if (early) {
      early.push(sample);
      return;
    }
    this.#early.set(writer, [sample]);
    setTimeout(() => {
      if (this.#release(writer).length) this.#refuse(writer, "messages to an endpoint that does not match");
    }, GRACE);
  }

  /** Remove the messages that wait for the match of a writer, and return them. @param {number} writer */
  #release(writer) {
    const early = this.#early.get(writer) ?? [];
    this.#early.delete(writer);
    for (const { message } of early) {
      this.#waiting.records -= 1;
      this.#waiting.bytes -= message.length;
    }
    return early;
  }
}
