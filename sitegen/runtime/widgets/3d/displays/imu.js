// @ts-check
// An inertial sensor: a box with its orientation, and an arrow for the acceleration.

import {
  BoxGeometry, Color, Group, Mesh, MeshLambertMaterial, Vector3,
} from "../../../vendor/three.js";
import { say } from "../../../ui/words.js";
import { isFinitePose, normalized } from "../../tf/pose.js";
import { finite } from "../lines.js";
import { Arrows, Axes, dispose } from "../shapes.js";
import { put } from "../shown.js";

/** @import { Kind } from "../shown.js" */

/** @type {Kind} */
export const kind = {
  title: say("IMU"),
  types: ["sensor_msgs/msg/Imu"],
  defaults: {
    topic: "/imu", box: true, axes: true, acceleration: true, size: 0.3, acceleration_scale: 0.05, color: "#ff0000", alpha: 1,
  },

  create({ root }, options) {
    const place = new Group();
    root.add(place);
    const box = new Mesh(new BoxGeometry(1, 1, 0.4), new MeshLambertMaterial());
    place.add(box);
    const axes = new Axes(place);
    const arrows = new Arrows(place);
    let pull = new Vector3();
    const draw = () => {
      const { size, alpha, acceleration_scale: scale } = options;
      box.visible = options.box;
      box.scale.setScalar(size);
      box.material.color = new Color(options.color);
      box.material.opacity = alpha;
      box.material.transparent = alpha < 1;
      axes.begin();
      if (options.axes) axes.add(new Vector3(), place.quaternion.clone().identity(), size * 1.5, size * 0.08);
      axes.end(alpha);
      arrows.begin();
      const arrow = { shaft: size * 0.1, head: size * 0.25, length: size * 0.3 };
      if (options.acceleration) arrows.add(new Vector3(), pull.clone().multiplyScalar(scale), arrow, new Color(0xffff00));
      arrows.end(alpha);
    };
    place.visible = false;
    return {
      frameOf: ({ header }) => header,
      receive({ orientation: { x, y, z, w }, orientation_covariance: known, linear_acceleration: a }) {
        // A covariance that begins with -1 means that the sensor has no orientation.
        const pose = normalized({ position: [0, 0, 0], rotation: known[0] === -1 ? [0, 0, 0, 1] : [x, y, z, w] });
        if (!isFinitePose(pose)) return;
        put(place, pose);
        pull = finite([a.x, a.y, a.z]) ? new Vector3(a.x, a.y, a.z) : new Vector3();
        place.visible = true;
        draw();
      },
      set: draw,
      clear() {
        place.visible = false;
      },
      close: () => dispose(root),
    };
  },
};
