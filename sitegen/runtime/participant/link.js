// @ts-check
// The port to one other worker. What comes from there is checked: it may be anybody's program.

import { now, readRecords } from "../protocol.js";
import { Outbox } from "./outbox.js";

/** @import { FromPeer, Head } from "../protocol.js" */

// What a worker sent before it ended is here by then (ms). Not all browsers tell when a port has no more.
const LINGER = 1000;

/**
 * @typedef {{
 *   deliver(head: Head, message: Uint8Array, received: number): void,
 *   credit(writer: number, reader: number, records: number, bytes: number): void,
 *   hear(writer: number, reader: number): void,
 *   wake(): void,
 *   complain(text: string): void,
 * }} Listener `writer` is the id in the worker that writes, `reader` that in the worker that reads
 */

export class Link {
  #port;
  #outbox;
  #listener;
  #complained = false;

  /** @param {MessagePort} port @param {Listener} listener */
  constructor(port, listener) {
    this.#port = port;
    this.#outbox = new Outbox(port);
    this.#listener = listener;
    port.onmessage = (event) => this.#receive(event.data);
    port.onmessageerror = () => this.#complain("a message that cannot be read");
  }

  /** Send a message as the outbox does. @param {Head} head @param {Uint8Array} message @param {boolean} own */
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
   * The other worker is gone: take what it had sent, then close and call `closed`.
   * @param {() => void} closed
   */
  end(closed) {
    setTimeout(() => {
      this.#port.close();
      closed();
    }, LINGER);
  }

  /** @param {unknown} data */
  #receive(data) {
    if (data instanceof ArrayBuffer) {
      // Those of one frame came together; asking for the time costs as much as all else done for one.
      const received = now();
      const { deliver } = this.#listener;
      const rest = readRecords(data, (head, message) => deliver(head, message, received));
      if (rest > 0) this.#complain(`a frame of ${data.byteLength} bytes of which ${rest} are not valid records`);
    } else {
      const { op, writer, reader, records, bytes } = /** @type {any} */ (data ?? {});
      if (op === "credit" && [writer, reader, records, bytes].every(isCount)) {
        this.#listener.credit(writer, reader, records, bytes);
      } else if (op === "alive" && [writer, reader].every(isCount)) {
        this.#listener.hear(writer, reader);
      } else {
        this.#complain("an invalid frame");
      }
    }
    this.#listener.wake();
  }

  /** Once: who sends one sends many. @param {string} what */
  #complain(what) {
    if (this.#complained) return;
    this.#complained = true;
    this.#listener.complain(`sent ${what} to other nodes; it was dropped`);
  }
}

/** @param {unknown} value */
function isCount(value) {
  return Number.isSafeInteger(value) && Number(value) >= 0;
}
