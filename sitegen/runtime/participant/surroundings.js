// @ts-check
// What a worker knows of everybody else in the graph: nothing until its program asks, then all that
// happens.

import { pageId } from "../protocol.js";

/** @import { Endpoint, FromWorker, Neighbour } from "../protocol.js" */

export class Surroundings {
  #post;
  /** By the name that it has in the page. @type {Map<number, Neighbour>} */
  #neighbours = new Map();
  #asked = false;
  /** Whether the page has told who is there. */
  known = false;
  /** How often something changed, here or elsewhere. */
  changes = 0;

  /** @param {(message: FromWorker) => void} post to the page */
  constructor(post) {
    this.#post = post;
  }

  /**
   * The endpoints of everybody else; undefined while the page has not answered.
   * The first call asks it, and from then on it tells of each change.
   * @returns {Iterable<Neighbour> | undefined}
   */
  look() {
    if (!this.#asked) this.#post({ op: "look" });
    this.#asked = true;
    return this.known ? this.#neighbours.values() : undefined;
  }

  /** @param {{peer: number, endpoint: Endpoint}[]} come @param {{peer: number, id: number}[]} gone */
  change(come, gone) {
    this.known = true;
    this.changes += 1;
    for (const { peer, endpoint } of come) {
      const name = pageId(peer, endpoint.id);
      this.#neighbours.set(name, { name, endpoint });
    }
    for (const { peer, id } of gone) this.#neighbours.delete(pageId(peer, id));
  }
}
