// @ts-check
// A point cloud, with any layout of its fields.

import { say } from "../../../ui/words.js";
import { pointsOf } from "../cloud.js";
import { readCloud } from "../cloudFields.js";

/** @import { Kind } from "../shown.js" */

/** @type {Kind} */
export const kind = {
  title: say("Point cloud"),
  types: ["sensor_msgs/msg/PointCloud2"],
  defaults: {
    topic: "/points", size: 0.02, color_by: "auto", color: "#ffffff", alpha: 1, decay: 0, min: 0, max: 0,
  },
  choices: { color_by: ["auto", "color", "rgb", "intensity", "x", "y", "z"] },

  create(context, options) {
    const points = pointsOf(context, options);
    return {
      ...points,
      frameOf: ({ header }) => header,
      receive(message) {
        const { positions, rgb, intensity } = readCloud(message);
        points.show(positions, { rgb, intensity });
      },
    };
  },
};
