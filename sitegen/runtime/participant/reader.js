// @ts-check
// The receiving side of a subscription: what waits for the program, and the credits that it gives.

import { fromPageId, now } from "../protocol.js";
import { Queue } from "./queue.js";
import { Watch } from "./watch.js";
import { WINDOW } from "./writer.js";

/** @import { Qos } from "../protocol.js" */
/** @import { Remote } from "./participant.js" */
/** @import { Received } from "./queue.js" */
/** @import { Status } from "./status.js" */

// Credits go out when half of a window is used up, or after this time (ms): a publisher that waits for a
// slow program then goes on at that program's pace.
const PAUSE = 50;

/**
 * A publisher: the last sequence number it sent, what was taken of it since it got credits and when that
 * was, and whether it lives, which is not known before it says something if it has to say so by itself.
 * @typedef {{remote?: Remote, last: number, records: number, bytes: number, credited: number,
 *   alive?: boolean, lease?: Watch}} Source
 */

export class Reader {
  #queue;
  #qos;
  #status;
  #credit;
  /** By the publisher's name in the page. @type {Map<number, Source>} */
  #sources = new Map();
  #deadline;
  /** Whether the program is given a message. @type {((message: Uint8Array) => boolean) | undefined} */
  filter;
  /** How many messages never reached the program, because it was too slow for them. */
  missed = 0;

  /**
   * @param {Qos} qos
   * @param {Status} status
   * @param {(writer: number, records: number, bytes: number) => void} credit tell a publisher what was taken
   */
  constructor(qos, status, credit) {
    this.#qos = qos;
    this.#status = status;
    this.#credit = credit;
    this.#queue = new Queue(qos.keepAll ? Infinity : Math.max(qos.depth, 1));
    this.#deadline = new Watch(qos.deadline, (periods) => status.add("deadline", periods), true);
  }

  /** @param {Remote} remote */
  match(remote) {
    const source = this.#source(remote.name);
    source.remote = remote;
    const { manual, lease } = remote.qos;
    if (lease === Infinity) return;
    source.lease = new Watch(manual ? lease : Infinity, () => this.#setAlive(source, false), false);
    // Its messages may have come before the news that it is there.
    if (!manual || source.last > 0) this.#live(source);
  }

  /** @param {number} name of the publisher */
  unmatch(name) {
    const source = this.#sources.get(name);
    if (!source) return;
    source.lease?.close();
    this.#setAlive(source, undefined);
    this.#sources.delete(name);
  }

  /** Forget all publishers of a worker that is gone: some messages may have come after `unmatch`. @param {number} peer */
  forget(peer) {
    for (const name of this.#sources.keys()) {
      if (fromPageId(name).peer === peer) this.#sources.delete(name);
    }
  }

  /** A publisher lives, though it has nothing to say. @param {number} name */
  hear(name) {
    this.#live(this.#source(name));
  }

  /** @param {Received} sample */
  push(sample) {
    const source = this.#source(sample.writer);
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

  /** The oldest message, which stays. */
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

  /** @param {number} name */
  #source(name) {
    let source = this.#sources.get(name);
    if (!source) {
      source = { last: 0, records: 0, bytes: 0, credited: 0 };
      this.#sources.set(name, source);
    }
    return source;
  }

  /** Give credits, many at once. @param {Received} sample that left the queue */
  #consumed({ writer, message }) {
    const source = this.#sources.get(writer);
    if (!source) return;
    source.records += 1;
    source.bytes += message.length;
    const { records, bytes, credited } = source;
    const time = now();
    if (records < WINDOW.records / 2 && bytes < WINDOW.bytes / 2 && time - credited < PAUSE) return;
    source.credited = time;
    source.records = 0;
    source.bytes = 0;
    this.#credit(writer, records, bytes);
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
