// @ts-check
// Show a drawing that can be zoomed and moved: with wheel, fingers, keys or buttons.

import { button, create } from "./elements.js";
import { say } from "./words.js";

const SVG = "http://www.w3.org/2000/svg";
const STEP = 1.3;
const SMALLEST = 0.1;
const LARGEST = 4;
// How far an arrow key moves, in pixels; and what stays free around a drawing that fits.
const STRIDE = 48;
const MARGIN = 16;

/** @param {string} tag @param {Record<string, string | number>} attributes @param {Element[]} content */
export function shape(tag, attributes = {}, ...content) {
  const element = document.createElementNS(SVG, tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, String(value));
  element.append(...content);
  return element;
}

/**
 * An area for a drawing, and the buttons for it. What is drawn goes into `layer`; `resize` tells how
 * large that is, and fits it into the area unless the visitor looks at a part of it.
 * @returns {{element: HTMLElement, buttons: HTMLElement, svg: SVGElement, layer: SVGElement,
 *   resize(width: number, height: number): void, close(): void}}
 */
export function createDrawing() {
  const layer = shape("g");
  const svg = shape("svg", { tabindex: 0, role: "img" });
  svg.append(layer);
  const element = create("div", "ros-drawing", svg);

  let [width, height] = [1, 1];
  let view = { x: 0, y: 0, scale: 1 };
  let fitted = true;

  const apply = () => {
    layer.setAttribute("transform", `translate(${view.x} ${view.y}) scale(${view.scale})`);
    // A finger scrolls the page across a drawing that is seen whole, and moves one that is not.
    svg.style.touchAction = fitted ? "pan-x pan-y" : "none";
  };
  const fit = () => {
    const { clientWidth, clientHeight } = element;
    const scale = Math.min((clientWidth - 2 * MARGIN) / width, (clientHeight - 2 * MARGIN) / height, 1);
    fitted = true;
    view = {
      scale: Math.max(scale, SMALLEST),
      x: (clientWidth - width * scale) / 2,
      y: (clientHeight - height * scale) / 2,
    };
    apply();
  };
  const move = (/** @type {number} */ x, /** @type {number} */ y) => {
    view = { ...view, x: view.x + x, y: view.y + y };
    fitted = false;
    apply();
  };
  /** Zoom; the point of the area at x, y stays where it is. @param {number} factor @param {number} [x] @param {number} [y] */
  const zoom = (factor, x = element.clientWidth / 2, y = element.clientHeight / 2) => {
    const scale = Math.min(Math.max(view.scale * factor, SMALLEST), LARGEST);
    const by = scale / view.scale;
    view = { scale, x: x - (x - view.x) * by, y: y - (y - view.y) * by };
    fitted = false;
    apply();
  };

  svg.addEventListener("wheel", (event) => {
    // The page scrolls across a drawing that nobody has chosen.
    if (!event.ctrlKey && document.activeElement !== svg) return;
    event.preventDefault();
    zoom(Math.exp(-event.deltaY / (event.ctrlKey ? 100 : 500)), event.offsetX, event.offsetY);
  }, { passive: false });
  followPointers(svg, move, zoom);
  svg.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    /** @type {Record<string, () => void>} */
    const keys = {
      "+": () => zoom(STEP),
      "=": () => zoom(STEP),
      "-": () => zoom(1 / STEP),
      0: fit,
      ArrowLeft: () => move(STRIDE, 0),
      ArrowRight: () => move(-STRIDE, 0),
      ArrowUp: () => move(0, STRIDE),
      ArrowDown: () => move(0, -STRIDE),
    };
    const act = keys[event.key];
    if (!act) return;
    event.preventDefault();
    act();
  });
  const resized = new ResizeObserver(() => {
    if (fitted) fit();
  });
  resized.observe(element);

  const larger = button("+", "", () => zoom(STEP));
  larger.setAttribute("aria-label", say("Zoom in"));
  const smaller = button("−", "", () => zoom(1 / STEP));
  smaller.setAttribute("aria-label", say("Zoom out"));
  const whole = button(say("Fit"), "", fit);
  return {
    element,
    buttons: create("div", "ros-controls", larger, smaller, whole),
    svg,
    layer,
    resize(w, h) {
      [width, height] = [w, h];
      if (fitted) fit();
    },
    close: () => resized.disconnect(),
  };
}

/**
 * Move with one pointer; zoom with two.
 * @param {SVGElement} svg
 * @param {(x: number, y: number) => void} move
 * @param {(factor: number, x: number, y: number) => void} zoom
 */
function followPointers(svg, move, zoom) {
  /** Where each is. @type {Map<number, {x: number, y: number}>} */
  const pointers = new Map();
  svg.addEventListener("pointerdown", (event) => {
    svg.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, { x: event.offsetX, y: event.offsetY });
  });
  svg.addEventListener("pointermove", (event) => {
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
    svg.addEventListener(end, (event) => pointers.delete(event.pointerId));
  }
}
