// @ts-check
// Points with colours, and those of the last seconds as well: what laser scans and point clouds have in common.

import { Color, SRGBColorSpace } from "../../vendor/three.js";
import { MOST_POINTS } from "./cloudFields.js";
import { createPoints } from "./points.js";

/** @import { Context } from "./shown.js" */
/** @typedef {ReturnType<typeof createPoints>} Cloud */

const AXES = ["x", "y", "z"];
// The hues of the least and of the greatest value: from red over green to blue and violet, as in RViz.
const HUES = 0.85;

/**
 * Return what shows points in the group of a display: `show` draws those of a message.
 * @param {Context} context
 * @param {Record<string, any>} options `size` in metres, `color_by`, `color`, `alpha`, `decay` in seconds, and `min` and
 *   `max` of the values to colour by; both 0: those of the message
 */
export function pointsOf({ root, floor, redraw, tint }, options) {
  /** @type {{cloud: Cloud, until: number}[]} */
  const kept = [];
  /** @type {Cloud | undefined} */
  let current;

  const look = () => ({ size: options.size, color: tint(options.color), opacity: options.alpha });
  const forget = (/** @type {number} */ count) => {
    for (const { cloud } of kept.splice(0, count)) cloud.close();
  };
  return {
    /** @param {Float32Array} positions @param {{rgb?: Float32Array, intensity?: Float32Array}} values */
    show(positions, values) {
      if (current && options.decay > 0) {
        // It stays where it was.
        floor.attach(current.points);
        kept.push({ cloud: current, until: performance.now() + options.decay * 1000 });
        while (kept.reduce((sum, { cloud }) => sum + countOf(cloud), 0) > MOST_POINTS) forget(1);
        current = undefined;
      }
      const colors = colorsOf(positions, values, options);
      if (current) {
        current.move(positions, colors);
      } else {
        current = createPoints(positions, colors);
        root.add(current.points);
      }
      current.style(look());
      redraw();
    },
    update(/** @type {number} */ now) {
      const old = kept.findIndex(({ until }) => until > now);
      forget(old < 0 ? kept.length : old);
      if (kept.length) redraw();
    },
    set() {
      for (const cloud of [...kept.map(({ cloud }) => cloud), ...(current ? [current] : [])]) cloud.style(look());
    },
    clear() {
      forget(kept.length);
      current?.close();
      current = undefined;
    },
    close() {
      forget(kept.length);
      current?.close();
    },
  };
}

/** @param {Cloud} cloud */
function countOf({ points }) {
  return points.geometry.getAttribute("position").count;
}

/**
 * Return r, g and b of each point as they are drawn; undefined if all have the same colour.
 * @param {Float32Array} positions @param {{rgb?: Float32Array, intensity?: Float32Array}} values
 * @param {Record<string, any>} options
 */
function colorsOf(positions, { rgb, intensity }, { color_by: by, min, max }) {
  const axis = AXES.indexOf(by);
  if (rgb && (by === "rgb" || by === "auto")) return linear(rgb);
  const count = positions.length / 3;
  if (axis >= 0) return rainbow(count, (index) => positions[index * 3 + axis] ?? 0, min, max);
  if (intensity && (by === "intensity" || by === "auto")) return rainbow(count, (index) => intensity[index] ?? 0, min, max);
  return undefined;
}

/** @param {number} count @param {(index: number) => number} value @param {number} least @param {number} most */
function rainbow(count, value, least, most) {
  if (least === 0 && most === 0) {
    [least, most] = [Infinity, -Infinity];
    for (let index = 0; index < count; index++) {
      const one = value(index);
      if (one < least) least = one;
      if (one > most) most = one;
    }
  }
  const colors = new Float32Array(count * 3);
  const span = most - least || 1;
  const palette = PALETTE ??= createPalette();
  for (let index = 0; index < count; index++) {
    const part = Math.max(0, Math.min(1, (value(index) - least) / span)) || 0;
    const at = Math.round(part * 255) * 3;
    colors[index * 3] = palette[at] ?? 0;
    colors[index * 3 + 1] = palette[at + 1] ?? 0;
    colors[index * 3 + 2] = palette[at + 2] ?? 0;
  }
  return colors;
}

/** @type {Float32Array | undefined} */
let PALETTE;

function createPalette() {
  const palette = new Float32Array(256 * 3);
  const color = new Color();
  for (let index = 0; index < 256; index++) {
    color.setHSL((index / 255) * HUES, 1, 0.5, SRGBColorSpace).toArray(palette, index * 3);
  }
  return palette;
}

/** Return colours as they are computed with, which is not how screens and messages have them. @param {Float32Array} rgb */
function linear(rgb) {
  const curve = LINEAR ??= Float32Array.from({ length: 256 }, (_, index) => {
    const part = index / 255;
    return part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4;
  });
  return rgb.map((part) => curve[Math.round(part * 255)] ?? 0);
}

/** @type {Float32Array | undefined} */
let LINEAR;
