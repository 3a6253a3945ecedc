// @ts-check
// Whether a value is good or bad: a colour, a shape and a word.

import { shape } from "../../ui/drawing.js";
import { create, setText } from "../../ui/elements.js";
import { say } from "../../ui/words.js";

/**
 * @typedef {"good" | "caution" | "danger" | "plain"} Level
 * @typedef {{from: number, is: Level, text?: string | null}} Threshold it applies from `from` up to the next one
 */

const WORDS = { good: say("good"), caution: say("caution"), danger: say("danger"), plain: "" };
/** Different for those who do not see colours: a disc, a triangle, an octagon. @type {Record<Level, string>} */
const SHAPES = {
  good: "M 12 3 a 9 9 0 1 0 0.01 0 z",
  caution: "M 12 2.5 L 22.5 21 L 1.5 21 z",
  danger: "M 8 2.5 L 16 2.5 L 21.5 8 L 21.5 16 L 16 21.5 L 8 21.5 L 2.5 16 L 2.5 8 z",
  plain: "",
};

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
