// @ts-check
// What a worker sends to one other worker: records, alone when there is time, in batches when not.

import { HEAD_SIZE, recordSize, writeRecord } from "../protocol.js";

/** @import { Head } from "../protocol.js" */

const BATCH_SIZE = 64 * 1024;
// So many records leave one by one after each wait: they are not held back by a program that goes on
// to compute. Only a burst is worth a batch.
const BURST = 4;
// A program that publishes slower than this (ms) gets no batches either.
const PAUSE = 1;
// Handing a buffer over costs more than copying one of this size (bytes).
const SMALL = 1024;

export class Outbox {
  #port;
  #batch = new Uint8Array(BATCH_SIZE);
  #used = 0;
  #posted = 0;
  #lastPost = 0;

  /** @param {MessagePort} port */
  constructor(port) {
    this.#port = port;
  }

  /** Send a copy of `message`. @param {Head} head @param {Uint8Array} message */
  send(head, message) {
    const size = recordSize(message.length);
    const pause = head.timestamp - this.#lastPost > PAUSE;
    if (size > BATCH_SIZE || (this.#used === 0 && (pause || this.#posted < BURST))) {
      this.#flushBatch();
      const frame = new Uint8Array(HEAD_SIZE + message.length);
      writeRecord(frame, 0, head, message);
      this.#post(frame.buffer, head.timestamp);
      return;
    }
    if (this.#used + size > BATCH_SIZE) this.#flushBatch();
    writeRecord(this.#batch, this.#used, head, message);
    this.#used += size;
    if (pause) this.#flushBatch();
  }

  /** Send what is held back; the program is about to wait. */
  flush() {
    this.#flushBatch();
    this.#posted = 0;
  }

  #flushBatch() {
    if (this.#used === 0) return;
    const frame = this.#batch.slice(0, this.#used).buffer;
    this.#used = 0;
    this.#post(frame, this.#lastPost);
  }

  /** @param {ArrayBuffer} frame @param {number} time */
  #post(frame, time) {
    this.#port.postMessage(frame, frame.byteLength > SMALL ? [frame] : []);
    this.#posted += 1;
    this.#lastPost = time;
  }
}
