// @ts-check
// A program at the other end of a connection: its queue of messages to send, and its socket while it has one.

import { ExpiringQueue } from "./expiringQueue.js";
import { timed } from "./message.js";

/**
 * A message that waits to be sent. `settle` tells whether it was.
 * @typedef {{text: string, settle: (sent: boolean) => void}} Outgoing
 */

// Bytes that a socket may hold because the other side does not read. The rest waits here, where it can expire.
const HELD = 2 ** 20;
// Sockets do not say when they have room again (ms).
const LOOK_AGAIN = 5;
// Invalid messages of a connection that are tolerated; then it is closed.
const INVALID = 100;

export class Peer {
  /** @type {ExpiringQueue<Outgoing>} */
  queue = new ExpiringQueue(({ settle }) => settle(false));
  /** @type {WebSocket | undefined} */
  socket;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #timer;
  /** What was logged about this connection. @type {Set<string>} */
  #noted = new Set();
  #invalid = 0;

  /** @param {string} name */
  constructor(name) {
    this.name = name;
  }

  get connected() {
    return this.socket?.readyState === 1;
  }

  /** Begin with a new connection. */
  opened() {
    this.#noted.clear();
    this.#invalid = 0;
    this.flush();
  }

  /** Send the messages that wait, if there is a connection, as many as the other side reads. */
  flush() {
    while (this.socket && this.connected && this.queue.length > 0) {
      if (this.socket.bufferedAmount > HELD) {
        this.#timer ??= setTimeout(() => {
          this.#timer = undefined;
          this.flush();
        }, LOOK_AGAIN);
        return;
      }
      const taken = this.queue.take();
      if (!taken) return;
      this.socket.send(timed(taken.item.text, taken.left));
      taken.item.settle(true);
    }
  }

  /** Discard what waits to be sent. */
  close() {
    clearTimeout(this.#timer);
    this.queue.clear();
  }

  /** Log something about this connection, the first time that it happens. @param {string} what @param {string} [details] */
  note(what, details = "") {
    if (this.#noted.has(what)) return;
    this.#noted.add(what);
    console.warn(`rowe: ${this.name}: ${what}${details}`);
  }

  /** Count an invalid message. @param {string} reason */
  refuse(reason) {
    this.note("sent an invalid message: ", reason);
    this.#invalid += 1;
    // 1008 is for servers only.
    if (this.#invalid >= INVALID) this.socket?.close(4008, "invalid messages");
  }
}
