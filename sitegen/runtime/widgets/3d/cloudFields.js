// @ts-check
// Read the points of a sensor_msgs/msg/PointCloud2.

import { say } from "../../ui/words.js";

/** @typedef {{positions: Float32Array, rgb?: Float32Array, intensity?: Float32Array}} Points x, y and z of each point
 *   in metres, r, g and b from 0 to 1, and how strongly it reflects */

/** The types of fields: their sizes in bytes, and how they are read. @type {Record<number, [number, string]>} */
const TYPES = {
  1: [1, "getInt8"], 2: [1, "getUint8"], 3: [2, "getInt16"], 4: [2, "getUint16"],
  5: [4, "getInt32"], 6: [4, "getUint32"], 7: [4, "getFloat32"], 8: [8, "getFloat64"],
};
/** More points are left out evenly: they would neither fit into memory nor be seen. */
export const MOST_POINTS = 2_000_000;
const LITTLE = new Uint8Array(new Uint16Array([1]).buffer)[0] === 1;

/**
 * Return the points that are finite. Throws an Error if the message contradicts itself.
 * @param {any} message @returns {Points}
 */
export function readCloud({ width, height, fields, is_bigendian: big, point_step: step, row_step: row, data }) {
  const total = width * height;
  /** @type {Record<string, any>} */
  const named = Object.fromEntries(fields.map((/** @type {any} */ field) => [field.name, field]));
  const axes = ["x", "y", "z"].map((name) => named[name]);
  if (total === 0) return { positions: new Float32Array() };
  if (axes.some((field) => !field)) throw new Error(say("the points have no fields x, y and z"));
  for (const field of fields) {
    const [size = 0] = TYPES[field.datatype] ?? [];
    if (size && field.offset + size > step) throw new Error(say("the field '{}' lies outside of the points", field.name));
  }
  // Some drivers leave the row step at 0.
  const stride = height > 1 ? row || width * step : width * step;
  if (stride < width * step || data.length < stride * (height - 1) + width * step) {
    throw new Error(say("{} points need {} bytes, but the message has {}", total, total * step, data.length));
  }
  const every = Math.ceil(total / MOST_POINTS);
  const most = Math.ceil(total / every);
  const view = new DataView(data.buffer, data.byteOffset, data.byteLength);
  const read = axes.map((field) => readerOf(view, field, !big));
  const color = named.rgb ?? named.rgba;
  const strength = named.intensity ?? named.i;
  const readStrength = strength && readerOf(view, strength, !big);
  const positions = new Float32Array(most * 3);
  const rgb = color ? new Float32Array(most * 3) : undefined;
  const intensity = readStrength && new Float32Array(most);
  const [readX, readY, readZ] = /** @type {((offset: number) => number)[]} */ (read);
  let count = 0;
  for (let index = 0; index < total; index += every) {
    const offset = height === 1 ? index * step : Math.floor(index / width) * stride + (index % width) * step;
    const x = /** @type {any} */ (readX)(offset);
    const y = /** @type {any} */ (readY)(offset);
    const z = /** @type {any} */ (readZ)(offset);
    if (!Number.isFinite(x + y + z)) continue;
    positions[count * 3] = x;
    positions[count * 3 + 1] = y;
    positions[count * 3 + 2] = z;
    if (rgb) {
      // The colour is in the bits of a number, whatever its type: blue, green, red.
      const bits = view.getUint32(offset + color.offset, !big);
      rgb[count * 3] = ((bits >> 16) & 255) / 255;
      rgb[count * 3 + 1] = ((bits >> 8) & 255) / 255;
      rgb[count * 3 + 2] = (bits & 255) / 255;
    }
    if (intensity) intensity[count] = readStrength(offset);
    count++;
  }
  return {
    positions: positions.subarray(0, count * 3),
    rgb: rgb?.subarray(0, count * 3),
    intensity: intensity?.subarray(0, count),
  };
}

/** Return a function that reads a field of the point at an offset. @param {DataView} view @param {any} field @param {boolean} little */
function readerOf(view, { offset, datatype, name }, little) {
  const type = TYPES[datatype];
  if (!type) throw new Error(say("the field '{}' has the unknown type {}", name, datatype));
  // Most clouds are of this kind, which a typed array reads much faster.
  if (datatype === 7 && little === LITTLE && (view.byteOffset + offset) % 4 === 0) {
    const floats = new Float32Array(view.buffer, view.byteOffset + offset, (view.byteLength - offset) >> 2);
    return (/** @type {number} */ start) =>
      (start % 4 === 0 ? /** @type {number} */ (floats[start >> 2]) : view.getFloat32(start + offset, little));
  }
  const method = /** @type {"getFloat32"} */ (type[1]);
  return (/** @type {number} */ start) => view[method](start + offset, little);
}
