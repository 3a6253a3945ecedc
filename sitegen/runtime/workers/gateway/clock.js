// @ts-check
// Compare the clock of a gateway with that of the page.

import { now } from "../../protocol.js";

// The last answers that are compared, and the change that is told (ms).
const KEPT = 8;
const CHANGE = 100;

export class Clock {
  #tell;
  /** @type {{took: number, offset: number}[]} */
  #answers = [];
  /** @type {number | undefined} */
  #told;

  /** @param {(offset: number) => void} tell called with the time there minus the time here (ms) */
  constructor(tell) {
    this.#tell = tell;
  }

  /** @param {number} sent when it was asked @param {number} time what it answered */
  hear(sent, time) {
    const took = now() - sent;
    if (!(took >= 0) || !Number.isFinite(time)) return;
    this.#answers.push({ took, offset: time - (sent + took / 2) });
    if (this.#answers.length > KEPT) this.#answers.shift();
    // The fastest answer knows best: its way took the least time.
    const best = this.#answers.reduce((a, b) => (b.took < a.took ? b : a));
    if (this.#told !== undefined && Math.abs(best.offset - this.#told) < CHANGE) return;
    this.#told = best.offset;
    this.#tell(best.offset);
  }
}
