// @ts-check
// Hold requests and responses back until other workers know of the endpoints that were announced before. The page
// tells them of endpoints, but messages take a direct port and could overtake that news.

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

  /** Whether all announced endpoints are known to the others. */
  get known() {
    return !this.#news && this.#asked === 0;
  }

  /** Call `send` when they are. @param {() => void} send */
  hold(send) {
    this.#held.push(send);
    if (!this.#news) return;
    this.#news = false;
    this.#asked += 1;
    this.#post({ op: "settle" });
  }

  /** The page has answered: the endpoints that were announced before the question are known. */
  settled() {
    this.#asked -= 1;
    if (this.#asked === 0) this.release();
  }

  /** Send everything that is held back, without waiting longer. */
  release() {
    for (const send of this.#held.splice(0)) send();
  }
}
