// @ts-check
// Markers: what a program draws itself, added, changed and removed by name and number.

import { Group } from "../../../vendor/three.js";
import { say } from "../../../ui/words.js";
import { isFinitePose, poseOf } from "../../tf/pose.js";
import { seconds } from "../../tf/transforms.js";
import { drawMarker } from "../marker.js";
import { dispose } from "../shapes.js";
import { put } from "../shown.js";

/** @import { Kind } from "../shown.js" */

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
    const { root, world, place, redraw } = context;
    /** @type {Map<string, Entry>} */
    const entries = new Map();
    /** What could not be drawn, by marker. @type {Map<string, string>} */
    const faults = new Map();
    /** @type {ReturnType<typeof setTimeout> | undefined} */
    let timer;

    const remove = (/** @type {string} */ key) => {
      const entry = entries.get(key);
      if (!entry) return;
      faults.delete(key);
      dispose(entry.place);
      entry.place.removeFromParent();
      entries.delete(key);
    };
    const clear = () => {
      for (const key of [...entries.keys()]) remove(key);
    };
    const take = (/** @type {any} */ marker) => {
      const key = `${marker.ns} ${marker.id}`;
      if (marker.action === DELETE_ALL) {
        if (!marker.ns) clear();
        else for (const [each, { namespace }] of [...entries]) if (namespace === marker.ns) remove(each);
        return;
      }
      remove(key);
      if (marker.action === DELETE) return;
      if (marker.action !== ADD) throw new Error(say("marker {}: unknown action {}", key, marker.action));
      if (entries.size >= MOST) throw new Error(say("more than {} markers", MOST));
      const pose = poseOf(marker.pose);
      if (!isFinitePose(pose)) throw new Error(say("marker {}: its pose is not finite", key));
      const inner = new Group();
      put(inner, pose);
      const outer = new Group();
      outer.add(inner);
      outer.visible = false;
      drawMarker(inner, marker, { resource: context.resource, redraw, say: (text) => faults.set(key, text) });
      root.add(outer);
      const life = seconds(marker.lifetime) * 1000;
      entries.set(key, {
        place: outer,
        namespace: marker.ns,
        frame: marker.header.frame_id,
        time: seconds(marker.header.stamp),
        locked: marker.frame_locked,
        placedIn: "",
        until: life > 0 ? performance.now() + life : Infinity,
      });
    };
    const hidden = (/** @type {string} */ namespace) =>
      String(options.hidden).split(",").map((each) => each.trim()).includes(namespace || "(none)");

    return {
      receive(message, type) {
        for (const marker of type === ARRAY ? message.markers : [message]) {
          world.heard(marker.header.frame_id);
          take(marker);
        }
        world.appeared();
      },
      update(now) {
        let next = Infinity;
        let said = false;
        for (const [key, entry] of [...entries]) {
          if (entry.until <= now) {
            remove(key);
            continue;
          }
          next = Math.min(next, entry.until);
          if (entry.locked || entry.placedIn !== world.fixed) {
            // A marker whose time has no transform is shown where its frame is now.
            const placed = place(entry.place, entry.frame, entry.locked ? 0 : entry.time)
              || (entry.time > 0 && place(entry.place, entry.frame));
            entry.placedIn = placed ? world.fixed : "";
            said ||= !placed;
          }
          entry.place.visible = entry.placedIn === world.fixed && !hidden(entry.namespace);
        }
        if (entries.size && !said) context.say([...new Set(faults.values())].slice(0, 3).join("; "));
        clearTimeout(timer);
        if (next < Infinity) timer = setTimeout(redraw, Math.max(0, next - now) + 1);
      },
      clear,
      close() {
        clearTimeout(timer);
        clear();
      },
    };
  },
};
