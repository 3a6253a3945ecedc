// @ts-check
// What a camera publishes.

/** @param {string} frame */
export function headerOf(frame) {
  const now = performance.timeOrigin + performance.now();
  const sec = Math.floor(now / 1000);
  return { stamp: { sec, nanosec: Math.floor((now - 1000 * sec) * 1e6) }, frame_id: frame };
}

/** A sensor_msgs/msg/Image in rgb8. @param {any} header @param {HTMLCanvasElement} canvas */
export function rawOf(header, canvas) {
  const { width, height } = canvas;
  const pixels = canvas.getContext("2d")?.getImageData(0, 0, width, height).data ?? new Uint8ClampedArray();
  const data = new Uint8Array((pixels.length / 4) * 3);
  for (let from = 0, to = 0; from < pixels.length; from += 4, to += 3) {
    data[to] = /** @type {number} */ (pixels[from]);
    data[to + 1] = /** @type {number} */ (pixels[from + 1]);
    data[to + 2] = /** @type {number} */ (pixels[from + 2]);
  }
  return { header, width, height, encoding: "rgb8", is_bigendian: 0, step: 3 * width, data };
}

/** A sensor_msgs/msg/CameraInfo without a calibration. @param {any} header @param {{width: number, height: number}} size */
export function infoOf(header, { width, height }) {
  return {
    header, width, height, distortion_model: "", d: new Float64Array(),
    k: new Float64Array(9), r: new Float64Array(9), p: new Float64Array(12), binning_x: 0, binning_y: 0,
    roi: { x_offset: 0, y_offset: 0, height: 0, width: 0, do_rectify: false },
  };
}
