// @ts-check
// Decode a large image in parts, so that the page draws and answers in between.

import { create } from "../../ui/elements.js";

/** @import { Decoder } from "./decode.js" */

// How long a part of a frame may take (ms).
const SLICE = 8;
// So many pixels are decoded at once.
const BAND = 32_768;

/**
 * Return a canvas with the image, or undefined if nobody wants it any more.
 * @param {Decoder} decoder @param {number} width @param {number} height @param {() => boolean} wanted
 */
export async function decodeInSlices(decoder, width, height, wanted) {
  const canvas = create("canvas", "");
  [canvas.width, canvas.height] = [width, height];
  const paper = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"));
  const count = Math.max(Math.floor(BAND / width), 1);
  const band = new ImageData(width, count);
  let end = performance.now() + SLICE;
  const inSlices = async (/** @type {(from: number, until: number) => void} */ act) => {
    for (let row = 0; row < height && wanted(); row += count) {
      act(row, Math.min(row + count, height));
      if (performance.now() < end) continue;
      await new Promise((done) => requestAnimationFrame(done));
      end = performance.now() + SLICE;
    }
  };
  if (decoder.isMeasured) await inSlices((from, until) => decoder.measure(from, until));
  await inSlices((from, until) => {
    decoder.draw(from, until, band.data);
    paper.putImageData(band, 0, from);
  });
  return wanted() ? canvas : undefined;
}
