// @ts-check
// The points of a laser scanner.

import { say } from "../../../ui/words.js";
import { pointsOf } from "../cloud.js";

/** @import { Kind } from "../shown.js" */

/** @type {Kind} */
export const kind = {
  title: say("Laser scan"),
  types: ["sensor_msgs/msg/LaserScan"],
  defaults: {
    topic: "/scan", size: 0.03, color_by: "color", color: "#ff4b4b", alpha: 1, decay: 0, min: 0, max: 0,
  },
  choices: { color_by: ["color", "intensity", "x", "y", "z"] },

  create(context, options) {
    const points = pointsOf(context, options);
    return {
      ...points,
      frameOf: ({ header }) => header,
      receive({ angle_min: start, angle_increment: step, range_min: least, range_max: most, ranges, intensities }) {
        const positions = new Float32Array(ranges.length * 3);
        const strengths = new Float32Array(ranges.length);
        let count = 0;
        for (let index = 0; index < ranges.length; index++) {
          const range = ranges[index];
          // Comparisons with NaN are false. A scanner without a limit says that nothing is there by infinity.
          if (!(range >= least && range <= most) || range === Infinity) continue;
          const angle = start + index * step;
          positions[count * 3] = range * Math.cos(angle);
          positions[count * 3 + 1] = range * Math.sin(angle);
          strengths[count] = intensities[index] ?? 0;
          count++;
        }
        points.show(positions.subarray(0, count * 3), { intensity: strengths.subarray(0, count) });
      },
    };
  },
};
