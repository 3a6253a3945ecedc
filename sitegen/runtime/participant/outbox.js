// @ts-check
// What a worker sends to another one: records, in batches when many are sent in a short time.

import { BATCH_SIZE } from "../budgets.js";
import { HEAD_SIZE, recordSize, writeHead } from "../protocol.js";

/** @import { Head } from "../protocol.js" */

// The number of records that are sent immediately after each wait. They must not be delayed by a program that computes
// for a long time without waiting; only more than these are worth a batch.
const BURST = 4;
// Records further apart than this (ms) are sent immediately, too.
const PAUSE = 1;
// Transferring a buffer is slower than copying up to this size (bytes).
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

  /**
   * Send a copy of `message`, or the message itself if it is `own`: not used elsewhere, with room for a head before it.
   * @param {Head} head @param {Uint8Array} message @param {boolean} own
   */
  send(head, message, own) {
    const size = recordSize(message.length);
    const pause = head.timestamp - this.#lastPost > PAUSE;
    if (size > BATCH_SIZE || (this.#used === 0 && (pause || this.#posted < BURST))) {
      this.#flushBatch();
      const frame = own ? new Uint8Array(message.buffer) : new Uint8Array(HEAD_SIZE + message.length);
      writeHead(frame, 0, head, message.length);
      if (!own) frame.set(message, HEAD_SIZE);
      this.#post(/** @type {ArrayBuffer} */ (frame.buffer), head.timestamp);
      return;
    }
    if (this.#used + size > BATCH_SIZE) this.#flushBatch();
    writeHead(this.#batch, this.#used, head, message.length);
    this.#batch.set(message, this.#used + HEAD_SIZE);
    this.#used += size;
    if (pause) this.#flushBatch();
  }

  /** Send the batch, because the program is about to wait. */
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
