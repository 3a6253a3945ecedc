// @ts-check
// The port to another worker. What arrives is checked, because that worker may run any program.

import { now, readRecords } from "../protocol.js";
import { Outbox } from "./outbox.js";

/** @import { FromPeer, Head } from "../protocol.js" */

// Messages that a worker sent before it ended arrive within this time (ms). Not all browsers report a closed port.
const LINGER = 1000;

/**
 * @typedef {{
 *   deliver(head: Head, message: Uint8Array, received: number): void,
 *   credit(writer: number, reader: number, records: number, bytes: number): void,
 *   hear(writer: number, reader: number): void,
 *   wake(): void,
 *   complain(text: string): void,
 * }} Listener `writer` and `reader` are ids of endpoints in their own workers
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

  /** @param {unknown} data */
  #receive(data) {
    if (data instanceof ArrayBuffer) {
      // One time stamp for the frame: reading the clock costs as much as all other work for a message.
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

  /** Complain only once, because invalid frames come in numbers. @param {string} what */
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
