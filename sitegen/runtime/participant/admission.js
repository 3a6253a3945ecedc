// @ts-check
// Which messages an endpoint takes: those of the endpoints that match it and, at a client, the responses to its requests.
// Workers may run any program, and a link lets them address every endpoint of each other.

import { BUDGETS } from "../budgets.js";
import { splitGid } from "../protocol.js";

/** @import { EndpointKind, Refusal } from "../protocol.js" */
/** @import { Received } from "./queue.js" */

// Messages and the news of matches come by different ways. A message may be this much before the beginning, or behind
// the end, of a match (ms).
const GRACE = 2000;
// The most requests whose responses are expected. A server may never answer.
const ASKED = 65_536;

/** How much of each worker waits for the news of its match, at all endpoints. */
export class Early {
  /** @type {Map<number, {records: number, bytes: number}>} */
  #waiting = new Map();

  /** Count one more message; return false if there are too many. @param {number} writer @param {number} size */
  add(writer, size) {
    const { peer } = splitGid(writer);
    const { records, bytes } = this.#waiting.get(peer) ?? { records: 0, bytes: 0 };
    if (records >= BUDGETS.early.records || bytes + size > BUDGETS.early.bytes) return false;
    this.#waiting.set(peer, { records: records + 1, bytes: bytes + size });
    return true;
  }

  /** @param {number} writer @param {Received[]} samples that wait no more */
  remove(writer, samples) {
    const { peer } = splitGid(writer);
    const waiting = this.#waiting.get(peer);
    if (!waiting) return;
    waiting.records -= samples.length;
    for (const { message } of samples) waiting.bytes -= message.length;
    if (waiting.records === 0) this.#waiting.delete(peer);
  }
}

export class Admission {
  #ofClient;
  #refuse;
  #waiting;
  /** The gids of endpoints that match, or did so a moment ago. @type {Set<number>} */
  #known = new Set();
  /** Messages of other endpoints, by the gid of the writer. @type {Map<number, Received[]>} */
  #early = new Map();
  /** The gids of the servers that were asked, by the number of the request. @type {Map<number, number>} */
  #asked = new Map();

  /**
   * @param {EndpointKind} kind @param {(writer: number, what: Refusal) => void} refuse called when a message is dropped
   * @param {Early} early of all endpoints of this worker
   */
  constructor(kind, refuse, early) {
    this.#ofClient = kind === "client";
    this.#refuse = refuse;
    this.#waiting = early;
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
      this.#refuse(writer, "response");
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
    if (!this.#waiting.add(writer, message.length)) {
      this.#refuse(writer, "unmatched");
      return;
    }
    const early = this.#early.get(writer);
    if (early) {
      early.push(sample);
      return;
    }
    this.#early.set(writer, [sample]);
    setTimeout(() => {
      for (const _ of this.#release(writer)) this.#refuse(writer, "unmatched");
    }, GRACE);
  }

  /** Remove the messages that wait for the match of a writer, and return them. @param {number} writer */
  #release(writer) {
    const early = this.#early.get(writer) ?? [];
    this.#early.delete(writer);
    this.#waiting.remove(writer, early);
    return early;
  }
}
