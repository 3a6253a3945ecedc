// @ts-check
// A path: a line through its poses.

import { Color } from "../../../vendor/three.js";
import { say } from "../../../ui/words.js";
import { Lines, finite, segments } from "../lines.js";

/** @import { Kind } from "../shown.js" */

/** @type {Kind} */
export const kind = {
  title: say("Path"),
  types: ["nav_msgs/msg/Path"],
  defaults: { topic: "/plan", color: "#19ff00", alpha: 1, width: 0.03 },

  create({ root }, options) {
    const lines = new Lines(root);
    /** @type {number[]} */
    let points = [];
    const draw = () => {
      lines.show(segments(points), { color: new Color(options.color), opacity: options.alpha, width: options.width });
    };
    return {
      frameOf: ({ header }) => header,
      receive({ poses }) {
        points = poses.map((/** @type {any} */ { pose: { position: { x, y, z } } }) => [x, y, z]).filter(finite).flat();
        draw();
      },
      set: draw,
      clear() {
        points = [];
        lines.clear();
      },
      close: () => lines.clear(),
    };
  },
};
