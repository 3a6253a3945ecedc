// @ts-check
// Line segments, thin or with a width in metres.

import {
  BufferAttribute, BufferGeometry, Color, LineBasicMaterial, LineMaterial, LineSegments, LineSegments2,
  LineSegmentsGeometry,
} from "../../vendor/three.js";

export class Lines {
  #root;
  #object = /** @type {any} */ (undefined);
  #wide = false;

  /** @param {any} root the group that shows them */
  constructor(root) {
    this.#root = root;
  }

  /**
   * Show other segments.
   * @param {Float32Array} points x, y and z of both ends of each segment, in metres
   * @param {{color?: any, colors?: Float32Array, width?: number, opacity?: number}} style one colour, or r, g and b
   *   (linear, 0 to 1) of both ends of each segment, of thin ones also alpha; the width in metres, or 0 for one pixel
   */
  show(points, { color = new Color(0xffffff), colors, width = 0, opacity = 1 }) {
    if (!points.length || (this.#object && this.#wide !== width > 0)) this.clear();
    if (!points.length) return;
    if (!this.#object) {
      this.#wide = width > 0;
      this.#object = this.#wide ? new LineSegments2(undefined, new LineMaterial({ worldUnits: true }))
        : new LineSegments(undefined, new LineBasicMaterial());
      this.#object.frustumCulled = false;
      this.#root.add(this.#object);
    }
    if (!this.#fill(points, colors)) {
      this.#object.geometry.dispose();
      this.#object.geometry = this.#wide ? wideGeometry(points, colors) : thinGeometry(points, colors);
    }
    // The material stays: a new one for each message would be compiled each time.
    const { material } = this.#object;
    if (material.vertexColors !== Boolean(colors)) material.needsUpdate = true;
    material.vertexColors = Boolean(colors);
    material.color.set(colors ? 0xffffff : color);
    material.opacity = opacity;
    material.transparent = opacity < 1 || partsOf(points, colors) === 4;
    if (this.#wide) material.linewidth = width;
  }

  /**
   * Put other numbers into the geometry that is there; return whether that has room for just these.
   * @param {Float32Array} points @param {Float32Array} [colors]
   */
  #fill(points, colors) {
    const [places, tints] = this.#wide ? ["instanceStart", "instanceColorStart"] : ["position", "color"];
    const { attributes } = this.#object.geometry;
    const [place, tint] = [places, tints].map((name) => attributes[name]?.data ?? attributes[name]);
    if (place?.array.length !== points.length || tint?.array.length !== colors?.length) return false;
    place.array.set(points);
    place.needsUpdate = true;
    if (colors) tint.array.set(colors);
    if (colors) tint.needsUpdate = true;
    // They are computed again when they are needed.
    this.#object.geometry.boundingBox = null;
    this.#object.geometry.boundingSphere = null;
    return true;
  }

  clear() {
    if (!this.#object) return;
    this.#object.removeFromParent();
    this.#object.geometry.dispose();
    this.#object.material.dispose();
    this.#object = undefined;
  }
}

/** @param {Float32Array} points @param {Float32Array | undefined} colors */
function wideGeometry(points, colors) {
  const geometry = new LineSegmentsGeometry();
  geometry.setPositions(points);
  if (colors) geometry.setColors(colors);
  return geometry;
}

/** @param {Float32Array} points @param {Float32Array | undefined} colors */
function thinGeometry(points, colors) {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(points, 3));
  if (colors) geometry.setAttribute("color", new BufferAttribute(colors, partsOf(points, colors)));
  return geometry;
}

/** Return how many numbers a colour has: 3, or 4 with alpha. @param {Float32Array} points @param {Float32Array} [colors] */
function partsOf(points, colors) {
  return colors ? (3 * colors.length) / points.length : 3;
}

/**
 * Return the segments of a line through points.
 * @param {ArrayLike<number>} points x, y and z of each @param {boolean} [closed]
 */
export function segments(points, closed = false) {
  const { length } = points;
  const ends = new Float32Array(length < 6 ? 0 : 2 * length - (closed ? 0 : 6));
  for (let at = 0; at < ends.length; at += 6) {
    for (let part = 0; part < 6; part++) ends[at + part] = /** @type {number} */ (points[(at / 2 + part) % length]);
  }
  return ends;
}

/** Return whether all numbers are finite: what is drawn with others would not be seen. @param {Iterable<number>} numbers */
export function finite(numbers) {
  for (const number of numbers) if (!Number.isFinite(number)) return false;
  return true;
}
