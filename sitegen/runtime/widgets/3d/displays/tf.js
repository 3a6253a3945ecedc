// @ts-check
// All frames: their axes, their names, and lines to their parents.

import { Color, Group, Quaternion, Vector3 } from "../../../vendor/three.js";
import { say } from "../../../ui/words.js";
import { createLabel } from "../label.js";
import { Lines } from "../lines.js";
import { Axes, dispose } from "../shapes.js";

/** @import { Context, Kind } from "../shown.js" */

// More names would cover each other, and each costs time.
const MOST_NAMES = 150;
const GREY = new Color(0x9aa3b8);
// The share of the view's height that a name takes.
const NAME = 0.035;
// The part of the timeout after which frames are grey, as in RViz.
const PALE = 1 / 3;

/** @typedef {{position: InstanceType<typeof Vector3>, rotation: InstanceType<typeof Quaternion>, pale: boolean}} Place */

/** @type {Kind} */
export const kind = {
  title: say("Frames"),
  types: [],
  defaults: { names: true, axes: true, arrows: true, scale: 1, alpha: 1, timeout: 15 },

  create(context, options) {
    const frames = new Frames(context, options);
    return { update: (now) => frames.update(now), close: () => frames.close() };
  },
};

class Frames {
  #context;
  #options;
  #axes;
  #lines;
  #names = new Group();
  /** The names that are drawn. */
  #named = "";
  /** By frame: the time of its transforms (s), and since when that is (ms). @type {Map<string, {time: number, since: number}>} */
  #heard = new Map();
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #timer;

  /** @param {Context} context @param {Record<string, any>} options */
  constructor(context, options) {
    this.#context = context;
    this.#options = options;
    this.#axes = new Axes(context.root);
    this.#lines = new Lines(context.root);
    context.root.add(this.#names);
  }

  /** @param {number} now (ms) */
  update(now) {
    const { transforms } = this.#context.world;
    const { axes, arrows, names, scale, alpha } = this.#options;
    const places = this.#placesAt(now);
    this.#axes.begin();
    for (const { position, rotation, pale } of axes ? places.values() : []) {
      this.#axes.add(position, rotation, 0.2 * scale, 0.02 * scale, pale ? GREY : undefined);
    }
    this.#axes.end(alpha);
    const ends = [...places].flatMap(([frame, { position }]) => {
      const parent = places.get(transforms.parentOf(frame) ?? "");
      return parent ? [...position, ...parent.position] : [];
    });
    this.#lines.show(new Float32Array(arrows ? ends : []), { color: GREY, opacity: alpha });
    this.#name(names ? [...places].slice(0, MOST_NAMES) : []);
  }

  close() {
    clearTimeout(this.#timer);
    dispose(this.#context.root);
  }

  /** Return where the frames are, without those that were heard of too long ago. @param {number} time (ms) */
  #placesAt(time) {
    const { world, redraw } = this.#context;
    const { transforms, fixed } = world;
    const now = world.transformTime(time);
    const timeout = this.#options.timeout > 0 ? this.#options.timeout * 1000 : Infinity;
    /** @type {Map<string, Place>} */
    const places = new Map();
    const former = this.#heard;
    this.#heard = new Map();
    let next = Infinity;
    for (const frame of transforms.frames()) {
      const found = transforms.lookup(fixed, frame);
      if (!found.pose) continue;
      const before = former.get(frame);
      const heard = before?.time === found.time ? before : { time: found.time, since: now };
      this.#heard.set(frame, heard);
      // Nothing is heard again of frames that do not move.
      const moves = found.time < Infinity;
      const age = moves ? now - heard.since : 0;
      if (age >= timeout) continue;
      const pale = age >= timeout * PALE;
      if (moves) next = Math.min(next, (pale ? timeout : timeout * PALE) - age);
      const { position, rotation } = found.pose;
      places.set(frame, { position: new Vector3(...position), rotation: new Quaternion(...rotation), pale });
    }
    clearTimeout(this.#timer);
    if (now === time && next < Infinity) this.#timer = setTimeout(redraw, next + 1);
    return places;
  }

  /** @param {[string, Place][]} places */
  #name(places) {
    const { scale } = this.#options;
    const { ink } = this.#context.world.stage;
    const named = JSON.stringify([places.map(([frame]) => frame), scale, ink]);
    if (named !== this.#named) {
      this.#named = named;
      dispose(this.#names);
      for (const [frame] of places) this.#names.add(createLabel(frame, NAME, { color: ink, fixed: true }));
    }
    places.forEach(([, { position }], index) => {
      this.#names.children[index]?.position.copy(position).add(new Vector3(0, 0, 0.06 * scale));
    });
  }
}
