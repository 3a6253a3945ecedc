// @ts-check
// The transforms of one frame in its parent, over time.

import { between } from "./pose.js";

/** @import { Pose } from "./pose.js" */
/** @typedef {{time: number, parent: string, pose: Pose}} Sample the pose of a frame in its parent at a time (s) */

/** How long transforms are kept, in seconds; as in tf2. */
const KEPT = 10;
// A bound for what nodes publish.
const MOST_SAMPLES = 10_000;

export class Track {
  fixed;
  /** In the order of their times; a fixed frame has one. @type {Sample[]} */
  #samples;

  /** @param {Sample} sample @param {boolean} fixed */
  constructor(sample, fixed) {
    this.fixed = fixed;
    this.#samples = [sample];
  }

  get #newest() {
    return /** @type {Sample} */ (this.#samples.at(-1));
  }

  get parent() {
    return this.#newest.parent;
  }

  /** The time of the newest transform (s). */
  get time() {
    return this.#newest.time;
  }

  /** The last time at which the pose is known (s). */
  get end() {
    return this.fixed ? Infinity : this.time;
  }

  /** @param {Sample} sample @param {boolean} fixed */
  add(sample, fixed) {
    if (fixed || this.fixed) {
      this.#samples = [sample];
      this.fixed = fixed;
      return;
    }
    const samples = this.#samples;
    // A clock that was set back starts again.
    if (sample.time < this.time - KEPT) samples.length = 0;
    let place = samples.length;
    while (place > 0 && /** @type {Sample} */ (samples[place - 1]).time > sample.time) place--;
    const same = samples[place - 1]?.time === sample.time;
    samples.splice(same ? place - 1 : place, same ? 1 : 0, sample);
    const oldest = this.time - KEPT;
    let old = Math.max(0, samples.length - MOST_SAMPLES);
    while (/** @type {Sample} */ (samples[old]).time < oldest) old++;
    // Removed in portions, because each removal moves all others.
    if (old > 64 || samples.length > MOST_SAMPLES) samples.splice(0, old);
  }

  /** @param {number} time @returns {{pose?: Pose, early: boolean}} `early` if a later transform may give it */
  at(time) {
    const samples = this.#samples;
    const newest = this.#newest;
    if (this.fixed || time === newest.time) return { pose: newest.pose, early: false };
    if (time > newest.time) return { early: true };
    let low = 0;
    let high = samples.length - 1;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (/** @type {Sample} */ (samples[middle]).time < time) low = middle + 1;
      else high = middle;
    }
    const after = /** @type {Sample} */ (samples[low]);
    if (after.time === time) return { pose: after.pose, early: false };
    const before = samples[low - 1];
    if (!before) return { early: false };
    if (before.parent !== after.parent) return { pose: before.pose, early: false };
    const part = (time - before.time) / (after.time - before.time);
    return { pose: between(before.pose, after.pose, part), early: false };
  }
}
