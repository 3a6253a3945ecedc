// @ts-check
// Whether a value is good or bad: a colour, a shape and a word.

import { create, setText, shape } from "../../ui/elements.js";
import { SHAPES } from "../../ui/grades.js";
import { say } from "../../ui/words.js";

/**
 * @typedef {"good" | "caution" | "danger" | "plain"} Level
 * @typedef {{from: number, is: Level, text?: string | null}} Threshold it applies from `from` up to the next one
 */

const WORDS = { good: say("good"), caution: say("caution"), danger: say("danger"), plain: "" };

/** The threshold that applies to a value. @param {number} value @param {Threshold[]} thresholds */
export function stateOf(value, thresholds) {
  return thresholds.findLast(({ from }) => value >= from);
}

/** The shape and the word of a state. */
export class StateSign {
  #path = shape("path");
  #text = create("span", "");
  element;

  constructor() {
    const sign = shape("svg", { viewBox: "0 0 24 24", "aria-hidden": "true" }, this.#path);
    this.element = create("p", "ros-grade", sign, this.#text);
    this.element.setAttribute("role", "status");
  }

  /** @param {Threshold | undefined} state */
  show(state) {
    const level = state?.is ?? "plain";
    const word = state ? state.text || WORDS[level] : "";
    this.element.hidden = !word;
    if (this.element.dataset.level !== level) {
      this.element.dataset.level = level;
      this.#path.setAttribute("d", SHAPES[level]);
    }
    setText(this.#text, word);
  }
}
