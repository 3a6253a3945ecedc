// @ts-check
// What others may not know of yet. The page tells them of endpoints; requests and responses go to them by ports
// of their own, and would be there first.

/** @import { FromWorker } from "../protocol.js" */

export class Announced {
  #post;
  #news = false;
  #asked = 0;
  /** @type {(() => void)[]} */
  #held = [];

  /** @param {(message: FromWorker) => void} post to the page */
  constructor(post) {
    this.#post = post;
  }

  /** An endpoint was announced. */
  note() {
    this.#news = true;
  }

  /**
   * Send a message when others know of all that was announced: at once, if they do.
   * @param {Uint8Array} message @param {(message: Uint8Array) => void} send
   */
  before(message, send) {
    if (!this.#news && this.#asked === 0) {
      send(message);
      return;
    }
    // The program goes on, and may use the memory of its message again.
    const copy = message.slice();
    this.#held.push(() => send(copy));
    if (!this.#news) return;
    this.#news = false;
    this.#asked += 1;
    this.#post({ op: "settle" });
  }

  /** The page has told of all that it was told before it was asked. */
  settled() {
    this.#asked -= 1;
    if (this.#asked === 0) this.release();
  }

  /** Send what is held back, whoever knows of what. */
  release() {
    for (const send of this.#held.splice(0)) send();
  }
}
