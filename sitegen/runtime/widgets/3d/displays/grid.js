// @ts-check
// The floor of the scene: a grid that fades towards its edge, with the shadows of what stands on it.

import { Color, Mesh, PlaneGeometry, ShadowMaterial } from "../../../vendor/three.js";
import { say } from "../../../ui/words.js";
import { isLight } from "../color.js";
import { Lines } from "../lines.js";

/** @import { Kind } from "../shown.js" */

const MOST = 1000;
// A line of the floor has this many parts at most, so that it can fade along its length.
const PARTS = 20;
// Where fading begins, as a part of the way from the middle to the edge.
const CLEAR = 0.3;
// How dark shadows are, on a light and on a dark ground.
const SHADE = 0.22;
const DARK_SHADE = 0.45;

/** @type {Kind} */
export const kind = {
  title: say("Grid"),
  types: [],
  defaults: { cells: 10, size: 1, color: "#a0a0a4", alpha: 0.5, plane: "XY", frame: "", width: 0 },
  choices: { plane: ["XY", "XZ", "YZ"] },

  create({ root, world }, options) {
    const lines = new Lines(root);
    const shadows = new Mesh(new PlaneGeometry(), new ShadowMaterial({ depthWrite: false }));
    shadows.receiveShadow = true;
    // Above a map, which is at the same height, and below what one sees through.
    shadows.renderOrder = -1;
    root.add(shadows);
    return {
      set({ cells: wanted, size, color, alpha, plane, width }) {
        const cells = Math.max(1, Math.min(MOST, Math.round(wanted)));
        const half = (cells * size) / 2;
        // Wide lines have no opacity of their own at each end, and somebody has chosen their width to see them.
        const points = width ? gridPoints(cells, 1) : gridPoints(cells, Math.min(cells, PARTS));
        const order = plane === "XZ" ? [0, 2, 1] : plane === "YZ" ? [2, 0, 1] : [0, 1, 2];
        const flat = points.flatMap(([x, y]) => order.map((axis) => half * ([x, y, 0][axis] ?? 0)));
        const { r, g, b } = new Color(color);
        const look = width ? { color: new Color(color), width } : {
          colors: new Float32Array(points.flatMap(([x, y]) => [r, g, b, fade(Math.hypot(x, y))])),
        };
        lines.show(new Float32Array(flat), { ...look, opacity: alpha });
        shadows.visible = plane === "XY";
        shadows.scale.set(2 * half, 2 * half, 1);
        // The ink is light where the ground is dark.
        shadows.material.opacity = isLight(world.stage.ink) ? DARK_SHADE : SHADE;
      },
      frame: () => options.frame || world.fixed,
    };
  },
};

/**
 * Return both ends of each part of each line, from -1 to 1 in both directions.
 * @param {number} cells @param {number} parts of each line
 */
function gridPoints(cells, parts) {
  /** @type {[number, number][]} */
  const points = [];
  for (let line = 0; line <= cells; line++) {
    const at = (2 * line) / cells - 1;
    for (let part = 0; part < parts; part++) {
      const [from, to] = [(2 * part) / parts - 1, (2 * (part + 1)) / parts - 1];
      points.push([from, at], [to, at], [at, from], [at, to]);
    }
  }
  return points;
}

/** Return the opacity of a point of the floor: it has no edge. @param {number} away from the middle; 1 is the edge */
function fade(away) {
  const part = Math.min(Math.max((away - CLEAR) / (1 - CLEAR), 0), 1);
  return 1 - part * part * (3 - 2 * part);
}
