// @ts-check
// Decode the pixels of sensor_msgs/msg/Image.

import { say } from "../../ui/words.js";
import { demosaic } from "./bayer.js";

/**
 * @typedef {{width: number, height: number, encoding: string, is_bigendian: number | boolean, step: number,
 *   data: Uint8Array}} Image
 * @typedef {{data: Uint8ClampedArray<ArrayBuffer>, low: number, high: number}} Pixels red, green, blue and alpha of each pixel;
 *   `low` and `high` are the ends of a range of depth, else NaN
 * @typedef {{low: number, high: number}} Range NaN for the smallest and the largest value of the image
 * @typedef {(rows: Rows, pixels: Uint8ClampedArray<ArrayBuffer>) => void} Decode
 * @typedef {{width: number, height: number, step: number, data: Uint8Array}} Rows
 */

// The most pixels that browsers can draw.
const MOST = 16384 * 4096;

/** Colours: the number of bytes of a pixel, and where red, green, blue and alpha are; -1 for opaque. */
const COLOURS = /** @type {Record<string, [number, number, number, number, number]>} */ ({
  rgb8: [3, 0, 1, 2, -1],
  bgr8: [3, 2, 1, 0, -1],
  rgba8: [4, 0, 1, 2, 3],
  bgra8: [4, 2, 1, 0, 3],
  mono8: [1, 0, 0, 0, -1],
  "8UC1": [1, 0, 0, 0, -1],
  "8UC3": [3, 2, 1, 0, -1],
  "8UC4": [4, 2, 1, 0, 3],
});
/** Numbers: the bytes of each, and whether it is a depth that can be missing. */
const NUMBERS = /** @type {Record<string, [number, boolean]>} */ ({
  mono16: [2, false],
  "16UC1": [2, true],
  "32FC1": [4, true],
});
/** Two pixels with a colour: where the first brightness, the second, and the blue and red differences are. */
const YUV = /** @type {Record<string, [number, number, number, number]>} */ ({
  yuv422: [1, 3, 0, 2],
  uyvy: [1, 3, 0, 2],
  yuv422_yuy2: [0, 2, 1, 3],
  yuyv: [0, 2, 1, 3],
});
/** A quarter of a sensor: the colours of a row and of the row below. */
const BAYER = /** @type {Record<string, string>} */ ({
  bayer_rggb8: "rggb",
  bayer_bggr8: "bggr",
  bayer_gbrg8: "gbrg",
  bayer_grbg8: "grbg",
});
const ENCODINGS = [COLOURS, NUMBERS, YUV, BAYER].flatMap((one) => Object.keys(one));

/** Whether the pixels of an encoding are numbers that have a range. @param {string} encoding */
export function hasRange(encoding) {
  return Object.hasOwn(NUMBERS, encoding);
}

/**
 * Decode an image. Throws an Error that says what is wrong with it.
 * @param {Image} image @param {Range} range @returns {Pixels}
 */
export function decode(image, range) {
  const { width, height, encoding } = image;
  if (!ENCODINGS.includes(encoding)) {
    throw new Error(say("The encoding '{}' is not supported; use one of {}", encoding.slice(0, 40), ENCODINGS.join(", ")));
  }
  if (!(width > 0 && height > 0)) throw new Error(say("The image is empty: {} × {} pixels", width, height));
  if (width * height > MOST) throw new Error(say("The image is too large: {} × {} pixels", width, height));
  const numbers = NUMBERS[encoding];
  const bytes = numbers?.[0] ?? COLOURS[encoding]?.[0] ?? (YUV[encoding] ? 2 : 1);
  if (YUV[encoding] && width % 2) throw new Error(say("{} needs an even width, not {}", encoding, width));
  const rows = rowsOf(image, bytes);
  const pixels = new Uint8ClampedArray(4 * width * height);
  if (numbers) return { data: pixels, ...drawNumbers(rows, numbers, Boolean(image.is_bigendian), range, pixels) };
  const [colours, yuv, bayer] = [COLOURS[encoding], YUV[encoding], BAYER[encoding]];
  if (colours) drawColours(rows, colours, pixels);
  else if (yuv) drawYuv(rows, yuv, pixels);
  else if (bayer) demosaic(rows, bayer, pixels);
  return { data: pixels, low: NaN, high: NaN };
}

/** Check that all rows are there. @param {Image} image @param {number} bytes of a pixel @returns {Rows} */
function rowsOf({ width, height, step, encoding, data }, bytes) {
  const row = width * bytes;
  // Publishers without padding may leave it out.
  const apart = step || row;
  if (apart < row) {
    throw new Error(say("step is {}, but a row of {} pixels in {} has {} bytes", step, width, encoding, row));
  }
  const needed = apart * (height - 1) + row;
  if (data.length < needed) {
    throw new Error(say("The image has {} bytes of data; {} × {} pixels in {} need {}", data.length, width, height,
      encoding, needed));
  }
  return { width, height, step: apart, data };
}

/** @param {Rows} rows @param {[number, number, number, number, number]} colours @param {Uint8ClampedArray} pixels */
function drawColours({ width, height, step, data }, [bytes, red, green, blue, alpha], pixels) {
  let to = 0;
  for (let row = 0; row < height; row++) {
    let from = row * step;
    for (let column = 0; column < width; column++, from += bytes, to += 4) {
      pixels[to] = byte(data, from + red);
      pixels[to + 1] = byte(data, from + green);
      pixels[to + 2] = byte(data, from + blue);
      pixels[to + 3] = alpha < 0 ? 255 : byte(data, from + alpha);
    }
  }
}

/** As in video: brightness from 16 to 235. @param {Rows} rows @param {[number, number, number, number]} places @param {Uint8ClampedArray} pixels */
function drawYuv({ width, height, step, data }, [first, second, blue, red], pixels) {
  let to = 0;
  for (let row = 0; row < height; row++) {
    for (let from = row * step; from < row * step + 2 * width; from += 4) {
      const u = byte(data, from + blue) - 128;
      const v = byte(data, from + red) - 128;
      for (const place of [first, second]) {
        const y = 1.164 * (byte(data, from + place) - 16);
        pixels[to] = y + 1.596 * v;
        pixels[to + 1] = y - 0.813 * v - 0.391 * u;
        pixels[to + 2] = y + 2.018 * u;
        pixels[to + 3] = 255;
        to += 4;
      }
    }
  }
}

/**
 * Draw numbers in grey, from the smallest in black to the largest in white. A depth that is missing is transparent.
 * @param {Rows} rows @param {[number, boolean]} numbers @param {boolean} big endian @param {Range} range
 * @param {Uint8ClampedArray} pixels @returns {{low: number, high: number}} the range
 */
function drawNumbers({ width, height, step, data }, [bytes, depth], big, range, pixels) {
  const view = new DataView(data.buffer, data.byteOffset, data.byteLength);
  const values = new Float32Array(width * height);
  let [least, most] = [Infinity, -Infinity];
  for (let row = 0, at = 0; row < height; row++) {
    for (let from = row * step; from < row * step + width * bytes; from += bytes) {
      let value = bytes === 2 ? view.getUint16(from, !big) : view.getFloat32(from, !big);
      if (depth && bytes === 2 && value === 0) value = NaN;
      values[at++] = value;
      if (value < least && value > -Infinity) least = value;
      if (value > most && value < Infinity) most = value;
    }
  }
  const low = Number.isNaN(range.low) ? least : range.low;
  const high = Number.isNaN(range.high) ? most : range.high;
  for (let at = 0; at < values.length; at++) {
    const value = values[at] ?? NaN;
    if (!Number.isFinite(value)) continue;
    const grey = high > low ? (255 * (value - low)) / (high - low) : 128;
    pixels[4 * at] = pixels[4 * at + 1] = pixels[4 * at + 2] = grey;
    pixels[4 * at + 3] = 255;
  }
  return least <= most ? { low, high } : { low: NaN, high: NaN };
}

/** @param {Uint8Array} data @param {number} at @returns {number} */
function byte(data, at) {
  return /** @type {number} */ (data[at]);
}
