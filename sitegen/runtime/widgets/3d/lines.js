// @ts-check
// Line segments, thin or with a width in metres.

import {
  BufferAttribute, BufferGeometry, Color, LineBasicMaterial, LineMaterial, LineSegments, LineSegments2,
  LineSegmentsGeometry,
} from "../../vendor/three.js";

export class Lines {
  #root;
  #object = /** @type {any} */ (undefined);

  /** @param {any} root the group that shows them */
  constructor(root) {
    this.#root = root;
  }

  /**
   * Show other segments.
   * @param {Float32Array} points x, y and z of both ends of each segment, in metres
   * @param {{color?: any, colors?: Float32Array, width?: number, opacity?: number}} style one colour, or r, g and b
   *   (linear, 0 to 1) of both ends of each segment; the width in metres, or 0 for one pixel
   */
  show(points, { color = new Color(0xffffff), colors, width = 0, opacity = 1 }) {
    this.clear();
    if (!points.length) return;
    const look = {
      color: colors ? 0xffffff : color, vertexColors: Boolean(colors), opacity, transparent: opacity < 1,
    };
    if (width > 0) {
      const geometry = new LineSegmentsGeometry();
      geometry.setPositions(points);
      if (colors) geometry.setColors(colors);
      this.#object = new LineSegments2(geometry, new LineMaterial({ ...look, worldUnits: true, linewidth: width }));
    } else {
      const geometry = new BufferGeometry();
      geometry.setAttribute("position", new BufferAttribute(points, 3));
      if (colors) geometry.setAttribute("color", new BufferAttribute(colors, 3));
      this.#object = new LineSegments(geometry, new LineBasicMaterial(look));
    }
    this.#object.frustumCulled = false;
    this.#root.add(this.#object);
  }

  clear() {
    if (!this.#object) return;
    this.#object.removeFromParent();
    this.#object.geometry.dispose();
    this.#object.material.dispose();
    this.#object = undefined;
  }
}

/**
 * Return the segments of a line through points.
 * @param {number[][]} points @param {boolean} [closed]
 */
export function segments(points, closed = false) {
  const count = points.length < 2 ? 0 : points.length - (closed ? 0 : 1);
  const flat = new Float32Array(count * 6);
  for (let index = 0; index < count; index++) {
    flat.set(/** @type {number[]} */ (points[index]), index * 6);
    flat.set(/** @type {number[]} */ (points[(index + 1) % points.length]), index * 6 + 3);
  }
  return flat;
}

/** Return whether all numbers are finite: what is drawn with others would not be seen. @param {Iterable<number>} numbers */
export function finite(numbers) {
  for (const number of numbers) if (!Number.isFinite(number)) return false;
  return true;
}
