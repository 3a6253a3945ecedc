// @ts-check
// A force and a torque: an arrow, and an arrow around the axis of the torque.

import { Color, Quaternion, Vector3 } from "../../../vendor/three.js";
import { say } from "../../../ui/words.js";
import { Lines, finite } from "../lines.js";
import { Arrows, dispose } from "../shapes.js";

/** @import { Kind } from "../shown.js" */

const STEPS = 32;

/** @type {Kind} */
export const kind = {
  title: say("Wrench"),
  types: ["geometry_msgs/msg/WrenchStamped"],
  defaults: {
    topic: "/wrench", force_color: "#cc3333", torque_color: "#cccc33", force_scale: 0.1, torque_scale: 0.1, width: 0.03,
    alpha: 1,
  },

  create({ root }, options) {
    const arrows = new Arrows(root);
    const circle = new Lines(root);
    let force = new Vector3();
    let torque = new Vector3();
    const draw = () => {
      const { force_scale: strength, torque_scale: turn, width, alpha } = options;
      const size = { shaft: width, head: width * 2, length: width * 3 };
      arrows.begin();
      arrows.add(new Vector3(), force.clone().multiplyScalar(strength), size, new Color(options.force_color));
      const axis = torque.clone().multiplyScalar(turn);
      const color = new Color(options.torque_color);
      arrows.add(new Vector3(), axis, size, color);
      circle.show(around(axis), { color, width: width / 2, opacity: alpha });
      arrows.end(alpha);
    };
    return {
      frameOf: ({ header }) => header,
      receive({ wrench: { force: f, torque: t } }) {
        if (!finite([f.x, f.y, f.z, t.x, t.y, t.z])) return;
        force = new Vector3(f.x, f.y, f.z);
        torque = new Vector3(t.x, t.y, t.z);
        draw();
      },
      set: draw,
      clear() {
        force = new Vector3();
        torque = new Vector3();
        draw();
      },
      close: () => dispose(root),
    };
  },
};

/** Return three quarters of a circle around an axis. @param {InstanceType<typeof Vector3>} axis */
function around(axis) {
  const length = axis.length();
  if (!length) return new Float32Array();
  const turn = new Quaternion().setFromUnitVectors(new Vector3(0, 0, 1), axis.clone().normalize());
  const points = Array.from({ length: STEPS + 1 }, (_, index) => {
    const angle = (index / STEPS) * 1.5 * Math.PI;
    return new Vector3(Math.cos(angle), Math.sin(angle), 0.5 / 0.3).multiplyScalar(length * 0.3).applyQuaternion(turn);
  });
  const ends = points.slice(1).flatMap((point, index) => [
    .../** @type {InstanceType<typeof Vector3>} */ (points[index]).toArray(), ...point.toArray()]);
  return new Float32Array(ends);
}
