// @ts-check
// A pose, as an arrow or as axes; the uncertainty of its position on the floor as an ellipse.

import { Color, Group, Quaternion, Vector3 } from "../../../vendor/three.js";
import { say } from "../../../ui/words.js";
import { isFinitePose, poseOf } from "../../tf/pose.js";
import { Lines, segments } from "../lines.js";
import { Arrows, Axes, dispose } from "../shapes.js";
import { put } from "../shown.js";

/** @import { Kind } from "../shown.js" */

const WITH_COVARIANCE = "geometry_msgs/msg/PoseWithCovarianceStamped";
const POINTS = 48;

/** @type {Kind} */
export const kind = {
  title: say("Pose"),
  types: ["geometry_msgs/msg/PoseStamped", WITH_COVARIANCE],
  defaults: { topic: "/goal_pose", shape: "arrow", color: "#ff1900", alpha: 1, length: 1, covariance: true },
  choices: { shape: ["arrow", "axes"] },

  create({ root }, options) {
    const place = new Group();
    const ellipse = new Group();
    root.add(place, ellipse);
    const arrows = new Arrows(place);
    const axes = new Axes(place);
    const line = new Lines(ellipse);
    const draw = () => {
      const { length, shape, color, alpha } = options;
      arrows.begin();
      axes.begin();
      const size = { shaft: length * 0.08, head: length * 0.18, length: length * 0.25 };
      if (shape === "axes") axes.add(new Vector3(), new Quaternion(), length, length * 0.1);
      else arrows.add(new Vector3(), new Vector3(length, 0, 0), size, new Color(color));
      arrows.end(alpha);
      axes.end(alpha);
      ellipse.visible = options.covariance;
    };
    place.visible = false;
    return {
      frameOf: ({ header }) => header,
      receive(message, type) {
        const sure = type !== WITH_COVARIANCE;
        const pose = poseOf(sure ? message.pose : message.pose.pose);
        if (!isFinitePose(pose)) throw new Error(say("the pose is not finite"));
        put(place, pose);
        place.visible = true;
        draw();
        ellipse.position.copy(place.position);
        line.show(sure ? new Float32Array() : ellipseOf(message.pose.covariance), { color: new Color(0xcc33cc) });
      },
      set: draw,
      clear() {
        place.visible = false;
        line.clear();
      },
      close: () => dispose(root),
    };
  },
};

/** Return the ellipse of one standard deviation in x and y. @param {Float64Array} covariance */
function ellipseOf(covariance) {
  const [a = 0, b = 0, d = 0] = [covariance[0], covariance[1], covariance[7]];
  const middle = (a + d) / 2;
  const spread = Math.hypot((a - d) / 2, b);
  const long = Math.sqrt(Math.max(0, middle + spread));
  const short = Math.sqrt(Math.max(0, middle - spread));
  const turn = Math.atan2(2 * b, a - d) / 2;
  if (!Number.isFinite(long + short + turn) || long === 0) return new Float32Array();
  const points = Array.from({ length: POINTS }).flatMap((_, index) => {
    const angle = (index / POINTS) * 2 * Math.PI;
    const x = long * Math.cos(angle);
    const y = short * Math.sin(angle);
    return [x * Math.cos(turn) - y * Math.sin(turn), x * Math.sin(turn) + y * Math.cos(turn), 0];
  });
  return segments(points, true);
}
