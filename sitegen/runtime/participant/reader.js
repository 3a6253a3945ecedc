// @ts-check
// The receiving side of a subscription: the messages that wait for the program, and the credits for publishers.

import { splitGid, now } from "../protocol.js";
import { Inflow } from "./inflow.js";
import { Queue } from "./queue.js";
import { Watch } from "./watch.js";

/** @import { Qos, Refusal } from "../protocol.js" */
/** @import { Remote } from "./local.js" */
/** @import { Received } from "./queue.js" */
/** @import { Status } from "./status.js" */

/**
 * A publisher: the last sequence number, what has arrived from it, and whether it is alive. Of a publisher with manual
 * liveliness that is unknown until it publishes or asserts it.
 * @typedef {{remote?: Remote, last: number, inflow: Inflow, alive?: boolean, lease?: Watch}} Source
 */

export class Reader {
  #queue;
  #qos;
  #status;
  #credit;
  #refuse;
  /** By the publisher's gid. @type {Map<number, Source>} */
  #sources = new Map();
  #deadline;
  /** Whether a message is for the program. @type {((message: Uint8Array) => boolean) | undefined} */
  filter;
  /** The number of messages that never reached the program, because it was too slow. */
  missed = 0;

  /**
   * @param {Qos} qos
   * @param {Status} status
   * @param {(writer: number, records: number, bytes: number) => void} credit tells a publisher what was taken
   * @param {(writer: number, what: Refusal) => void} refuse called when a message is dropped that has no right to come
   */
  constructor(qos, status, credit, refuse) {
    this.#qos = qos;
    this.#status = status;
    this.#credit = credit;
    this.#refuse = refuse;
    this.#queue = new Queue(qos.keepAll ? Infinity : Math.max(qos.depth, 1));
    this.#deadline = new Watch(qos.deadline, (periods) => status.add("deadline", periods), true);
  }

  /** @param {Remote} remote */
  match(remote) {
    const source = this.#source(remote.gid);
    source.remote = remote;
    const { manual, lease } = remote.qos;
    if (lease === Infinity) return;
    source.lease = new Watch(manual ? lease : Infinity, () => this.#setAlive(source, false), false);
    if (!manual) this.#live(source);
  }

  /** @param {number} gid of the publisher */
  unmatch(gid) {
    const source = this.#sources.get(gid);
    if (!source) return;
    source.lease?.close();
    this.#setAlive(source, undefined);
    this.#sources.delete(gid);
  }

  /**
   * Forget the publishers of a worker that is gone, whose last messages arrived after `unmatch`.
   * @param {number} peer
   */
  forget(peer) {
    for (const gid of this.#sources.keys()) {
      if (splitGid(gid).peer === peer) this.#sources.delete(gid);
    }
  }

  /** A publisher has asserted its liveliness. @param {number} gid */
  hear(gid) {
    this.#live(this.#source(gid));
  }

  /** @param {Received} sample */
  push(sample) {
    const source = this.#source(sample.writer);
    if (!source.inflow.arrive(sample.message.length)) {
      this.#refuse(sample.writer, "overrun");
      return;
    }
    const lost = source.last > 0 ? sample.sequence - source.last - 1 : 0;
    if (lost > 0) this.#status.add("lost", lost);
    source.last = sample.sequence;
    this.#live(source);
    this.missed += Math.max(lost, 0);
    if (this.filter && !this.filter(sample.message)) {
      this.#consumed(sample);
      return;
    }
    this.#deadline.touch();
    const replaced = this.#queue.push(sample);
    if (replaced) this.#consumed(replaced);
    this.missed += replaced ? 1 : 0;
  }

  /** Return the oldest message, which stays. */
  peek() {
    this.#expire();
    return this.#queue.peek();
  }

  /** Remove the oldest message and return it. */
  take() {
    this.#expire();
    const sample = this.#queue.shift();
    if (sample) this.#consumed(sample);
    return sample;
  }

  close() {
    this.#deadline.close();
    for (const { lease } of this.#sources.values()) lease?.close();
  }

  /** @param {number} gid */
  #source(gid) {
    let source = this.#sources.get(gid);
    if (!source) {
      source = { last: 0, inflow: new Inflow() };
      this.#sources.set(gid, source);
    }
    return source;
  }

  /** Count a message for which the publisher gets credit, many at once. @param {Received} sample that left the queue */
  #consumed({ writer, message }) {
    this.#sources.get(writer)?.inflow.leave(message.length, writer, this.#credit);
  }

  #expire() {
    const { lifespan } = this.#qos;
    if (lifespan === Infinity) return;
    const born = now() - lifespan;
    for (let oldest; (oldest = this.#queue.peek()) && oldest.timestamp < born;) {
      this.#queue.shift();
      this.#consumed(oldest);
    }
  }

  /** @param {Source} source */
  #live(source) {
    if (!source.lease) return;
    source.lease.touch();
    this.#setAlive(source, true);
  }

  /** @param {Source} source @param {boolean | undefined} alive */
  #setAlive(source, alive) {
    if (source.alive === alive) return;
    const count = (/** @type {boolean} */ state) => Number(alive === state) - Number(source.alive === state);
    const [dead, living] = [count(false), count(true)];
    source.alive = alive;
    this.#status.add("liveliness", dead, living);
  }
}
