// @ts-check
// The floor of the scene: a grid.

import { Color } from "../../../vendor/three.js";
import { say } from "../../../ui/words.js";
import { Lines } from "../lines.js";

/** @import { Kind } from "../shown.js" */

const MOST = 1000;

/** @type {Kind} */
export const kind = {
  title: say("Grid"),
  types: [],
  defaults: { cells: 10, size: 1, color: "#a0a0a4", alpha: 0.5, plane: "XY", frame: "", width: 0 },
  choices: { plane: ["XY", "XZ", "YZ"] },

  create({ root, world }, options) {
    const lines = new Lines(root);
    return {
      set({ cells: wanted, size, color, alpha, plane, width }) {
        const cells = Math.max(1, Math.min(MOST, Math.round(wanted)));
        const half = (cells * size) / 2;
        const points = [];
        for (let index = 0; index <= cells; index++) {
          const at = index * size - half;
          points.push([-half, at], [half, at], [at, -half], [at, half]);
        }
        const order = plane === "XZ" ? [0, 2, 1] : plane === "YZ" ? [2, 0, 1] : [0, 1, 2];
        const flat = points.flatMap(([x = 0, y = 0]) => order.map((axis) => [x, y, 0][axis] ?? 0));
        lines.show(new Float32Array(flat), { color: new Color(color), opacity: alpha, width });
      },
      frame: () => options.frame || world.fixed,
    };
  },
};
