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

  /** Whether others know of all that was announced. */
  get known() {
    return !this.#news && this.#asked === 0;
  }

  /** Send something when they do. @param {() => void} send */
  hold(send) {
    this.#held.push(send);
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
