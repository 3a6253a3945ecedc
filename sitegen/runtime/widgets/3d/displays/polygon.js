// @ts-check
// A polygon, such as the outline of a robot.

import { Color } from "../../../vendor/three.js";
import { say } from "../../../ui/words.js";
import { Lines, finite, segments } from "../lines.js";

/** @import { Kind } from "../shown.js" */

/** @type {Kind} */
export const kind = {
  title: say("Polygon"),
  types: ["geometry_msgs/msg/PolygonStamped"],
  defaults: { topic: "/footprint", color: "#19ff00", alpha: 1, width: 0 },

  create({ root }, options) {
    const lines = new Lines(root);
    /** @type {number[]} */
    let corners = [];
    const draw = () => {
      const { color, alpha, width } = options;
      lines.show(segments(corners, true), { color: new Color(color), opacity: alpha, width });
    };
    return {
      frameOf: ({ header }) => header,
      receive({ polygon: { points } }) {
        corners = points.map((/** @type {any} */ { x, y, z }) => [x, y, z]).filter(finite).flat();
        draw();
      },
      set: draw,
      clear() {
        corners = [];
        lines.clear();
      },
      close: () => lines.clear(),
    };
  },
};
