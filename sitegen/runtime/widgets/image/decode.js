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
  const decoder = new Decoder(image, range);
  const { width, height } = image;
  const pixels = new Uint8ClampedArray(4 * width * height);
  if (decoder.isMeasured) decoder.measure(0, height);
  decoder.draw(0, height, pixels);
  return { data: pixels, ...decoder.range };
}

/** Decodes an image in parts: some rows at a time. */
export class Decoder {
  #encoding;
  #big;
  #wanted;
  #rows;
  #least = Infinity;
  #most = -Infinity;

  /** Throws an Error that says what is wrong with the image. @param {Image} image @param {Range} range */
  constructor(image, range) {
    const { width, height, encoding } = image;
    if (!ENCODINGS.includes(encoding)) {
      throw new Error(say("The encoding '{}' is not supported; use one of {}", encoding.slice(0, 40), ENCODINGS.join(", ")));
    }
    if (!(width > 0 && height > 0)) throw new Error(say("The image is empty: {} × {} pixels", width, height));
    if (width * height > MOST) throw new Error(say("The image is too large: {} × {} pixels", width, height));
    if (YUV[encoding] && width % 2) throw new Error(say("{} needs an even width, not {}", encoding, width));
    this.#encoding = encoding;
    this.#big = Boolean(image.is_bigendian);
    this.#wanted = range;
    this.#rows = rowsOf(image, NUMBERS[encoding]?.[0] ?? COLOURS[encoding]?.[0] ?? (YUV[encoding] ? 2 : 1));
  }

  /** Whether all rows must be measured before the first is drawn. */
  get isMeasured() {
    return hasRange(this.#encoding);
  }

  /** The range of what is measured; NaN if nothing is. @returns {Range} */
  get range() {
    if (!(this.#least <= this.#most)) return { low: NaN, high: NaN };
    const { low, high } = this.#wanted;
    return { low: Number.isNaN(low) ? this.#least : low, high: Number.isNaN(high) ? this.#most : high };
  }

  /** Find the smallest and the largest value. @param {number} from a row @param {number} until */
  measure(from, until) {
    eachNumber(this.#rows, this.#numbers, this.#big, from, until, (value) => {
      if (value < this.#least && value > -Infinity) this.#least = value;
      if (value > this.#most && value < Infinity) this.#most = value;
    });
  }

  /** Draw rows at the beginning of `pixels`. @param {number} from @param {number} until @param {Uint8ClampedArray} pixels */
  draw(from, until, pixels) {
    const [colours, yuv, bayer] = [COLOURS[this.#encoding], YUV[this.#encoding], BAYER[this.#encoding]];
    if (colours) drawColours(this.#rows, colours, from, until, pixels);
    else if (yuv) drawYuv(this.#rows, yuv, from, until, pixels);
    else if (bayer) demosaic(this.#rows, bayer, from, until, pixels);
    else this.#drawNumbers(from, until, pixels);
  }

  get #numbers() {
    return /** @type {[number, boolean]} */ (NUMBERS[this.#encoding]);
  }

  /**
   * Draw numbers in grey, from the smallest in black to the largest in white. A depth that is missing is transparent.
   * @param {number} from @param {number} until @param {Uint8ClampedArray} pixels
   */
  #drawNumbers(from, until, pixels) {
    const { low, high } = this.range;
    let to = 0;
    eachNumber(this.#rows, this.#numbers, this.#big, from, until, (value) => {
      const there = Number.isFinite(value);
      const grey = high > low ? (255 * (value - low)) / (high - low) : 128;
      pixels[to] = pixels[to + 1] = pixels[to + 2] = there ? grey : 0;
      pixels[to + 3] = there ? 255 : 0;
      to += 4;
    });
  }
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

/**
 * @param {Rows} rows @param {[number, number, number, number, number]} colours @param {number} from @param {number} until
 * @param {Uint8ClampedArray} pixels
 */
function drawColours({ width, step, data }, [bytes, red, green, blue, alpha], from, until, pixels) {
  let to = 0;
  for (let row = from; row < until; row++) {
    let at = row * step;
    for (let column = 0; column < width; column++, at += bytes, to += 4) {
      pixels[to] = byte(data, at + red);
      pixels[to + 1] = byte(data, at + green);
      pixels[to + 2] = byte(data, at + blue);
      pixels[to + 3] = alpha < 0 ? 255 : byte(data, at + alpha);
    }
  }
}

/**
 * As in video: brightness from 16 to 235.
 * @param {Rows} rows @param {[number, number, number, number]} places @param {number} from @param {number} until
 * @param {Uint8ClampedArray} pixels
 */
function drawYuv({ width, step, data }, [first, second, blue, red], from, until, pixels) {
  let to = 0;
  for (let row = from; row < until; row++) {
    for (let at = row * step; at < row * step + 2 * width; at += 4) {
      const u = byte(data, at + blue) - 128;
      const v = byte(data, at + red) - 128;
      for (const place of [first, second]) {
        const y = 1.164 * (byte(data, at + place) - 16);
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
 * Call `take` for each number in some rows; NaN is a depth that is missing.
 * @param {Rows} rows @param {[number, boolean]} numbers @param {boolean} big endian @param {number} from
 * @param {number} until @param {(value: number) => void} take
 */
function eachNumber({ width, step, data }, [bytes, depth], big, from, until, take) {
  const view = new DataView(data.buffer, data.byteOffset, data.byteLength);
  for (let row = from; row < until; row++) {
    const end = row * step + width * bytes;
    for (let at = row * step; at < end; at += bytes) {
      const value = bytes === 2 ? view.getUint16(at, !big) : view.getFloat32(at, !big);
      take(depth && bytes === 2 && value === 0 ? NaN : value);
    }
  }
}

/** @param {Uint8Array} data @param {number} at @returns {number} */
function byte(data, at) {
  return /** @type {number} */ (data[at]);
}
