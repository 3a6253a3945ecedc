// @ts-check
// All frames: their axes, their names, and lines to their parents.

import { Color, Group, Quaternion, Vector3 } from "../../../vendor/three.js";
import { say } from "../../../ui/words.js";
import { createLabel } from "../label.js";
import { Lines } from "../lines.js";
import { Axes, dispose } from "../shapes.js";

/** @import { Kind } from "../shown.js" */

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

  create({ root, world, redraw }, options) {
    const axes = new Axes(root);
    const lines = new Lines(root);
    const names = new Group();
    root.add(names);
    let drawn = "";
    /** By frame: the time of its transforms (s), and since when that is (ms). @type {Map<string, {time: number, since: number}>} */
    let heard = new Map();
    /** @type {ReturnType<typeof setTimeout> | undefined} */
    let timer;

    return {
      update(time) {
        const { transforms, fixed } = world;
        const now = world.transformTime(time);
        const timeout = options.timeout > 0 ? options.timeout * 1000 : Infinity;
        /** @type {Map<string, Place>} */
        const poses = new Map();
        const former = heard;
        heard = new Map();
        let next = Infinity;
        for (const frame of transforms.frames()) {
          const found = transforms.lookup(fixed, frame);
          if (!found.pose) continue;
          const { pose } = found;
          const before = former.get(frame);
          const entry = before?.time === found.time ? before : { time: found.time, since: now };
          heard.set(frame, entry);
          // Nothing is heard again of frames that do not move.
          const age = found.time < Infinity ? now - entry.since : 0;
          if (age >= timeout) continue;
          const pale = age >= timeout * PALE;
          if (found.time < Infinity) next = Math.min(next, (pale ? timeout : timeout * PALE) - age);
          poses.set(frame, {
            position: new Vector3(...pose.position), rotation: new Quaternion(...pose.rotation), pale,
          });
        }
        clearTimeout(timer);
        if (now === time && next < Infinity) timer = setTimeout(redraw, next + 1);
        axes.begin();
        if (options.axes) {
          for (const { position, rotation, pale } of poses.values()) {
            axes.add(position, rotation, 0.2 * options.scale, 0.02 * options.scale, pale ? GREY : undefined);
          }
        }
        axes.end(options.alpha);
        const ends = [...poses].flatMap(([frame, { position }]) => {
          const parent = poses.get(transforms.parentOf(frame) ?? "");
          return parent ? [...position.toArray(), ...parent.position.toArray()] : [];
        });
        lines.show(new Float32Array(options.arrows ? ends : []), { color: GREY, opacity: options.alpha });
        const shown = options.names ? [...poses.keys()].slice(0, MOST_NAMES) : [];
        const list = JSON.stringify([shown, options.scale]);
        if (list !== drawn) {
          drawn = list;
          dispose(names);
          for (const frame of shown) names.add(createLabel(frame, NAME, { fixed: true }));
        }
        shown.forEach((frame, index) => {
          const { position } = /** @type {Place} */ (poses.get(frame));
          names.children[index]?.position.copy(position).add(new Vector3(0, 0, 0.06 * options.scale));
        });
      },
      close() {
        clearTimeout(timer);
        dispose(root);
      },
    };
  },
};
