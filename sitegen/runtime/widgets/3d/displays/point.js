// @ts-check
// A point, and those before it: a sphere each.

import { Color, InstancedMesh, Matrix4, MeshLambertMaterial, SphereGeometry } from "../../../vendor/three.js";
import { say } from "../../../ui/words.js";
import { finite } from "../lines.js";
import { dispose } from "../shapes.js";

/** @import { Kind } from "../shown.js" */

const MOST = 1000;

/** @type {Kind} */
export const kind = {
  title: say("Point"),
  types: ["geometry_msgs/msg/PointStamped"],
  defaults: { topic: "/clicked_point", radius: 0.2, keep: 1, color: "#cc29cc", alpha: 1 },

  create({ root }, options) {
    const spheres = new InstancedMesh(new SphereGeometry(1, 20, 12), new MeshLambertMaterial(), MOST);
    spheres.frustumCulled = false;
    root.add(spheres);
    /** @type {number[][]} */
    let points = [];
    const draw = () => {
      points = points.slice(-Math.min(MOST, Math.max(1, options.keep)));
      const { radius } = options;
      points.forEach(([x = 0, y = 0, z = 0], index) => {
        spheres.setMatrixAt(index, new Matrix4().makeScale(radius, radius, radius).setPosition(x, y, z));
      });
      spheres.count = points.length;
      spheres.instanceMatrix.needsUpdate = true;
      spheres.boundingSphere = null;
      spheres.boundingBox = null;
      const { material } = spheres;
      material.color = new Color(options.color);
      material.opacity = options.alpha;
      material.transparent = options.alpha < 1;
    };
    draw();
    return {
      frameOf: ({ header }) => header,
      receive({ point: { x, y, z } }) {
        if (finite([x, y, z])) points.push([x, y, z]);
        draw();
      },
      set: draw,
      clear() {
        points = [];
        draw();
      },
      close: () => dispose(root),
    };
  },
};
