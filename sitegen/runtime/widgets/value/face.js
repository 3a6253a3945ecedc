// @ts-check
// What shows a value: a number, a gauge, a light or a text.

import { create, setText, shape } from "../../ui/elements.js";
import { numberText } from "../../ui/numbers.js";
import { say } from "../../ui/words.js";

/** @import { Threshold } from "./state.js" */

/**
 * @typedef {"number" | "gauge" | "light" | "text"} Show
 * @typedef {{unit?: string | null, decimals?: number | null, min?: number | null, max?: number | null,
 *   thresholds?: Threshold[] | null}} Look
 * @typedef {{element: HTMLElement, show(value: number | string, state: Threshold | undefined): void}} Face
 */

// The longest text (characters).
const LONGEST = 1000;
const RADIUS = 80;
const GAUGE = { viewBox: "0 0 200 112" };

/** @param {Show} kind @param {Look} look @returns {Face} */
export function createFace(kind, look) {
  if (kind === "gauge") return createGauge(look);
  if (kind === "light") return createLight();
  return kind === "text" ? createText() : createNumber(look);
}

/** @param {Look} look @returns {Face} */
function createNumber(look) {
  const number = create("span", "ros-number");
  const element = create("p", "ros-figure", number);
  if (look.unit) element.append(" ", create("span", "ros-unit", look.unit));
  return {
    element,
    show(value, state) {
      setText(number, textOf(value, look));
      element.dataset.level = state?.is ?? "plain";
    },
  };
}

/** @returns {Face} */
function createText() {
  const element = create("p", "ros-figure ros-words");
  return {
    element,
    show(value) {
      const text = typeof value === "number" ? numberText(value) : value;
      setText(element, text.length > LONGEST ? `${text.slice(0, LONGEST)}…` : text || say("(empty text)"));
    },
  };
}

/** @returns {Face} */
function createLight() {
  const lamp = create("span", "ros-lamp");
  const word = create("span", "");
  const element = create("p", "ros-figure ros-switch-state", lamp, word);
  return {
    element,
    show(value, state) {
      const on = typeof value === "number" && value !== 0 && !Number.isNaN(value);
      lamp.dataset.on = String(on);
      element.dataset.level = state?.is ?? (on ? "good" : "plain");
      setText(word, on ? say("on") : say("off"));
    },
  };
}

/** @param {Look} look @returns {Face} */
function createGauge(look) {
  const { min, max } = { min: look.min ?? 0, max: look.max ?? 100 };
  const share = (/** @type {number} */ value) => Math.min(Math.max((value - min) / (max - min), 0), 1);
  const track = shape("path", { class: "ros-track", d: arc(0, 1, RADIUS) });
  const filled = shape("path", { class: "ros-filled" });
  const thresholds = look.thresholds ?? [];
  const ranges = thresholds.map(({ from, is }, index) => {
    const to = thresholds[index + 1]?.from ?? max;
    const range = shape("path", { class: "ros-range", d: arc(share(from), share(to), RADIUS + 14) });
    range.setAttribute("data-level", is);
    return range;
  });
  const ends = [min, max].map((end, index) => {
    const text = shape("text", { x: index ? 180 : 20, y: 110, "text-anchor": "middle" });
    text.textContent = numberText(end);
    return text;
  });
  const drawing = shape("svg", { ...GAUGE, "aria-hidden": "true" }, track, ...ranges, filled, ...ends);
  const number = createNumber(look);
  const element = create("div", "ros-gauge", create("div", "ros-dial"), number.element);
  element.firstElementChild?.append(drawing);
  element.setAttribute("role", "meter");
  element.setAttribute("aria-label", say("gauge"));
  element.setAttribute("aria-valuemin", String(min));
  element.setAttribute("aria-valuemax", String(max));
  return {
    element,
    show(value, state) {
      number.show(value, state);
      const part = typeof value === "number" && !Number.isNaN(value) ? share(value) : 0;
      filled.setAttribute("d", part > 0 ? arc(0, part, RADIUS) : "");
      element.dataset.level = state?.is ?? "plain";
      element.setAttribute("aria-valuenow", String(min + part * (max - min)));
      element.setAttribute("aria-valuetext", `${textOf(value, look)} ${look.unit ?? ""}`.trim());
    },
  };
}

/** A part of the half circle of a gauge, as a path. @param {number} from share @param {number} to @param {number} radius */
function arc(from, to, radius) {
  const point = (/** @type {number} */ part) => {
    const angle = Math.PI * (1 - part);
    return `${(100 + radius * Math.cos(angle)).toFixed(2)} ${(98 - radius * Math.sin(angle)).toFixed(2)}`;
  };
  return `M ${point(from)} A ${radius} ${radius} 0 0 1 ${point(to)}`;
}

/** @param {number | string} value @param {Look} look */
function textOf(value, { decimals }) {
  if (typeof value === "string") return value;
  if (typeof decimals !== "number" || !(Math.abs(value) < 1e15)) return numberText(value);
  return value.toFixed(Math.min(Math.max(Math.round(decimals), 0), 10)).replace("-", "−");
}
