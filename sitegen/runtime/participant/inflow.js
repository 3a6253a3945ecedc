// @ts-check
// What has arrived at an endpoint from one sender, and the credits that the sender has got for it.

import { WINDOW } from "../budgets.js";
import { now } from "../protocol.js";

// Give credits when half of a window is used, or after this time (ms), so that a sender follows the pace of a slow
// receiver.
const PAUSE = 50;

export class Inflow {
  /** What was taken since the last credits. */
  #records = 0;
  #bytes = 0;
  #credited = 0;
  /** What arrived and has no credits yet. */
  #openRecords = 0;
  #openBytes = 0;

  /**
   * A message has arrived. Return false if the sender had no room for it: one that keeps to its credits never has
   * more in transit than a window, and the last message may be larger.
   * @param {number} size in bytes
   */
  arrive(size) {
    if (this.#openRecords >= WINDOW.records || this.#openBytes >= WINDOW.bytes) return false;
    this.#openRecords += 1;
    this.#openBytes += size;
    return true;
  }

  /**
   * A message has left the queue. Call `credit` with the sender's gid if it is time to give credits.
   * @param {number} size in bytes @param {number} sender
   * @param {(sender: number, records: number, bytes: number) => void} credit
   */
  leave(size, sender, credit) {
    const records = this.#records += 1;
    const bytes = this.#bytes += size;
    const time = now();
    if (records < WINDOW.records / 2 && bytes < WINDOW.bytes / 2 && time - this.#credited < PAUSE) return;
    this.#credited = time;
    this.#records = 0;
    this.#bytes = 0;
    this.#openRecords -= records;
    this.#openBytes -= bytes;
    credit(sender, records, bytes);
  }
}
