// @ts-check
// Transforms between frames, as scripts use them.

import { say } from "../ui/words.js";
import { Transforms, seconds } from "../widgets/tf/transforms.js";
import { Stream } from "./stream.js";

/** @import { PageNode } from "../protocol.js" */
/** @import { Pose } from "../widgets/tf/pose.js" */
/** @import { Surroundings } from "./surroundings.js" */
/**
 * @typedef {{translation: {x: number, y: number, z: number},
 *   rotation: {x: number, y: number, z: number, w: number}}} Transform as geometry_msgs/msg/Transform
 */

const TYPE = "tf2_msgs/msg/TFMessage";

/** Emits `change` after transforms have come. It listens to /tf from its first use on. */
export class Tf extends EventTarget {
  #raw;
  #surroundings;
  #transforms = new Transforms();
  #listening = false;

  /** @param {PageNode} raw @param {Surroundings} surroundings */
  constructor(raw, surroundings) {
    super();
    this.#raw = raw;
    this.#surroundings = surroundings;
  }

  /** The frames that were heard of, in alphabetical order. */
  frames() {
    this.#listen();
    return this.#transforms.frames();
  }

  /**
   * Return where the frame `source` is in the frame `target` now, undefined if that is not known.
   * @param {string} target @param {string} source @returns {Transform | undefined}
   */
  latest(target, source) {
    this.#listen();
    const { pose } = this.#transforms.lookup(target, source);
    return pose && transformOf(pose);
  }

  /**
   * Resolve with where the frame `source` is in the frame `target`, as soon as that is known.
   * @param {string} target @param {string} source
   * @param {{time?: number | {sec: number, nanosec: number}, timeout?: number, signal?: AbortSignal}} [options] `time` in
   *   s or as a message has it, interpolated, 0 for the latest; `timeout` in ms, 5000 by default
   * @returns {Promise<Transform>}
   */
  lookup(target, source, { time = 0, timeout = 5000, signal } = {}) {
    this.#listen();
    const { closed } = this.#surroundings;
    return new Promise((resolve, reject) => {
      const at = timeOf(time);
      let fault = "";
      const look = () => {
        const found = this.#transforms.lookup(target, source, at);
        fault = found.fault;
        if (found.pose) settle(() => resolve(transformOf(/** @type {Pose} */ (found.pose))));
      };
      const settle = (/** @type {() => void} */ done) => {
        clearTimeout(timer);
        this.removeEventListener("change", look);
        signal?.removeEventListener("abort", aborted);
        closed.removeEventListener("abort", left);
        done();
      };
      const timer = timeout === Infinity ? undefined : setTimeout(() => settle(() => reject(new Error(fault))), timeout);
      const aborted = () => settle(() => reject(signal?.reason));
      const left = () => settle(() => reject(closed.reason));
      this.addEventListener("change", look);
      signal?.addEventListener("abort", aborted);
      closed.addEventListener("abort", left);
      if (signal?.aborted) aborted();
      else if (closed.aborted) left();
      else look();
    });
  }

  /**
   * Iterate over where the frame `source` is in the frame `target`: the newest place after each change.
   * @param {string} target @param {string} source @param {{signal?: AbortSignal}} [options]
   */
  follow(target, source, { signal } = {}) {
    return new Stream((push) => {
      let before = "";
      const look = () => {
        const found = this.latest(target, source);
        const text = JSON.stringify(found);
        if (found && text !== before) push(found);
        before = text;
      };
      this.addEventListener("change", look);
      look();
      return () => this.removeEventListener("change", look);
    }, { most: 1, signal }, this.#surroundings.closed);
  }

  #listen() {
    if (this.#listening) return;
    this.#listening = true;
    const read = (/** @type {boolean} */ fixed) => (/** @type {any} */ { transforms }) => {
      for (const one of transforms) this.#transforms.add(one, fixed);
      this.dispatchEvent(new Event("change"));
    };
    if (!this.#raw.types[TYPE]) throw new Error(say("this page has no definition of {}", TYPE));
    this.#raw.subscribe("/tf", TYPE, read(false), { depth: 100 });
    this.#raw.subscribe("/tf_static", TYPE, read(true), { depth: 100, reliable: true, transientLocal: true });
  }
}

/** Return a time in s. @param {any} time in s, or as a message has it */
function timeOf(time) {
  if (Number.isFinite(time)) return time;
  if (Number.isFinite(time?.sec) && Number.isFinite(time.nanosec)) return seconds(time);
  const shown = typeof time === "object" ? String(time && "another object") : `the ${typeof time} ${String(time)}`;
  throw new TypeError(`'time' is a number of seconds or {sec, nanosec}, both numbers, not ${shown}`);
}

/** @param {Pose} pose @returns {Transform} */
function transformOf({ position: [px, py, pz], rotation: [x, y, z, w] }) {
  return { translation: { x: px, y: py, z: pz }, rotation: { x, y, z, w } };
}
