// @ts-check
// What a 3D view shows: the transforms between frames, the fixed frame, and the displays.

import { Group } from "../../vendor/three.js";
import { RosClock } from "../../messages/rosClock.js";
import { place } from "../../place.js";
import { Transforms } from "../tf/transforms.js";
import { infoOf } from "./displays/camera.js";
import { KINDS } from "./kinds.js";
import { Shown } from "./shown.js";

/** @import { Ros } from "../../protocol.js" */
/** @import { Stage } from "./stage.js" */

const TF = "tf2_msgs/msg/TFMessage";
// The frames that are fixed in most systems, the best first.
const USUAL = ["map", "world", "odom"];
// The folder of packages in the page, for URLs that programs make of the folder of a package.
const SHARE = /^(?:file:\/\/)?\/ros\/share\//;
// A page without a list of displays shows this many topics at most.
const MOST_SHOWN = 30;

export class World {
  transforms = new Transforms();
  clock;
  /** @type {Shown[]} */
  displays = [];
  fixed = "";
  /** Called after changes of frames, of displays or of their status. */
  changed = () => {};
  ros;
  resource;
  /** What displays leave behind in the fixed frame. */
  floor = new Group();
  #stage;
  #automatic;
  /** Whether the fixed frame was chosen by the author or by the visitor. */
  #chosen = false;
  #heard = "";
  /** When the last transform came (ms). */
  #moved = 0;
  /** Whether somebody publishes transforms. */
  #moving = false;
  #version = -1;
  #seen = false;
  #news = false;
  /** @type {(() => void)[]} */
  #ends = [];

  /**
   * @param {Ros} ros @param {Stage} stage
   * @param {{frame?: string | null, displays?: Record<string, any>[] | null, resources?: Record<string, string>}} options
   */
  constructor(ros, stage, { frame, displays, resources = {} }) {
    this.ros = ros;
    this.clock = new RosClock(ros);
    this.#stage = stage;
    this.#automatic = !displays;
    this.resource = (/** @type {string} */ url) => {
      const address = resources[url.replace(SHARE, "package://")] ?? url;
      // A page that is a single file contains them.
      return address.startsWith("sitegen:") ? place(address) : address;
    };
    this.fixed = frame ?? "";
    this.#chosen = Boolean(frame);
    stage.scene.add(this.floor);
    stage.prepare = (now) => this.#update(now);
    for (const { kind, enabled = true, ...own } of displays ?? [{ kind: "grid" }, { kind: "tf" }]) {
      this.add(kind, own, enabled);
    }
  }

  /** The drawing, for displays that the visitor's pointer moves. */
  get stage() {
    return this.#stage;
  }

  /** Add a display. @param {string} kind @param {Record<string, any>} options @param {boolean} [enabled] */
  add(kind, options, enabled = true) {
    const known = KINDS[kind];
    if (!known) return undefined;
    const shown = new Shown(kind, known, this, options, enabled);
    this.displays.push(shown);
    // The grid and the axes are everywhere, so they say nothing of where to look.
    (known.types.length ? this.#stage.content : this.#stage.scene).add(shown.root);
    if (this.#seen) shown.begin();
    this.told();
    this.redraw();
    return shown;
  }

  /** @param {Shown} shown */
  remove(shown) {
    shown.close();
    this.displays.splice(this.displays.indexOf(shown), 1);
    this.told();
    this.redraw();
  }

  /** Take part in the graph until the returned function is called. @returns {() => void} */
  begin() {
    this.#seen = true;
    let listens = false;
    const look = () => {
      // A bag may bring the type later.
      if (!listens && this.ros.types[TF]) this.#listen();
      listens ||= Boolean(this.ros.types[TF]);
      if (this.#automatic) this.#offer();
      for (const shown of this.displays) shown.begin();
      const tf = this.ros.graph.topics().find(({ name }) => name === "/tf");
      this.#moving = Boolean(tf?.publishers.length);
      this.redraw();
    };
    this.ros.graph.addEventListener("change", look);
    this.#ends.push(() => this.ros.graph.removeEventListener("change", look), this.clock.follow(this.ros.graph));
    look();
    return () => {
      this.#seen = false;
      for (const end of this.#ends.splice(0)) end();
      for (const shown of this.displays) shown.end();
      this.#stage.rest();
    };
  }

  #listen() {
    const take = (/** @type {boolean} */ fixed) => (/** @type {any} */ { transforms }) => {
      for (const one of transforms) this.transforms.add(one, fixed);
      this.#moved = performance.now();
      this.redraw();
    };
    this.#ends.push(
      this.ros.subscribe("/tf", TF, take(false), { depth: 1000 }),
      this.ros.subscribe("/tf_static", TF, take(true), { depth: 1000, reliable: true, transientLocal: true }),
    );
  }

  /** Draw everything in the colours of the page, which may have changed. */
  recolour() {
    if (!this.#stage.recolour()) return;
    for (const shown of this.displays) shown.set({});
  }

  /** Choose the fixed frame. @param {string} frame */
  choose(frame) {
    this.#chosen = true;
    this.fixed = frame;
    this.told();
    this.redraw();
  }

  /** Note that a message has come in a frame, which is the fixed one if there are no transforms. @param {string} [frame] */
  heard(frame) {
    if (frame && !this.#heard) {
      this.#heard = frame.replace(/^\//, "");
      this.#version = -1;
    }
  }

  /**
   * Return the time by which transforms grow old (ms): it stands still while all their publishers are silent, as those
   * of a bag that is paused.
   * @param {number} now
   */
  transformTime(now) {
    return this.#moving ? Math.min(now, this.#moved) : now;
  }

  /** Show the first message of a display. */
  appeared() {
    if (!this.#stage.chosen) this.#stage.fit();
  }

  /** Tell, with the next frame, that there is something new to say. */
  told() {
    this.#news = true;
    this.redraw();
  }

  redraw() {
    if (this.#seen) this.#stage.redraw();
  }

  close() {
    for (const shown of this.displays) shown.close();
    this.displays = [];
  }

  /** @param {number} now */
  #update(now) {
    if (this.transforms.version !== this.#version) {
      this.#version = this.transforms.version;
      if (!this.#chosen) this.fixed = this.#best();
      this.#news = true;
    }
    for (const shown of this.displays) shown.update(now);
    if (!this.#news) return;
    this.#news = false;
    this.changed();
  }

  /** The frame to show everything in: a usual one, or the root of the largest tree. */
  #best() {
    const frames = this.transforms.frames();
    const usual = USUAL.find((frame) => frames.includes(frame));
    if (usual) return usual;
    /** @type {Map<string, number>} */
    const sizes = new Map();
    for (const frame of frames) {
      let root = frame;
      for (let steps = 0, next = frame; next !== undefined && steps < 100; steps++) {
        root = next;
        next = /** @type {string} */ (this.transforms.parentOf(next));
      }
      sizes.set(root, (sizes.get(root) ?? 0) + 1);
    }
    const [largest] = [...sizes].sort(([, one], [, two]) => two - one);
    return largest?.[0] ?? this.#heard;
  }

  /** Show each topic that a display can show. */
  #offer() {
    for (const { name, types, publishers } of this.ros.graph.topics()) {
      const kind = Object.keys(KINDS).find((each) => KINDS[each]?.types.some((type) => types.includes(type)));
      if (!kind || !publishers.length || this.displays.length >= MOST_SHOWN) continue;
      // A text can be anything; a description of a robot has a usual name.
      if (kind === "robot" && !name.endsWith("/robot_description")) continue;
      // An image without a camera has no place in the scene.
      if (kind === "camera" && !this.ros.graph.topics().some((each) => each.name === infoOf(name) && each.publishers.length)) continue;
      if (!this.displays.some(({ topic }) => topic === name)) this.add(kind, { topic: name });
    }
  }
}
