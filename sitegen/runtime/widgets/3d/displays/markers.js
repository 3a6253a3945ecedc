// @ts-check
// Markers: what a program draws itself, added, changed and removed by name and number.

import { Group } from "../../../vendor/three.js";
import { say } from "../../../ui/words.js";
import { isFinitePose, poseOf } from "../../tf/pose.js";
import { seconds } from "../../tf/transforms.js";
import { drawMarker } from "../marker.js";
import { dispose } from "../shapes.js";
import { put } from "../shown.js";

/** @import { Context, Kind } from "../shown.js" */

const ARRAY = "visualization_msgs/msg/MarkerArray";
const [ADD, DELETE, DELETE_ALL] = [0, 2, 3];
const MOST = 20_000;

/**
 * @typedef {{place: any, namespace: string, frame: string, time: number, locked: boolean, placedIn: string, until: number}} Entry
 *   a marker: the group in its frame, that frame, and when it disappears (ms)
 */

/** @type {Kind} */
export const kind = {
  title: say("Markers"),
  types: ["visualization_msgs/msg/Marker", ARRAY],
  defaults: { topic: "/visualization_marker", hidden: "" },

  create(context, options) {
    const markers = new Markers(context);
    return {
      receive(message, type) {
        for (const marker of type === ARRAY ? message.markers : [message]) {
          context.world.heard(marker.header.frame_id);
          markers.take(marker);
        }
        context.world.appeared();
      },
      update: (now) => markers.update(now, String(options.hidden).split(",").map((each) => each.trim())),
      clear: () => markers.clear(),
      close: () => markers.clear(),
    };
  },
};

class Markers {
  #context;
  /** By namespace and number. @type {Map<string, Entry>} */
  #entries = new Map();
  /** What could not be drawn, by marker. @type {Map<string, string>} */
  #faults = new Map();
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #timer;

  /** @param {Context} context */
  constructor(context) {
    this.#context = context;
  }

  /** Throws an Error if the marker cannot be drawn. @param {any} marker */
  take(marker) {
    const key = `${marker.ns} ${marker.id}`;
    if (marker.action === DELETE_ALL) {
      for (const [each, { namespace }] of [...this.#entries]) {
        if (!marker.ns || namespace === marker.ns) this.#remove(each);
      }
      return;
    }
    this.#remove(key);
    if (marker.action === DELETE) return;
    if (marker.action !== ADD) throw new Error(say("marker {}: unknown action {}", key, marker.action));
    if (this.#entries.size >= MOST) throw new Error(say("more than {} markers", MOST));
    const pose = poseOf(marker.pose);
    if (!isFinitePose(pose)) throw new Error(say("marker {}: its pose is not finite", key));
    const inner = new Group();
    put(inner, pose);
    const outer = new Group();
    outer.add(inner);
    outer.visible = false;
    const { root, resource, redraw } = this.#context;
    drawMarker(inner, marker, { resource, redraw, say: (text) => this.#faults.set(key, text) });
    root.add(outer);
    const life = seconds(marker.lifetime) * 1000;
    this.#entries.set(key, {
      place: outer,
      namespace: marker.ns,
      frame: marker.header.frame_id,
      time: seconds(marker.header.stamp),
      locked: marker.frame_locked,
      placedIn: "",
      until: life > 0 ? performance.now() + life : Infinity,
    });
  }

  /** Place the markers, and remove those whose time is over. @param {number} now @param {string[]} hidden namespaces */
  update(now, hidden) {
    const { world, redraw } = this.#context;
    let next = Infinity;
    let placed = true;
    for (const [key, entry] of [...this.#entries]) {
      if (entry.until <= now) {
        this.#remove(key);
        continue;
      }
      next = Math.min(next, entry.until);
      if (entry.locked || entry.placedIn !== world.fixed) placed = this.#place(entry) && placed;
      entry.place.visible = entry.placedIn === world.fixed && !hidden.includes(entry.namespace || "(none)");
    }
    if (this.#entries.size && placed) this.#context.say([...new Set(this.#faults.values())].slice(0, 3).join("; "));
    clearTimeout(this.#timer);
    if (next < Infinity) this.#timer = setTimeout(redraw, Math.max(0, next - now) + 1);
  }

  clear() {
    clearTimeout(this.#timer);
    for (const key of [...this.#entries.keys()]) this.#remove(key);
  }

  /** @param {Entry} entry */
  #place(entry) {
    const { world, place } = this.#context;
    // A marker whose time has no transform is shown where its frame is now.
    const placed = place(entry.place, entry.frame, entry.locked ? 0 : entry.time)
      || (entry.time > 0 && place(entry.place, entry.frame));
    entry.placedIn = placed ? world.fixed : "";
    return placed;
  }

  /** @param {string} key */
  #remove(key) {
    const entry = this.#entries.get(key);
    if (!entry) return;
    this.#faults.delete(key);
    dispose(entry.place);
    entry.place.removeFromParent();
    this.#entries.delete(key);
  }
}
