// @ts-check
// The sending side of a publisher: its history, and how much of it each reader has got.
//
// At most a window of messages is in transit to a reader, which gives credits for what it has taken. Further messages
// wait in the history, whose size the quality of service limits.

import { KEPT, WINDOW } from "../budgets.js";
import { HEAD_SIZE, now } from "../protocol.js";
import { Watch } from "./watch.js";

/** @import { Qos } from "../protocol.js" */
/** @import { Remote } from "./local.js" */
/** @import { Status } from "./status.js" */

/**
 * @typedef {{sequence: number, timestamp: number, size: number, message: Uint8Array}} Sample
 * @typedef {{remote: Remote, next: number, records: number, bytes: number}} Flow to one reader: the
 *   next sequence number, and the records and bytes in transit
 */

export class Writer {
  #qos;
  #send;
  /** @type {Flow[]} */
  #flows = [];
  /** Consecutive messages, the newest at the end. @type {Sample[]} */
  #history = [];
  #bytes = 0;
  #sequence = 0;
  #deadline;
  #lease;

  /**
   * @param {Qos} qos
   * @param {Status} status
   * @param {(remote: Remote, sample: Sample, last: boolean) => void} send sends a reader a copy of the message, or the
   *   message itself if this is the `last` reader that needs it
   */
  constructor(qos, status, send) {
    this.#qos = qos;
    this.#send = send;
    this.#deadline = new Watch(qos.deadline, (periods) => status.add("deadline", periods), true);
    const lost = () => status.add("liveliness", 1);
    this.#lease = new Watch(qos.manual ? qos.lease : Infinity, lost, false);
  }

  /** Whether a reliable reader has not got all messages yet. */
  get behind() {
    return this.#flows.some((flow) => this.#owes(flow) && flow.next <= this.#sequence);
  }

  /** Begin to send to a reader, with the history if both are transient local. @param {Remote} remote */
  match(remote) {
    this.#expire();
    const durable = this.#qos.transientLocal && remote.qos.transientLocal;
    const next = this.#sequence + 1 - (durable ? this.#history.length : 0);
    const flow = { remote, next, records: 0, bytes: 0 };
    this.#flows.push(flow);
    this.#advance(flow);
  }

  /** @param {number} gid of the reader */
  unmatch(gid) {
    this.#flows = this.#flows.filter((flow) => flow.remote.gid !== gid);
    this.#trim();
  }

  /**
   * Send a copy of `message` to all readers that have room, and keep one for the others. Return false, without doing
   * anything, if the history is full and must not lose messages.
   * @param {Uint8Array} message @param {boolean} [latched] whether it is for transient local readers only
   */
  publish(message, latched = false) {
    this.#expire();
    if (this.#exceeds(0) && this.#mustKeep()) return false;
    const size = message.length;
    const sample = { sequence: ++this.#sequence, timestamp: now(), size, message };
    let keep = this.#qos.transientLocal;
    for (const flow of this.#flows) {
      if (latched && flow.next === sample.sequence && !flow.remote.qos.transientLocal) {
        flow.next += 1;
      } else if (flow.next === sample.sequence && hasRoom(flow)) {
        this.#pass(flow, sample, false);
      } else {
        keep = true;
      }
    }
    if (keep) this.#keep(sample);
    this.#deadline.touch();
    this.#lease.touch();
    return true;
  }

  /** Assert liveliness, and return the readers to be told. */
  assert() {
    this.#lease.touch();
    return this.#flows.map((flow) => flow.remote);
  }

  /**
   * A reader has taken messages, and has room for more. Return whether it is one of this publisher.
   * @param {number} gid of the reader @param {number} records @param {number} bytes
   */
  credit(gid, records, bytes) {
    const flow = this.#flows.find(({ remote }) => remote.gid === gid);
    if (!flow) return false;
    flow.records = Math.max(0, flow.records - records);
    flow.bytes = Math.max(0, flow.bytes - bytes);
    this.#expire();
    this.#advance(flow);
    this.#trim();
    return true;
  }

  close() {
    this.#deadline.close();
    this.#lease.close();
  }

  /** Whether no message to a reader may be lost. @param {Flow} flow */
  #owes({ remote }) {
    return this.#qos.reliable && remote.qos.reliable;
  }

  /** Send from the history what a reader has room for. @param {Flow} flow */
  #advance(flow) {
    const first = this.#sequence + 1 - this.#history.length;
    while (hasRoom(flow)) {
      const sample = this.#history[flow.next - first];
      if (!sample) break;
      const last = !this.#qos.transientLocal && this.#flows.every(
        (other) => other === flow || other.next > sample.sequence);
      this.#pass(flow, sample, last);
    }
  }

  /** @param {Flow} flow @param {Sample} sample @param {boolean} last */
  #pass(flow, sample, last) {
    flow.next = sample.sequence + 1;
    flow.records += 1;
    flow.bytes += sample.size;
    this.#send(flow.remote, sample, last);
  }

  /** Whether the oldest message must be kept, because a reader has not got it yet. */
  #mustKeep() {
    const { keepAll, reliable } = this.#qos;
    if (!keepAll || !reliable) return false;
    const oldest = this.#sequence + 1 - this.#history.length;
    return this.#flows.some((flow) => this.#owes(flow) && flow.next <= oldest);
  }

  /** Whether the history is larger than allowed. @param {number} more additional messages that are allowed */
  #exceeds(more) {
    const { keepAll, depth } = this.#qos;
    if (!keepAll) return this.#history.length >= Math.max(depth, 1) + more;
    return this.#history.length >= KEPT.records + more || this.#bytes >= KEPT.bytes;
  }

  /** Add a copy to the history, with room for a head before it. @param {Sample} sample */
  #keep({ sequence, timestamp, size, message }) {
    const record = new Uint8Array(HEAD_SIZE + size);
    record.set(message, HEAD_SIZE);
    this.#history.push({ sequence, timestamp, size, message: record.subarray(HEAD_SIZE) });
    this.#bytes += size;
    while (this.#history.length > 1 && this.#exceeds(1) && !this.#mustKeep()) this.#forget();
  }

  /** Drop the oldest message. Readers that have not got it continue with the next. */
  #forget() {
    const oldest = this.#history.shift();
    if (!oldest) return;
    this.#bytes -= oldest.size;
    for (const flow of this.#flows) flow.next = Math.max(flow.next, oldest.sequence + 1);
  }

  /** Drop messages whose lifespan is over. */
  #expire() {
    const { lifespan } = this.#qos;
    if (lifespan === Infinity) return;
    const born = now() - lifespan;
    while (this.#history[0] && this.#history[0].timestamp < born) this.#forget();
  }

  /** Drop messages that all readers have got. */
  #trim() {
    if (this.#qos.transientLocal || this.#history.length === 0) return;
    const needed = Math.min(...this.#flows.map((flow) => flow.next));
    while (this.#history[0] && this.#history[0].sequence < needed) this.#forget();
  }
}

/** @param {{records: number, bytes: number}} flow */
export function hasRoom({ records, bytes }) {
  return records < WINDOW.records && bytes < WINDOW.bytes;
}
