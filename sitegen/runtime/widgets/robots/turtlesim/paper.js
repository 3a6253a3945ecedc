// @ts-check
// What the turtles draw on, in the coordinates of the turtlesim window.

/** The side of the window, in pixels. */
export const SIZE = 500;
// Pixels per metre, and canvas pixels per pixel, for sharp lines on screens of high resolution.
const METER = 45;
const FINE = 2;

export class Paper {
  canvas = document.createElement("canvas");
  #context = /** @type {CanvasRenderingContext2D} */ (this.canvas.getContext("2d"));

  constructor() {
    this.canvas.width = this.canvas.height = FINE * SIZE;
    this.#context.scale(FINE, FINE);
    this.#context.lineCap = "round";
  }

  clear() {
    this.#context.clearRect(0, 0, SIZE, SIZE);
  }

  /** Draw with the pen of a turtle. @param {any} pen @param {any} from a pose @param {any} to a pose */
  line({ r, g, b, width }, from, to) {
    if (from.x === to.x && from.y === to.y) return;
    this.#context.strokeStyle = color(r, g, b);
    this.#context.lineWidth = width;
    this.#context.beginPath();
    this.#context.moveTo(...pixels(from));
    this.#context.lineTo(...pixels(to));
    this.#context.stroke();
  }
}

/** @param {{x: number, y: number}} pose in metres @returns {[number, number]} */
export function pixels({ x, y }) {
  return [x * METER, SIZE - 1 - y * METER];
}

/** @param {number} r @param {number} g @param {number} b */
export function color(r, g, b) {
  return `rgb(${r} ${g} ${b})`;
}
