// @ts-check
// Colours from the raw image of a sensor whose pixels see one colour each.

/** @import { Rows } from "./decode.js" */

const PARTS = "rgb";

/**
 * Write the pixels of some rows of an image: the colour that a pixel sees is its own, the others are the means of its neighbours.
 * @param {Rows} rows @param {string} pattern the colours of a square of four, such as "rggb" @param {number} from a row @param {number} until
 * @param {Uint8ClampedArray} pixels
 */
export function demosaic({ width, height, step, data }, pattern, from, until, pixels) {
  const seen = [...pattern].map((colour) => PARTS.indexOf(colour));
  const sums = [0, 0, 0];
  const counts = [0, 0, 0];
  for (let row = from, to = 0; row < until; row++) {
    for (let column = 0; column < width; column++, to += 4) {
      sums.fill(0);
      counts.fill(0);
      for (let y = Math.max(row - 1, 0); y <= Math.min(row + 1, height - 1); y++) {
        for (let x = Math.max(column - 1, 0); x <= Math.min(column + 1, width - 1); x++) {
          const part = colourAt(seen, x, y);
          sums[part] = /** @type {number} */ (sums[part]) + /** @type {number} */ (data[y * step + x]);
          counts[part] = /** @type {number} */ (counts[part]) + 1;
        }
      }
      for (let part = 0; part < 3; part++) {
        pixels[to + part] = /** @type {number} */ (sums[part]) / Math.max(/** @type {number} */ (counts[part]), 1);
      }
      pixels[to + colourAt(seen, column, row)] = /** @type {number} */ (data[row * step + column]);
      pixels[to + 3] = 255;
    }
  }
}

/** @param {number[]} seen @param {number} x @param {number} y */
function colourAt(seen, x, y) {
  return /** @type {number} */ (seen[2 * (y & 1) + (x & 1)]);
}
