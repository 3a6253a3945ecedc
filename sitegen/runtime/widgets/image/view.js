// @ts-check
// A canvas that visitors zoom and move by wheel, touch, keyboard or buttons.

import { followPointers } from "../../ui/drawing.js";
import { create } from "../../ui/elements.js";
import { zoomTools } from "../../ui/toolbar.js";

const STEP = 1.3;
// In screen pixels for a pixel of the image.
const SMALLEST = 0.02;
const LARGEST = 64;
// How far an arrow key moves the image (px).
const STRIDE = 48;
// From this size on, pixels have sharp edges.
const SHARP = 2;

export class ImageView {
  canvas = create("canvas", "");
  element = create("div", "ros-picture", this.canvas);
  tools = zoomTools((closer) => this.#zoom(closer ? STEP : 1 / STEP), () => this.#fit());
  #view = { x: 0, y: 0, scale: 1 };
  /** Whether the whole image is in view: it stays so when sizes change. */
  #fitted = true;
  #resized = new ResizeObserver(() => this.#refit());

  constructor() {
    this.element.tabIndex = 0;
    this.element.setAttribute("role", "img");
    this.canvas.width = this.canvas.height = 0;
    this.element.addEventListener("wheel", (event) => {
      // The wheel scrolls the page unless the visitor has selected the image.
      if (!event.ctrlKey && document.activeElement !== this.element) return;
      event.preventDefault();
      this.#zoom(Math.exp(-event.deltaY / (event.ctrlKey ? 100 : 500)), event.offsetX, event.offsetY);
    }, { passive: false });
    followPointers(this.element, (x, y) => this.#move(x, y), (factor, x, y) => this.#zoom(factor, x, y));
    this.element.addEventListener("keydown", (event) => this.#press(event));
    this.#resized.observe(this.element);
  }

  /** Draw an image. A canvas takes the place of the one before. @param {ImageData | ImageBitmap | HTMLCanvasElement} image */
  draw(image) {
    const { width, height } = image;
    const resized = this.canvas.width !== width || this.canvas.height !== height;
    if (image instanceof HTMLCanvasElement) this.#replace(image);
    else if (resized) [this.canvas.width, this.canvas.height] = [width, height];
    if (resized) this.#fit();
    if (image instanceof HTMLCanvasElement) return;
    const paper = this.canvas.getContext("2d");
    if (image instanceof ImageData) {
      paper?.putImageData(image, 0, 0);
    } else {
      paper?.clearRect(0, 0, width, height);
      paper?.drawImage(image, 0, 0);
    }
  }

  /** Show no image. */
  clear() {
    this.canvas.width = this.canvas.height = 0;
  }

  close() {
    this.#resized.disconnect();
  }

  /** @param {HTMLCanvasElement} canvas */
  #replace(canvas) {
    canvas.style.cssText = this.canvas.style.cssText;
    this.canvas.replaceWith(canvas);
    // Its memory is large, and would be freed some time later.
    this.clear();
    this.canvas = canvas;
  }

  #refit() {
    if (this.#fitted) this.#fit();
  }

  #fit() {
    const { clientWidth, clientHeight } = this.element;
    const { width, height } = this.canvas;
    if (!width || !height) return;
    const scale = Math.max(Math.min(clientWidth / width, clientHeight / height), SMALLEST);
    this.#look({ scale, x: (clientWidth - width * scale) / 2, y: (clientHeight - height * scale) / 2 }, true);
  }

  /** @param {number} x @param {number} y */
  #move(x, y) {
    this.#look({ ...this.#view, x: this.#view.x + x, y: this.#view.y + y }, false);
  }

  /**
   * Zoom; the point x, y of the area stays where it is.
   * @param {number} factor @param {number} [x] @param {number} [y]
   */
  #zoom(factor, x = this.element.clientWidth / 2, y = this.element.clientHeight / 2) {
    const scale = Math.min(Math.max(this.#view.scale * factor, SMALLEST), LARGEST);
    const by = scale / this.#view.scale;
    this.#look({ scale, x: x - (x - this.#view.x) * by, y: y - (y - this.#view.y) * by }, false);
  }

  /** @param {{x: number, y: number, scale: number}} view @param {boolean} fitted */
  #look(view, fitted) {
    this.#view = view;
    this.#fitted = fitted;
    this.canvas.style.transform = `translate(${view.x}px, ${view.y}px) scale(${view.scale})`;
    this.canvas.style.imageRendering = view.scale >= SHARP ? "pixelated" : "auto";
    // A finger scrolls the page while the whole image is in view, and else moves the image.
    this.element.style.touchAction = fitted ? "pan-x pan-y" : "none";
  }

  /** @param {KeyboardEvent} event */
  #press(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    /** @type {Record<string, () => void>} */
    const keys = {
      "+": () => this.#zoom(STEP),
      "=": () => this.#zoom(STEP),
      "-": () => this.#zoom(1 / STEP),
      0: () => this.#fit(),
      ArrowLeft: () => this.#move(STRIDE, 0),
      ArrowRight: () => this.#move(-STRIDE, 0),
      ArrowUp: () => this.#move(0, STRIDE),
      ArrowDown: () => this.#move(0, -STRIDE),
    };
    const act = keys[event.key];
    if (!act) return;
    event.preventDefault();
    act();
  }
}
