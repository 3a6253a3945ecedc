// @ts-check
// Many poses, such as the particles of a localization: an arrow each.

import { Color, Quaternion, Vector3 } from "../../../vendor/three.js";
import { say } from "../../../ui/words.js";
import { isFinitePose, poseOf } from "../../tf/pose.js";
import { Arrows, dispose } from "../shapes.js";

/** @import { Kind } from "../shown.js" */

const MOST = 20_000;

/** @type {Kind} */
export const kind = {
  title: say("Poses"),
  types: ["geometry_msgs/msg/PoseArray"],
  defaults: { topic: "/particle_cloud", color: "#ff1900", alpha: 1, length: 0.3 },

  create({ root }, options) {
    const arrows = new Arrows(root);
    /** @type {import("../../tf/pose.js").Pose[]} */
    let poses = [];
    const draw = () => {
      const { length } = options;
      const color = new Color(options.color);
      const size = { shaft: length * 0.07, head: length * 0.2, length: length * 0.25 };
      arrows.begin();
      for (const { position, rotation } of poses) {
        const along = new Vector3(length, 0, 0).applyQuaternion(new Quaternion(...rotation));
        arrows.add(new Vector3(...position), along, size, color);
      }
      arrows.end(options.alpha);
    };
    return {
      frameOf: ({ header }) => header,
      receive(message) {
        poses = message.poses.slice(0, MOST).map(poseOf).filter(isFinitePose);
        draw();
      },
      set: draw,
      clear() {
        poses = [];
        draw();
      },
      close: () => dispose(root),
    };
  },
};
