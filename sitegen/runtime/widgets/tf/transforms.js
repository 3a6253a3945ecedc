// @ts-check
// The transforms between frames, over time, as tf2 buffers them.

import { say } from "../../ui/words.js";
import { IDENTITY, between, compose, inverse, isFinitePose, normalized } from "./pose.js";

/** @import { Pose } from "./pose.js" */

/**
 * @typedef {{time: number, parent: string, pose: Pose}} Sample the pose of a frame in its parent at a time (s)
 * @typedef {{fixed: boolean, samples: Sample[]}} Track the samples of a frame in order; a fixed frame has one
 * @typedef {{pose?: Pose, fault: string, early: boolean}} Found without a pose, `fault` says why there is none; it is
 *   `early` if a later transform may give it
 */

/** How long transforms are kept, in seconds; as in tf2. */
const KEPT = 10;
// Bounds for what nodes publish.
const MOST_SAMPLES = 10_000;
const MOST_FRAMES = 10_000;
const LONGEST_CHAIN = 1_000;

export class Transforms {
  /** @type {Map<string, Track>} */
  #tracks = new Map();
  /** Increases with every change of which frames there are. */
  version = 0;

  /**
   * Take a geometry_msgs/msg/TransformStamped from /tf, or from /tf_static if `fixed`. Transforms that are not numbers,
   * and those of a frame in itself, are ignored.
   * @param {any} stamped @param {boolean} fixed
   */
  add({ header, child_frame_id: childId, transform: { translation: t, rotation: r } }, fixed) {
    const child = plain(childId);
    const parent = plain(header.frame_id);
    const pose = normalized({ position: [t.x, t.y, t.z], rotation: [r.x, r.y, r.z, r.w] });
    if (!isFinitePose(pose) || !child || !parent || child === parent) return;
    let track = this.#tracks.get(child);
    if (!track) {
      if (this.#tracks.size >= MOST_FRAMES) return;
      track = { fixed, samples: [] };
      this.#tracks.set(child, track);
    }
    const before = track.samples.at(-1);
    if (before?.parent !== parent || track.fixed !== fixed) this.version++;
    const sample = { time: seconds(header.stamp), parent, pose };
    if (fixed || track.fixed) {
      track.samples = [sample];
      track.fixed = fixed;
      return;
    }
    insert(track.samples, sample);
  }

  /** The frames, in alphabetical order. */
  frames() {
    const names = new Set(this.#tracks.keys());
    for (const { samples } of this.#tracks.values()) names.add(samples.at(-1)?.parent ?? "");
    return [...names].sort();
  }

  /** @param {string} frame @returns {string | undefined} its parent; undefined for a root */
  parentOf(frame) {
    return this.#tracks.get(frame)?.samples.at(-1)?.parent;
  }

  /** @param {string} frame @returns {{fixed: boolean, time: number} | undefined} how it came; undefined for a root */
  about(frame) {
    const track = this.#tracks.get(frame);
    return track && { fixed: track.fixed, time: track.samples.at(-1)?.time ?? 0 };
  }

  /** Forget everything. */
  clear() {
    this.#tracks.clear();
    this.version++;
  }

  /**
   * Return the pose of the frame `source` in the frame `target` at a time in seconds, interpolated. The time 0 is the
   * latest for which all transforms between the two are known.
   * @param {string} target @param {string} source @param {number} [time] @returns {Found}
   */
  lookup(target, source, time = 0) {
    target = plain(target);
    source = plain(source);
    if (target === source) return { pose: IDENTITY, fault: "", early: false };
    const up = this.#chain(source);
    const down = this.#chain(target);
    if (!up || !down) return { fault: say("the frames above '{}' form a loop", up ? target : source), early: false };
    const meet = up.find((frame) => down.includes(frame));
    if (meet === undefined) return this.#unconnected(target, source);
    const ups = up.slice(0, up.indexOf(meet));
    const downs = down.slice(0, down.indexOf(meet));
    const at = time || this.#latest([...ups, ...downs]);
    const there = this.#along(ups, at);
    const back = this.#along(downs, at);
    if (!there.pose || !back.pose) return there.pose ? back : there;
    return { pose: compose(inverse(back.pose), there.pose), fault: "", early: false };
  }

  /** Return a frame and all above it; undefined if these form a loop. @param {string} frame */
  #chain(frame) {
    const chain = [frame];
    for (let next = this.parentOf(frame); next !== undefined; next = this.parentOf(next)) {
      if (chain.length > LONGEST_CHAIN || chain.includes(next)) return undefined;
      chain.push(next);
    }
    return chain;
  }

  /** @param {string[]} frames @returns {number} the latest time for which all of these are known */
  #latest(frames) {
    let latest = Infinity;
    for (const frame of frames) {
      const track = this.#tracks.get(frame);
      if (track && !track.fixed) latest = Math.min(latest, track.samples.at(-1)?.time ?? 0);
    }
    return latest;
  }

  /** Compose the poses of frames, each in the next one. @param {string[]} frames @param {number} time @returns {Found} */
  #along(frames, time) {
    let pose = IDENTITY;
    for (const frame of frames) {
      const step = at(/** @type {Track} */ (this.#tracks.get(frame)), time);
      if (!step.pose) {
        const fault = step.early ? say("no transform of '{}' that is new enough", frame)
          : say("no transform of '{}' that is old enough", frame);
        return { fault, early: step.early };
      }
      pose = compose(step.pose, pose);
    }
    return { pose, fault: "", early: false };
  }

  /** @param {string} target @param {string} source @returns {Found} */
  #unconnected(target, source) {
    const known = new Set(this.frames());
    const unknown = [source, target].find((frame) => !known.has(frame));
    if (unknown !== undefined) return { fault: say("no frame '{}' in /tf", unknown), early: true };
    return { fault: say("frame '{}' is not connected to '{}'", source, target), early: true };
  }
}

/** Return a time of ROS in seconds. @param {{sec: number, nanosec: number}} stamp */
export function seconds({ sec, nanosec }) {
  return sec + nanosec / 1e9;
}

/** The name of a frame as tf2 has it. @param {string} name */
export function plain(name) {
  return name.startsWith("/") ? name.slice(1) : name;
}

/** Insert a sample by its time, and remove those that are too old. @param {Sample[]} samples @param {Sample} sample */
function insert(samples, sample) {
  const newest = samples.at(-1)?.time ?? -Infinity;
  // A clock that was set back starts again.
  if (sample.time < newest - KEPT) samples.length = 0;
  let place = samples.length;
  while (place > 0 && /** @type {Sample} */ (samples[place - 1]).time > sample.time) place--;
  const same = samples[place - 1]?.time === sample.time;
  samples.splice(same ? place - 1 : place, same ? 1 : 0, sample);
  const oldest = /** @type {Sample} */ (samples.at(-1)).time - KEPT;
  let old = Math.max(0, samples.length - MOST_SAMPLES);
  while (/** @type {Sample} */ (samples[old]).time < oldest) old++;
  // Removed in portions, because each removal moves all others.
  if (old > 64 || samples.length > MOST_SAMPLES) samples.splice(0, old);
}

/** @param {Track} track @param {number} time @returns {{pose?: Pose, early: boolean}} */
function at({ fixed, samples }, time) {
  const newest = /** @type {Sample} */ (samples.at(-1));
  if (fixed || time === newest.time) return { pose: newest.pose, early: false };
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
