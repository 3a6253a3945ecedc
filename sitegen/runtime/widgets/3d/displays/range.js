// @ts-check
// What a range sensor sees: a cone along x, as long as the distance.

import { ConeGeometry, DoubleSide, Mesh, MeshBasicMaterial } from "../../../vendor/three.js";
import { say } from "../../../ui/words.js";
import { dispose } from "../shapes.js";

/** @import { Kind } from "../shown.js" */

/** @type {Kind} */
export const kind = {
  title: say("Range"),
  types: ["sensor_msgs/msg/Range"],
  defaults: { topic: "/range", color: "#ffffff", alpha: 0.5 },

  create({ root, tint }) {
    const material = new MeshBasicMaterial({ transparent: true, side: DoubleSide, depthWrite: false });
    const cone = new Mesh(new ConeGeometry(1, 1, 32, 1, true), material);
    // The tip of the geometry is at y = 0.5; that of the display at the sensor.
    cone.geometry.translate(0, -0.5, 0).rotateZ(Math.PI / 2);
    cone.visible = false;
    root.add(cone);
    return {
      frameOf: ({ header }) => header,
      receive({ range, field_of_view: angle, min_range: least, max_range: most }) {
        // Fixed-distance sensors say only whether there is something: -infinity or infinity.
        const length = least === most && range === -Infinity ? most : range;
        cone.visible = Number.isFinite(length) && length > 0 && length <= most;
        const radius = length * Math.tan(Math.min(angle, Math.PI * 0.95) / 2);
        if (cone.visible) cone.scale.set(length, radius, radius);
      },
      set({ color, alpha }) {
        material.color = tint(color);
        material.opacity = alpha;
      },
      clear() {
        cone.visible = false;
      },
      close: () => dispose(root),
    };
  },
};
