// @ts-check
// A drawing that visitors zoom and move by wheel, touch, keyboard or buttons.

import { create, shape } from "./elements.js";
import { zoomTools } from "./toolbar.js";

const STEP = 1.3;
const SMALLEST = 0.1;
const LARGEST = 4;
// In pixels: how far an arrow key moves the drawing, and the margin around one that fits.
const STRIDE = 48;
const MARGIN = 16;

/** An area that shows a drawing, and the buttons to zoom it. What is drawn goes into `layer`. */
export class Drawing {
  layer = shape("g");
  svg = shape("svg", { tabindex: 0, role: "img" }, this.layer);
  element = create("div", "ros-drawing", this.svg);
  tools = zoomTools((closer) => this.#zoom(closer ? STEP : 1 / STEP), () => this.#fit());
  #width = 1;
  #height = 1;
  #view = { x: 0, y: 0, scale: 1 };
  /** Whether the whole drawing is in view: it stays so when sizes change. */
  #fitted = true;
  #resized = new ResizeObserver(() => {
    if (this.#fitted) this.#fit();
  });

  constructor() {
    this.svg.addEventListener("wheel", (event) => {
      // The wheel scrolls the page unless the visitor has selected the drawing.
      if (!event.ctrlKey && document.activeElement !== this.svg) return;
      event.preventDefault();
      this.#zoom(Math.exp(-event.deltaY / (event.ctrlKey ? 100 : 500)), event.offsetX, event.offsetY);
    }, { passive: false });
    followPointers(this.svg, (x, y) => this.#move(x, y), (factor, x, y) => this.#zoom(factor, x, y));
    this.svg.addEventListener("keydown", (event) => this.#press(event));
    this.#resized.observe(this.element);
  }

  /** Set the size of the drawing. @param {number} width @param {number} height */
  resize(width, height) {
    [this.#width, this.#height] = [width, height];
    if (this.#fitted) this.#fit();
  }

  close() {
    this.#resized.disconnect();
  }

  #fit() {
    const { clientWidth, clientHeight } = this.element;
    const [width, height] = [this.#width, this.#height];
    const scale = Math.min((clientWidth - 2 * MARGIN) / width, (clientHeight - 2 * MARGIN) / height, 1);
    this.#look({
      scale: Math.max(scale, SMALLEST),
      x: (clientWidth - width * scale) / 2,
      y: (clientHeight - height * scale) / 2,
    }, true);
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
    this.layer.setAttribute("transform", `translate(${view.x} ${view.y}) scale(${view.scale})`);
    // A finger scrolls the page while the whole drawing is in view, and else moves the drawing.
    this.svg.style.touchAction = fitted ? "pan-x pan-y" : "none";
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

/**
 * Move with one pointer, zoom with two.
 * @param {SVGElement | HTMLElement} area
 * @param {(x: number, y: number) => void} move
 * @param {(factor: number, x: number, y: number) => void} zoom
 */
export function followPointers(area, move, zoom) {
  /** Positions by pointer id. @type {Map<number, {x: number, y: number}>} */
  const pointers = new Map();
  area.addEventListener("pointerdown", (down) => {
    const event = /** @type {PointerEvent} */ (down);
    area.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, { x: event.offsetX, y: event.offsetY });
  });
  area.addEventListener("pointermove", (moved) => {
    const event = /** @type {PointerEvent} */ (moved);
    const before = pointers.get(event.pointerId);
    if (!before) return;
    const after = { x: event.offsetX, y: event.offsetY };
    pointers.set(event.pointerId, after);
    const other = [...pointers].find(([id]) => id !== event.pointerId)?.[1];
    if (!other) {
      move(after.x - before.x, after.y - before.y);
      return;
    }
    const apart = (/** @type {{x: number, y: number}} */ { x, y }) => Math.hypot(x - other.x, y - other.y);
    zoom(apart(after) / Math.max(apart(before), 1), (after.x + other.x) / 2, (after.y + other.y) / 2);
  });
  for (const end of /** @type {const} */ (["pointerup", "pointercancel"])) {
    area.addEventListener(end, (event) => pointers.delete(/** @type {PointerEvent} */ (event).pointerId));
  }
}
