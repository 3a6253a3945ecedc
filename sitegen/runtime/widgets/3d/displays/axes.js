// @ts-check
// The axes of one frame: x red, y green, z blue.

import { Quaternion, Vector3 } from "../../../vendor/three.js";
import { say } from "../../../ui/words.js";
import { Axes } from "../shapes.js";

/** @import { Kind } from "../shown.js" */

/** @type {Kind} */
export const kind = {
  title: say("Axes"),
  types: [],
  defaults: { length: 1, radius: 0.1, frame: "", alpha: 1 },

  create({ root, world }, options) {
    const axes = new Axes(root);
    return {
      set({ length, radius, alpha }) {
        axes.begin();
        axes.add(new Vector3(), new Quaternion(), length, 2 * radius);
        axes.end(alpha);
      },
      frame: () => options.frame || world.fixed,
    };
  },
};
