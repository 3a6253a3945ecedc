// @ts-check
// The transforms between frames, over time, as tf2 buffers them.

import { say } from "../../ui/words.js";
import { IDENTITY, compose, inverse, isFinitePose, normalized } from "./pose.js";
import { Track } from "./track.js";

/** @import { Pose } from "./pose.js" */

/**
 * @typedef {{pose?: Pose, time: number, fault: string, early: boolean}} Found `time` (s) is when that was, infinite if
 *   nothing moves; without a pose, `fault` says why there is none, and it is `early` if a later transform may give it
 */

// Bounds for what nodes publish.
const MOST_FRAMES = 10_000;
const LONGEST_CHAIN = 1_000;

/** @type {Found} */
const SAME = { pose: IDENTITY, time: Infinity, fault: "", early: false };
// What stands for the latest pose of a frame that is in another tree, or below a loop.
/** @type {Found} */
const APART = { time: NaN, fault: "", early: true };
/** @type {Found} */
const LOOP = { time: NaN, fault: "", early: false };

export class Transforms {
  /** Those that move in the order in which they were heard of last. @type {Map<string, Track>} */
  #tracks = new Map();
  /** Increases with every change of which frames there are. */
  version = 0;
  /** The frames of a version. @type {{version: number, names: Set<string>}} */
  #frames = { version: -1, names: new Set() };
  /** The latest poses in one frame, so far as they were asked for since the last transform. @type {{target: string, poses?: Map<string, Found>}} */
  #latest = { target: "" };

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
    const sample = { time: seconds(header.stamp), parent, pose };
    let track = this.#tracks.get(child);
    if (!track) {
      if (this.#tracks.size >= MOST_FRAMES && !this.#forget()) return;
      track = new Track(sample, fixed);
      this.version++;
    } else {
      if (track.parent !== parent || track.fixed !== fixed) this.version++;
      track.add(sample, fixed);
      if (!fixed) this.#tracks.delete(child);
    }
    this.#tracks.set(child, track);
    this.#latest = { target: "" };
  }

  /** Forget the frame that moves and was not heard of for the longest time; return whether there is one. */
  #forget() {
    for (const [frame, { fixed }] of this.#tracks) {
      if (fixed) continue;
      this.#tracks.delete(frame);
      this.version++;
      return true;
    }
    return false;
  }

  get #names() {
    if (this.#frames.version !== this.version) {
      const names = [...this.#tracks].flatMap(([frame, { parent }]) => [frame, parent]);
      this.#frames = { version: this.version, names: new Set(names.sort()) };
    }
    return this.#frames.names;
  }

  /** The frames, in alphabetical order. */
  frames() {
    return [...this.#names];
  }

  /** @param {string} frame @returns {string | undefined} its parent; undefined for a root */
  parentOf(frame) {
    return this.#tracks.get(frame)?.parent;
  }

  /** @param {string} frame @returns {{fixed: boolean, time: number} | undefined} how it came; undefined for a root */
  about(frame) {
    const track = this.#tracks.get(frame);
    return track && { fixed: track.fixed, time: track.time };
  }

  /** Forget everything. */
  clear() {
    this.#tracks.clear();
    this.#latest = { target: "" };
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
    if (target === source) return SAME;
    return time ? this.#at(target, source, time) : this.#newest(target, source);
  }

  /** @param {string} target @param {string} source @param {number} time @returns {Found} */
  #at(target, source, time) {
    const up = this.#chain(source);
    const down = this.#chain(target);
    if (!up || !down) return loop(up ? target : source);
    const places = new Map(down.map((frame, index) => [frame, index]));
    const meet = up.findIndex((frame) => places.has(frame));
    if (meet < 0) return this.#unconnected(target, source);
    const there = this.#along(up.slice(0, meet), time);
    const back = this.#along(down.slice(0, places.get(/** @type {string} */ (up[meet]))), time);
    if (!there.pose || !back.pose) return there.pose ? back : there;
    return { pose: compose(inverse(back.pose), there.pose), time, fault: "", early: false };
  }

  /** Return a frame and all above it; undefined if these form a loop. @param {string} frame */
  #chain(frame) {
    const chain = new Set([frame]);
    for (let next = this.parentOf(frame); next !== undefined; next = this.parentOf(next)) {
      if (chain.size > LONGEST_CHAIN || chain.has(next)) return undefined;
      chain.add(next);
    }
    return [...chain];
  }

  /** Compose the poses of frames, each in the next one. @param {string[]} frames @param {number} time @returns {Found} */
  #along(frames, time) {
    let pose = IDENTITY;
    for (const frame of frames) {
      const step = /** @type {Track} */ (this.#tracks.get(frame)).at(time);
      if (!step.pose) return lacking(frame, time, step.early);
      pose = compose(step.pose, pose);
    }
    return { pose, time, fault: "", early: false };
  }

  /**
   * Return the latest pose. Each frame continues from the pose of the one above it, so that all poses of a long chain
   * cost one step each.
   * @param {string} target @param {string} source @returns {Found}
   */
  #newest(target, source) {
    if (this.#latest.target !== target) this.#latest = { target, poses: this.#above(target) };
    const { poses } = this.#latest;
    if (!poses) return loop(target);
    /** @type {string[]} */
    const below = [];
    let frame = source;
    while (!poses.has(frame)) {
      below.push(frame);
      const parent = this.parentOf(frame);
      if (parent === undefined) poses.set(frame, APART);
      else if (below.length > LONGEST_CHAIN) poses.set(frame, LOOP);
      else frame = parent;
    }
    let found = /** @type {Found} */ (poses.get(frame));
    for (const each of below.reverse()) {
      found = poses.get(each) ?? this.#step(target, found, each, each);
      poses.set(each, found);
    }
    if (found === APART) return this.#unconnected(target, source);
    return found === LOOP ? loop(source) : found;
  }

  /** Return the latest poses of a frame and of all above it; undefined if these form a loop. @param {string} target */
  #above(target) {
    let frame = target;
    let found = SAME;
    const poses = new Map([[frame, found]]);
    for (let parent = this.parentOf(frame); parent !== undefined; parent = this.parentOf(frame)) {
      if (poses.size > LONGEST_CHAIN || poses.has(parent)) return undefined;
      found = this.#step(target, found, frame, parent);
      poses.set(parent, found);
      frame = parent;
    }
    return poses;
  }

  /**
   * Return the latest pose of a frame next to one whose latest pose is known.
   * @param {string} target @param {Found} near @param {string} frame the lower of the two, whose transform leads from
   *   one to the other @param {string} to the frame that is asked for
   * @returns {Found}
   */
  #step(target, near, frame, to) {
    if (near === APART || near === LOOP) return near;
    const track = /** @type {Track} */ (this.#tracks.get(frame));
    const time = Math.min(near.time, track.end);
    if (time < near.time && near.time < Infinity) return this.#at(target, to, time);
    if (!near.pose) return near;
    const step = track.at(time);
    if (!step.pose) return lacking(frame, time, step.early);
    const pose = compose(near.pose, to === frame ? step.pose : inverse(step.pose));
    return { pose, time, fault: "", early: false };
  }

  /** @param {string} target @param {string} source @returns {Found} */
  #unconnected(target, source) {
    const unknown = [source, target].find((frame) => !this.#names.has(frame));
    const fault = unknown !== undefined ? say("no frame '{}' in /tf", unknown)
      : say("frame '{}' is not connected to '{}'", source, target);
    return { time: NaN, fault, early: true };
  }
}

/** @param {string} frame @returns {Found} */
function loop(frame) {
  return { time: NaN, fault: say("the frames above '{}' form a loop", frame), early: false };
}

/** @param {string} frame @param {number} time @param {boolean} early @returns {Found} */
function lacking(frame, time, early) {
  const fault = early ? say("no transform of '{}' that is new enough", frame)
    : say("no transform of '{}' that is old enough", frame);
  return { time, fault, early };
}

/** Return a time of ROS in seconds. @param {{sec: number, nanosec: number}} stamp */
export function seconds({ sec, nanosec }) {
  return sec + nanosec / 1e9;
}

/** The name of a frame as tf2 has it. @param {string} name */
export function plain(name) {
  return name.startsWith("/") ? name.slice(1) : name;
}
