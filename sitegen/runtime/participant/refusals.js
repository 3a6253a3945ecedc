// @ts-check
// What this worker refuses to take from others: it is counted, told to the page now and then, and has an end.

import { BUDGETS } from "../budgets.js";

/** @import { FromWorker, Refusal } from "../protocol.js" */

// Counts are told to the page at most this often (ms); the first of each kind is told at once.
const PAUSE = 500;

export class Refusals {
  #post;
  #cut;
  /** What is not told yet, by worker. @type {Map<number, Map<Refusal, number>>} */
  #news = new Map();
  /** All of it, by worker. @type {Map<number, {total: number, kinds: Set<Refusal>}>} */
  #known = new Map();
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #timer;

  /**
   * @param {(message: FromWorker) => void} post to the page
   * @param {(peer: number) => void} cut called once for a worker that does not stop
   */
  constructor(post, cut) {
    this.#post = post;
    this.#cut = cut;
  }

  /** Something was refused. @param {number} peer the worker that sent it @param {Refusal} what */
  add(peer, what) {
    const known = this.#known.get(peer) ?? { total: 0, kinds: new Set() };
    this.#known.set(peer, known);
    known.total += 1;
    if (!known.kinds.has(what)) {
      known.kinds.add(what);
      this.#post({ op: "complain", peer, what, count: 1 });
    } else {
      const news = this.#news.get(peer) ?? new Map();
      this.#news.set(peer, news);
      news.set(what, (news.get(what) ?? 0) + 1);
      this.#timer ??= setTimeout(() => this.#tell(), PAUSE);
    }
    if (known.total === BUDGETS.refused) this.#cut(peer);
  }

  /** How much was refused of a worker. @param {number} peer */
  of(peer) {
    return this.#known.get(peer)?.total ?? 0;
  }

  #tell() {
    this.#timer = undefined;
    for (const [peer, news] of this.#news) {
      for (const [what, count] of news) this.#post({ op: "complain", peer, what, count });
    }
    this.#news.clear();
  }
}
