// @ts-check
// The sending side of a publisher: what it keeps, and how far each of its readers has got.
//
// A reader gives credits: no more than a window is under way to it. What it has no room for stays here,
// where quality of service says how much that may be.

import { HEAD_SIZE, now } from "../protocol.js";
import { Watch } from "./watch.js";

/** @import { Qos } from "../protocol.js" */
/** @import { Remote } from "./participant.js" */
/** @import { Status } from "./status.js" */

/**
 * @typedef {{sequence: number, timestamp: number, size: number, message: Uint8Array}} Sample
 * @typedef {{remote: Remote, next: number, records: number, bytes: number}} Flow to one reader: the
 *   sequence number it gets next, and what is under way
 */

/** What may be under way to one reader. More does not make it faster, and cannot be taken back. */
export const WINDOW = { records: 1024, bytes: 32 * 1024 * 1024 };
// What a publisher that keeps all holds for readers without room; Fast DDS has 5000.
const KEPT = { records: 5000, bytes: 64 * 1024 * 1024 };

export class Writer {
  #qos;
  #send;
  /** @type {Flow[]} */
  #flows = [];
  /** Without gaps, and up to the newest message unless empty. @type {Sample[]} */
  #history = [];
  #bytes = 0;
  #sequence = 0;
  #deadline;
  #lease;

  /**
   * @param {Qos} qos
   * @param {Status} status
   * @param {(remote: Remote, sample: Sample, last: boolean) => void} send a copy of the message to a reader,
   *   or the message itself if it is the last that needs it
   */
  constructor(qos, status, send) {
    this.#qos = qos;
    this.#send = send;
    this.#deadline = new Watch(qos.deadline, (periods) => status.add("deadline", periods), true);
    const lost = () => status.add("liveliness", 1);
    this.#lease = new Watch(qos.manual ? qos.lease : Infinity, lost, false);
  }

  /** Whether a reader that must get all has not got all yet. */
  get behind() {
    return this.#flows.some((flow) => this.#owes(flow) && flow.next <= this.#sequence);
  }

  /** Begin to send to a reader, with what is kept if both are transient local. @param {Remote} remote */
  match(remote) {
    this.#expire();
    const durable = this.#qos.transientLocal && remote.qos.transientLocal;
    const next = this.#sequence + 1 - (durable ? this.#history.length : 0);
    const flow = { remote, next, records: 0, bytes: 0 };
    this.#flows.push(flow);
    this.#advance(flow);
  }

  /** @param {number} name of the reader */
  unmatch(name) {
    this.#flows = this.#flows.filter((flow) => flow.remote.name !== name);
    this.#trim();
  }

  /**
   * Send a copy of `message` to all readers that have room, and keep one for the others. False if all
   * has to be kept and there is no room for it: then nothing was done.
   * @param {Uint8Array} message
   */
  publish(message) {
    this.#expire();
    if (this.#exceeds(0) && this.#mustKeep()) return false;
    const size = message.length;
    const sample = { sequence: ++this.#sequence, timestamp: now(), size, message };
    let keep = this.#qos.transientLocal;
    for (const flow of this.#flows) {
      if (flow.next === sample.sequence && hasRoom(flow)) {
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

  /** It lives, though it has nothing to say. Returns the readers that have to be told. */
  assert() {
    this.#lease.touch();
    return this.#flows.map((flow) => flow.remote);
  }

  /**
   * A reader has taken so much of what it got, and has room for more.
   * @param {number} name of the reader @param {number} records @param {number} bytes
   */
  credit(name, records, bytes) {
    const flow = this.#flows.find(({ remote }) => remote.name === name);
    if (!flow) return;
    flow.records = Math.max(0, flow.records - records);
    flow.bytes = Math.max(0, flow.bytes - bytes);
    this.#expire();
    this.#advance(flow);
    this.#trim();
  }

  close() {
    this.#deadline.close();
    this.#lease.close();
  }

  /** Whether a reader must get every message. @param {Flow} flow */
  #owes({ remote }) {
    return this.#qos.reliable && remote.qos.reliable;
  }

  /** Send what is kept, as far as there is room. @param {Flow} flow */
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

  /** Whether its oldest message may not be lost, and somebody has not got it yet. */
  #mustKeep() {
    const { keepAll, reliable } = this.#qos;
    if (!keepAll || !reliable) return false;
    const oldest = this.#sequence + 1 - this.#history.length;
    return this.#flows.some((flow) => this.#owes(flow) && flow.next <= oldest);
  }

  /** @param {number} more messages than may be kept */
  #exceeds(more) {
    const { keepAll, depth } = this.#qos;
    if (!keepAll) return this.#history.length >= Math.max(depth, 1) + more;
    return this.#history.length >= KEPT.records + more || this.#bytes >= KEPT.bytes;
  }

  /** Keep a copy, with room before it for the head that it is sent with. @param {Sample} sample */
  #keep({ sequence, timestamp, size, message }) {
    const record = new Uint8Array(HEAD_SIZE + size);
    record.set(message, HEAD_SIZE);
    this.#history.push({ sequence, timestamp, size, message: record.subarray(HEAD_SIZE) });
    this.#bytes += size;
    while (this.#history.length > 1 && this.#exceeds(1) && !this.#mustKeep()) this.#forget();
  }

  /** Forget the oldest. Who has not got it yet goes on with the next. */
  #forget() {
    const oldest = this.#history.shift();
    if (!oldest) return;
    this.#bytes -= oldest.size;
    for (const flow of this.#flows) flow.next = Math.max(flow.next, oldest.sequence + 1);
  }

  /** Forget what has grown too old. */
  #expire() {
    const { lifespan } = this.#qos;
    if (lifespan === Infinity) return;
    const born = now() - lifespan;
    while (this.#history[0] && this.#history[0].timestamp < born) this.#forget();
  }

  /** Forget what everybody has got. */
  #trim() {
    if (this.#qos.transientLocal || this.#history.length === 0) return;
    const needed = Math.min(...this.#flows.map((flow) => flow.next));
    while (this.#history[0] && this.#history[0].sequence < needed) this.#forget();
  }
}

/** @param {Flow} flow */
function hasRoom({ records, bytes }) {
  return records < WINDOW.records && bytes < WINDOW.bytes;
}
