// @ts-check
// The curves of a plot against x. A picture of them is kept, so that a frame draws only what is new.
//
// Samples that the window drops cannot be taken out of a picture. So it lacks the oldest ones, which each frame draws
// beside it, and a second picture that lacks somewhat more is drawn little by little: it takes the place of the first
// when one of the samples in this is dropped.

import { create } from "../../ui/elements.js";
import { Pen } from "./pen.js";

/** @import { Curve } from "./curve.js" */
/** @import { Look } from "./pen.js" */

/** @typedef {{left: number, top: number, width: number, height: number}} Box where the curves are on a canvas (px) */

// The share of the samples that is drawn beside a picture, and the fewest of them.
const SHARE = 1 / 32;
const FEWEST = 64;
// In how many rounds a picture is drawn, so that newer lines are above older ones of other curves.
const ROUNDS = 16;
// A picture is complete before it is needed: at this share of the time that there is.
const EARLY = 0.75;

export class Trail {
  #key = "";
  /** @type {Curve[]} */
  #curves = [];
  #shown = new Picture();
  #next = new Picture();

  /**
   * Draw the curves.
   * @param {CanvasRenderingContext2D} paper @param {Curve[]} curves @param {Box} box @param {Look} look
   */
  paint(paper, curves, box, look) {
    const size = [Math.ceil(box.width), Math.ceil(box.height)];
    const key = JSON.stringify([size, look]);
    const same = curves.length === this.#curves.length && curves.every((curve, at) => curve === this.#curves[at]);
    if (key !== this.#key || !same) {
      this.#key = key;
      this.#curves = curves;
      this.#shown.begin(curves, look, size, sparedOf);
      this.#next.begin(curves, look, size, (curve) => 2 * sparedOf(curve));
    }
    if (this.#shown.isLost) this.#replace(look, size);
    this.#shown.draw(1);
    if (!this.#next.isLost) this.#next.draw(this.#shown.used / EARLY);
    // Between two pixels, it would be blurred.
    this.#shown.show(paper, Math.round(box.left), Math.round(box.top));
  }

  /** Show the next picture, and begin another. @param {Look} look @param {number[]} size */
  #replace(look, size) {
    [this.#shown, this.#next] = [this.#next, this.#shown];
    if (this.#shown.isLost) this.#shown.begin(this.#curves, look, size, sparedOf);
    else this.#shown.take();
    this.#next.begin(this.#curves, look, size, (curve) => 2 * sparedOf(curve));
  }
}

/** The number of samples that a picture lacks: none before the first is dropped. @param {Curve} curve */
function sparedOf({ trace }) {
  return trace.first ? Math.max(Math.ceil(trace.size * SHARE), FEWEST) : 0;
}

/** A picture of the curves from a sample of each on. */
class Picture {
  #canvas = create("canvas", "");
  #paper = /** @type {CanvasRenderingContext2D} */ (this.#canvas.getContext("2d"));
  #look = /** @type {Look} */ ({});
  /** Each with the number of its first sample in the picture, and of the first that there was. */
  #lines = /** @type {{pen: Pen, from: number, first: number}[]} */ ([]);

  /** Whether a sample in the picture has been dropped. */
  get isLost() {
    return this.#lines.some(({ pen, from }) => pen.curve.trace.first > from);
  }

  /** How much of what the picture lacks has been dropped, from 0 to 1. */
  get used() {
    return Math.max(0, ...this.#lines.map(({ pen, from, first }) =>
      (from > first ? (pen.curve.trace.first - first) / (from - first) : 0)));
  }

  /**
   * @param {Curve[]} curves @param {Look} look @param {number[]} size
   * @param {(curve: Curve) => number} spared how many samples the picture lacks
   */
  begin(curves, look, [width = 0, height = 0], spared) {
    // This clears it, too.
    this.#canvas.width = width;
    this.#canvas.height = height;
    this.#look = look;
    this.#lines = curves.map((curve) => {
      const { first, end } = curve.trace;
      const from = Math.min(first + spared(curve), end);
      return { pen: new Pen(curve, look, from), from, first };
    });
  }

  /** Begin to use the picture. */
  take() {
    for (const line of this.#lines) line.first = line.pen.curve.trace.first;
  }

  /** Draw a share of all samples, at most 1. @param {number} share */
  draw(share) {
    for (let round = 1; round <= ROUNDS; round++) {
      const part = Math.min(share, 1) * (round / ROUNDS);
      for (const { pen, from } of this.#lines) {
        pen.draw(this.#paper, from + Math.floor((pen.curve.trace.end - from) * part));
      }
    }
  }

  /** Show the picture, and what it lacks. @param {CanvasRenderingContext2D} paper @param {number} left @param {number} top */
  show(paper, left, top) {
    paper.save();
    paper.translate(left, top);
    for (const { pen: { curve }, from } of this.#lines) {
      const { first, end } = curve.trace;
      if (from === first) continue;
      const pen = new Pen(curve, this.#look, first);
      pen.draw(paper, Math.min(from + 1, end));
      pen.finish(paper, from === end);
    }
    if (this.#canvas.width && this.#canvas.height) paper.drawImage(this.#canvas, 0, 0);
    for (const { pen } of this.#lines) pen.finish(paper, true);
    paper.restore();
  }
}
