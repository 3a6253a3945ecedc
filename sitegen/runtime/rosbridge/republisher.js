// @ts-check
// Transforms for TF clients, which ask tf2_web_republisher for them.

import { stamp } from "../messages/time.js";
import { Tf } from "../client/tf.js";
import { Mistake } from "./mistake.js";
import { MOST_NAMES } from "./limits.js";
import { STATUS } from "../client/actionServer.js";

/** @import { PageNode } from "../protocol.js" */
/** @import { Surroundings } from "../client/surroundings.js" */
/** @import { Transform } from "../client/tf.js" */
/** @import { Told } from "./actions.js" */

/** Subscriptions of a client at a time; roslib has one for each TF client. */
const MOST = 50;
const [SLOWEST, FASTEST] = [0.1, 100];

export class Republisher {
  #raw;
  #surroundings;
  /** @type {Tf | undefined} */
  #tf;
  /** @type {Set<ReturnType<typeof setInterval>>} */
  #timers = new Set();

  /** @param {PageNode} raw @param {Surroundings} surroundings */
  constructor(raw, surroundings) {
    this.#raw = raw;
    this.#surroundings = surroundings;
  }

  /**
   * Serve a goal of the action TFSubscription until the function that it returns is called.
   * @param {any} args @param {Told} told
   */
  start(args, told) {
    const { source_frames: sources = [], target_frame: target, angular_thres: angle = 0, trans_thres: way = 0 } = args ?? {};
    const { rate = 10 } = args ?? {};
    const names = Array.isArray(sources) && sources.length <= MOST_NAMES &&
      sources.every((one) => typeof one === "string");
    const numbers = [angle, way, rate].every((one) => typeof one === "number" && Number.isFinite(one));
    if (!names || typeof target !== "string" || !numbers) {
      throw new Mistake("a TF subscription needs source_frames, target_frame, angular_thres, trans_thres and rate");
    }
    if (this.#timers.size >= MOST) throw new Mistake("too many TF subscriptions");
    const tf = (this.#tf ??= new Tf(this.#raw, this.#surroundings));
    /** @type {Map<string, Transform>} */
    const sent = new Map();
    const look = () => {
      const transforms = [];
      for (const source of sources) {
        const now = tf.latest(target, source);
        const before = sent.get(source);
        if (!now || (before && distance(before, now) < way && turn(before, now) < angle) ||
          (before && JSON.stringify(before) === JSON.stringify(now))) continue;
        sent.set(source, now);
        transforms.push({ header: { stamp: stamp(), frame_id: target }, child_frame_id: source, transform: now });
      }
      if (transforms.length) told.feedback({ transforms });
    };
    const timer = setInterval(look, 1000 / Math.min(FASTEST, Math.max(SLOWEST, rate)));
    this.#timers.add(timer);
    told.state(STATUS.executing);
    return () => {
      if (!this.#timers.delete(timer)) return;
      clearInterval(timer);
      // The end that was asked for: roslib reports all others as errors.
      told.done(STATUS.succeeded, {}, true);
    };
  }

  close() {
    this.#timers.forEach(clearInterval);
    this.#timers.clear();
  }
}

/** In metres. @param {Transform} a @param {Transform} b */
function distance({ translation: a }, { translation: b }) {
  return Math.hypot(a.x - b.x, a.y - b.y, a.z - b.z);
}

/** In radians. @param {Transform} a @param {Transform} b */
function turn({ rotation: a }, { rotation: b }) {
  return 2 * Math.acos(Math.min(1, Math.abs(a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w)));
}
