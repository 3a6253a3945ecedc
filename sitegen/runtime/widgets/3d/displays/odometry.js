// @ts-check
// Where odometry says that a robot is and was: arrows at its last poses.

import { Color, Quaternion, Vector3 } from "../../../vendor/three.js";
import { say } from "../../../ui/words.js";
import { isFinitePose, poseOf } from "../../tf/pose.js";
import { Arrows, dispose } from "../shapes.js";

/** @import { Kind } from "../shown.js" */

// `keep: 0` keeps all, as in RViz, up to this many.
const MOST = 10_000;

/** @type {Kind} */
export const kind = {
  title: say("Odometry"),
  types: ["nav_msgs/msg/Odometry"],
  defaults: {
    topic: "/odom", keep: 100, color: "#ff1900", alpha: 1, length: 0.4, distance: 0.1, angle: 0.1,
  },

  create({ root, say: tell }, options) {
    const arrows = new Arrows(root);
    /** @type {{position: any, along: any}[]} */
    let trail = [];
    const draw = () => {
      trail = trail.slice(-Math.max(1, Math.min(MOST, options.keep > 0 ? Math.round(options.keep) : MOST)));
      const { length } = options;
      const size = { shaft: length * 0.08, head: length * 0.2, length: length * 0.3 };
      arrows.begin();
      for (const { position, along } of trail) {
        arrows.add(position, along.clone().multiplyScalar(length), size, new Color(options.color));
      }
      arrows.end(options.alpha);
    };
    return {
      frameOf: ({ header }) => header,
      receive({ pose: { pose } }) {
        const found = poseOf(pose);
        if (!isFinitePose(found)) return;
        const position = new Vector3(...found.position);
        const along = new Vector3(1, 0, 0).applyQuaternion(new Quaternion(...found.rotation));
        const last = trail.at(-1);
        const still = last && last.position.distanceTo(position) < options.distance
          && last.along.angleTo(along) < options.angle;
        if (!still) {
          trail.push({ position, along });
          draw();
        }
        if (trail.length === MOST && options.keep !== MOST) tell(say("only the last {} arrows are shown", MOST));
      },
      set: draw,
      clear() {
        trail = [];
        draw();
      },
      close: () => dispose(root),
    };
  },
};
