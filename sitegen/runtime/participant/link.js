// @ts-check
// The port to another worker. What arrives is checked, because that worker may run any program.

import { BATCH_SIZE } from "../budgets.js";
import { isRecord, now, readRecords } from "../protocol.js";
import { Outbox } from "./outbox.js";

/** @import { FromPeer, Head, Refusal } from "../protocol.js" */

// Messages that a worker sent before it ended arrive within this time (ms). Not all browsers report a closed port.
const LINGER = 1000;

/**
 * @typedef {{
 *   deliver(head: Head, message: Uint8Array, received: number): void,
 *   credit(writer: number, reader: number, records: number, bytes: number): void,
 *   hear(writer: number, reader: number): void,
 *   wake(): void,
 *   refuse(what: Refusal): void,
 *   largest: number,
 * }} Listener `writer` and `reader` are ids of endpoints in their own workers; `largest` is the size of the largest
 *   frame that is taken
 */

export class Link {
  #port;
  #outbox;
  #listener;

  /** @param {MessagePort} port @param {Listener} listener */
  constructor(port, listener) {
    this.#port = port;
    this.#outbox = new Outbox(port);
    this.#listener = listener;
    port.onmessage = (event) => this.#receive(event.data);
    port.onmessageerror = () => this.#listener.refuse("frame");
  }

  /** Send a message, as Outbox.send does. @param {Head} head @param {Uint8Array} message @param {boolean} own */
  send(head, message, own) {
    this.#outbox.send(head, message, own);
  }

  /** @param {FromPeer} message */
  tell(message) {
    this.#port.postMessage(message);
  }

  /** Send what is held back. */
  flush() {
    this.#outbox.flush();
  }

  /**
   * The other worker is gone: receive what it had sent, then close and call `closed`.
   * @param {() => void} closed
   */
  end(closed) {
    setTimeout(() => {
      this.#port.close();
      closed();
    }, LINGER);
  }

  /** Close the port at once. */
  cut() {
    this.#port.close();
  }

  /** @param {unknown} data */
  #receive(data) {
    if (data instanceof ArrayBuffer) {
      this.#receiveFrame(data);
    } else {
      const { op, writer, reader, records, bytes } = /** @type {any} */ (data ?? {});
      if (op === "credit" && [writer, reader, records, bytes].every(isCount)) {
        this.#listener.credit(writer, reader, records, bytes);
      } else if (op === "alive" && [writer, reader].every(isCount)) {
        this.#listener.hear(writer, reader);
      } else {
        this.#listener.refuse("frame");
      }
    }
    this.#listener.wake();
  }

  /** @param {ArrayBuffer} frame */
  #receiveFrame(frame) {
    const size = frame.byteLength;
    if (size > this.#listener.largest) {
      this.#listener.refuse("large");
    } else if (size > BATCH_SIZE && !isRecord(frame)) {
      // Millions of small records would occupy the receiver for seconds.
      this.#listener.refuse("frame");
    } else {
      // One time stamp for the frame: reading the clock costs as much as all other work for a message.
      const received = now();
      const { deliver } = this.#listener;
      const rest = readRecords(frame, (head, message) => deliver(head, message, received));
      if (rest > 0) this.#listener.refuse("frame");
    }
  }
}

/** @param {unknown} value */
function isCount(value) {
  return Number.isSafeInteger(value) && Number(value) >= 0;
}
