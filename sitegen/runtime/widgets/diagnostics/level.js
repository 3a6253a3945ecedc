// @ts-check
// The levels of a diagnostic status: a colour, a shape and a word.

import { create, setText, shape } from "../../ui/elements.js";
import { SHAPES } from "../../ui/grades.js";

/** @typedef {"error" | "stale" | "warn" | "ok"} Level */

/** The worst first. @type {Level[]} */
export const LEVELS = ["error", "stale", "warn", "ok"];
/** By the numbers in diagnostic_msgs/msg/DiagnosticStatus. @type {Level[]} */
const BY_NUMBER = ["ok", "warn", "error", "stale"];
/** The words of ROS, in all languages. @type {Record<Level, string>} */
const WORDS = { error: "ERROR", stale: "STALE", warn: "WARN", ok: "OK" };
const GRADES = /** @type {const} */ ({ error: "danger", stale: "stale", warn: "caution", ok: "good" });

/** @param {unknown} number @returns {Level} */
export function levelOf(number) {
  return BY_NUMBER[Number(number)] ?? "error";
}

/** @param {Level} one @param {Level} other */
export function worse(one, other) {
  return LEVELS.indexOf(one) < LEVELS.indexOf(other) ? one : other;
}

/** Create a sign that shows a level. */
export function createSign() {
  const path = shape("path", { "fill-rule": "evenodd" });
  const word = create("span", "");
  const element = create("span", "ros-health", shape("svg", { viewBox: "0 0 24 24", "aria-hidden": "true" }, path), word);
  return {
    element,
    /** @param {Level} level */
    show(level) {
      if (element.dataset.level !== level) {
        element.dataset.level = level;
        path.setAttribute("d", SHAPES[GRADES[level]]);
      }
      setText(word, WORDS[level]);
    },
  };
}
