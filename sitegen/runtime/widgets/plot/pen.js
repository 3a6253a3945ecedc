// @ts-check
// Draw one curve against x, and go on later where it stopped.

import { isDrawn } from "./outline.js";

/** @import { Curve } from "./curve.js" */

/**
 * @typedef {{left: number, high: number, scaleX: number, scaleY: number, ratio: number, points: boolean,
 *   colours: string[], dashes: number[][]}} Look where x and y are on a canvas, in its pixels, and how curves look
 */

const WIDTH = 1.75;
const RADIUS = 2.75;
// Long lines are drawn in pieces of so many points: browsers need much longer for all at once.
const PIECE = 256;

export class Pen {
  curve;
  #look;
  /** The number of the sample that is drawn next. */
  next;
  /** The last point (px), NaN after a gap. */
  #x = NaN;
  #y = NaN;
  /** Whether a line leads to the last point. */
  #joined = false;
  /** How long the line is (px): dashes go on where they stopped. */
  #length = 0;
  #dots = new Path2D();

  /** @param {Curve} curve @param {Look} look @param {number} first the number of the sample to begin with */
  constructor(curve, look, first) {
    this.curve = curve;
    this.#look = look;
    this.next = first;
  }

  /** Draw the samples before one with this number. @param {CanvasRenderingContext2D} paper @param {number} until */
  draw(paper, until) {
    if (this.next >= until) return;
    prepare(paper, this.curve, this.#look);
    while (this.next < until) {
      const end = Math.min(this.next + PIECE, until);
      paper.lineDashOffset = this.#length;
      paper.beginPath();
      paper.moveTo(this.#x, this.#y);
      while (this.next < end) this.#step(paper, this.next++);
      paper.stroke();
    }
    paper.fill(this.#dots);
    this.#dots = new Path2D();
  }

  /**
   * Draw the rest of the line, up to the last sample. It is drawn again when the line goes on.
   * @param {CanvasRenderingContext2D} paper @param {boolean} ends whether a sample without a line is a point
   */
  finish(paper, ends) {
    if (Number.isNaN(this.#x)) return;
    prepare(paper, this.curve, this.#look);
    const [x, y] = this.#place(this.next - 1);
    paper.lineDashOffset = this.#length;
    paper.beginPath();
    paper.moveTo(this.#x, this.#y);
    paper.lineTo(x, y);
    paper.stroke();
    if (ends && !this.#joined) paper.fill(dot(new Path2D(), x, y, this.#look));
  }

  /** @param {CanvasRenderingContext2D} paper @param {number} number */
  #step(paper, number) {
    const [x, y] = this.#place(number);
    if (Number.isNaN(x)) {
      // A sample between two gaps is a point.
      if (!Number.isNaN(this.#x) && !this.#joined) dot(this.#dots, this.#x, this.#y, this.#look);
      this.#x = this.#y = NaN;
      this.#joined = false;
      return;
    }
    const length = Math.max(Math.abs(x - this.#x), Math.abs(y - this.#y));
    // Less than a pixel from the last point.
    if (length < 1) return;
    if (Number.isNaN(length)) {
      paper.moveTo(x, y);
    } else {
      paper.lineTo(x, y);
      this.#length += Math.hypot(x - this.#x, y - this.#y);
      this.#joined = true;
    }
    if (this.#look.points) dot(this.#dots, x, y, this.#look);
    [this.#x, this.#y] = [x, y];
  }

  /** Where a sample is, NaN for a gap. @param {number} number @returns {[number, number]} */
  #place(number) {
    const { trace } = this.curve;
    const index = number - trace.first;
    const [x, y] = [trace.x(index), trace.value(index)];
    if (!isDrawn(x) || !isDrawn(y)) return [NaN, NaN];
    const { left, high, scaleX, scaleY } = this.#look;
    return [(x - left) * scaleX, (high - y) * scaleY];
  }
}

/** @param {CanvasRenderingContext2D} paper @param {Curve} curve @param {Look} look */
export function prepare(paper, { number }, { ratio, colours, dashes }) {
  const dash = dashes[Math.floor(number / colours.length)] ?? [];
  paper.lineJoin = "round";
  // Pieces of a line meet in round ends; those of dashes would close the gaps.
  paper.lineCap = dash.length ? "butt" : "round";
  paper.lineWidth = WIDTH * ratio;
  paper.strokeStyle = paper.fillStyle = colours[number % colours.length] ?? "";
  paper.setLineDash(dash.map((length) => length * ratio));
}

/** Add a dot to a path. @param {Path2D} path @param {number} x @param {number} y @param {{ratio: number}} look */
export function dot(path, x, y, { ratio }) {
  path.moveTo(x + RADIUS * ratio, y);
  path.arc(x, y, RADIUS * ratio, 0, 2 * Math.PI);
  return path;
}
