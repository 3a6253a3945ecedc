// @ts-check
// Markers: what a program draws itself, added, changed and removed by name and number.

import { Group } from "../../../vendor/three.js";
import { say } from "../../../ui/words.js";
import { isFinitePose, poseOf } from "../../tf/pose.js";
import { seconds } from "../../tf/transforms.js";
import { MOST_POINTS, drawMarker } from "../marker.js";
import { dispose } from "../shapes.js";
import { put } from "../shown.js";

/** @import { Context, Kind } from "../shown.js" */

const ARRAY = "visualization_msgs/msg/MarkerArray";
const [ADD, DELETE, DELETE_ALL] = [0, 2, 3];
const MOST = 20_000;
// So many faults are told.
const MOST_FAULTS = 3;

/**
 * @typedef {{place: any, namespace: string, frame: string, time: number, locked: boolean, placedIn: string,
 *   until: number, points: number, fault: string}} Entry a marker: the group in its frame, that frame, when it disappears
 *   (ms), how many points it has, and why it cannot be drawn
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
  /** Of all markers. */
  #points = 0;
  /** Why there are not all markers. */
  #limit = "";
  /** Whether the camera has shown them. */
  #appeared = false;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #timer;

  /** @param {Context} context */
  constructor(context) {
    this.#context = context;
  }

  /** @param {any} marker */
  take(marker) {
    const key = `${marker.ns} ${marker.id}`;
    if (marker.action === DELETE_ALL) {
      for (const [each, { namespace }] of [...this.#entries]) {
        if (!marker.ns || namespace === marker.ns) this.#remove(each);
      }
    } else if (marker.action === DELETE) {
      this.#remove(key);
    } else {
      this.#remove(key);
      this.#add(key, marker);
    }
  }

  /** @param {string} key @param {any} marker */
  #add(key, marker) {
    const points = marker.points.length;
    if (this.#entries.size >= MOST) this.#limit = say("more than {} markers", MOST);
    else if (this.#points + points > MOST_POINTS) this.#limit = say("the markers have more than {} points", MOST_POINTS);
    else this.#limit = "";
    if (this.#limit) return;
    const life = seconds(marker.lifetime) * 1000;
    const place = new Group();
    place.visible = false;
    /** @type {Entry} */
    const entry = {
      place,
      namespace: marker.ns,
      frame: marker.header.frame_id,
      time: seconds(marker.header.stamp),
      locked: marker.frame_locked,
      placedIn: "",
      until: life > 0 ? performance.now() + life : Infinity,
      points,
      fault: "",
    };
    const fail = (/** @type {string} */ reason) => {
      entry.fault = say("marker {}: {}", key, reason);
    };
    try {
      if (marker.action !== ADD) throw new Error(say("unknown action {}", marker.action));
      const pose = poseOf(marker.pose);
      if (!isFinitePose(pose)) throw new Error(say("its pose is not finite"));
      const inner = new Group();
      put(inner, pose);
      place.add(inner);
      const { resource, redraw } = this.#context;
      drawMarker(inner, marker, { resource, redraw, say: fail });
    } catch (error) {
      fail(error instanceof Error ? error.message : String(error));
    }
    this.#context.root.add(place);
    this.#points += points;
    this.#entries.set(key, entry);
  }

  /** Place the markers, and remove those whose time is over. @param {number} now @param {string[]} hidden namespaces */
  update(now, hidden) {
    const { world, redraw } = this.#context;
    const faults = new Set(this.#limit ? [this.#limit] : []);
    let next = Infinity;
    let placed = true;
    let seen = false;
    for (const [key, entry] of [...this.#entries]) {
      if (entry.until <= now) {
        this.#remove(key);
        continue;
      }
      next = Math.min(next, entry.until);
      if (entry.locked || entry.placedIn !== world.fixed) placed = this.#place(entry) && placed;
      entry.place.visible = entry.placedIn === world.fixed && !hidden.includes(entry.namespace || "(none)");
      seen ||= entry.place.visible;
      if (entry.fault && faults.size < MOST_FAULTS) faults.add(entry.fault);
    }
    if (this.#entries.size && placed) this.#context.say([...faults].join("; "));
    if (seen && !this.#appeared) {
      this.#appeared = true;
      world.appeared();
    }
    clearTimeout(this.#timer);
    if (next < Infinity) this.#timer = setTimeout(redraw, Math.max(0, next - now) + 1);
  }

  clear() {
    clearTimeout(this.#timer);
    for (const key of [...this.#entries.keys()]) this.#remove(key);
    this.#limit = "";
    this.#appeared = false;
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
    this.#points -= entry.points;
    dispose(entry.place);
    entry.place.removeFromParent();
    this.#entries.delete(key);
  }
}
