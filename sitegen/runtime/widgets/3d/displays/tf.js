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

/** @type {Kind} */
export const kind = {
  title: say("Frames"),
  types: [],
  defaults: { names: true, axes: true, arrows: true, scale: 1, alpha: 1 },

  create({ root, world }, options) {
    const axes = new Axes(root);
    const lines = new Lines(root);
    const names = new Group();
    root.add(names);
    let drawn = "";

    return {
      update() {
        const { transforms, fixed } = world;
        const poses = new Map();
        for (const frame of transforms.frames()) {
          const { pose } = transforms.lookup(fixed, frame);
          if (!pose) continue;
          poses.set(frame, {
            position: new Vector3(...pose.position), rotation: new Quaternion(...pose.rotation),
          });
        }
        axes.begin();
        if (options.axes) {
          for (const { position, rotation } of poses.values()) {
            axes.add(position, rotation, 0.2 * options.scale, 0.02 * options.scale);
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
          const { position } = poses.get(frame);
          names.children[index]?.position.copy(position).add(new Vector3(0, 0, 0.06 * options.scale));
        });
      },
      close: () => dispose(root),
    };
  },
};
