// @ts-check
// What a worker knows of other workers' endpoints. The page reports them from the first query of the program on.

import { gidOf } from "../protocol.js";

/** @import { Endpoint, FromWorker, Neighbour } from "../protocol.js" */

export class Surroundings {
  #post;
  /** By gid. @type {Map<number, Neighbour>} */
  #neighbours = new Map();
  #asked = false;
  /** Whether the page has answered. */
  known = false;
  /** The number of changes of the graph, including those of this worker. */
  changes = 0;

  /** @param {(message: FromWorker) => void} post to the page */
  constructor(post) {
    this.#post = post;
  }

  /**
   * Return the endpoints of all other workers, or undefined while the page has not answered.
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
      const gid = gidOf(peer, endpoint.id);
      this.#neighbours.set(gid, { gid, endpoint });
    }
    for (const { peer, id } of gone) this.#neighbours.delete(gidOf(peer, id));
  }
}
