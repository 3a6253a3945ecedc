// @ts-check
// The legend of a plot: each curve with its colour, its value, and buttons to hide or remove it.

import { arrange, create, setText } from "../../ui/elements.js";
import { numberText } from "../../ui/numbers.js";
import { tool } from "../../ui/toolbar.js";
import { say } from "../../ui/words.js";
import { X } from "../../vendor/icons.js";
import { COLOURS } from "./chart.js";

/** @import { Curve, Series } from "./curve.js" */

/**
 * @typedef {{element: HTMLElement, pick: HTMLButtonElement, value: HTMLElement}} Row
 * @typedef {{element: HTMLElement, text: HTMLElement}} Fault
 */

export class Legend {
  element = create("ul", "ros-key");
  /** @type {Map<Curve, Row>} */
  #rows = new Map();
  /** @type {Map<Series, Fault>} */
  #faults = new Map();
  #changed;
  #remove;

  /** @param {() => void} changed called when a curve is shown or hidden @param {(series: Series) => void} remove */
  constructor(changed, remove) {
    this.#changed = changed;
    this.#remove = remove;
    this.element.setAttribute("aria-label", say("curves and their values"));
  }

  /**
   * @param {Series[]} all @param {(series: Series) => string} describe why a series has no curves
   * @param {(curve: Curve) => number | undefined} valueOf
   */
  show(all, describe, valueOf) {
    const [rows, faults] = [new Map(), new Map()];
    const elements = all.flatMap((series) => {
      const curves = [...series.curves.values()];
      const found = curves.map((curve) => {
        const row = this.#rows.get(curve) ?? this.#createRow(curve, series);
        rows.set(curve, row);
        const value = valueOf(curve);
        setText(row.value, value === undefined ? "–" : numberText(value));
        return row.element;
      });
      const text = describe(series);
      if (!text) return found;
      const fault = this.#faults.get(series) ?? this.#createFault(series);
      faults.set(series, fault);
      setText(fault.text, text.includes(series.text) ? text : `${series.text}: ${text}`);
      fault.element.classList.toggle("ros-fault", Boolean(series.error));
      return [...found, fault.element];
    });
    [this.#rows, this.#faults] = [rows, faults];
    arrange(this.element, elements);
  }

  /** @param {Curve} curve @param {Series} series @returns {Row} */
  #createRow(curve, series) {
    const sign = create("span", `ros-series ros-series-${curve.number % COLOURS}`);
    sign.dataset.line = String(Math.floor(curve.number / COLOURS));
    const pick = create("button", "ros-curve", sign, create("span", "ros-path", curve.name));
    pick.type = "button";
    pick.title = say("Hide or show {}", curve.name);
    pick.setAttribute("aria-pressed", String(curve.shown));
    pick.addEventListener("click", () => {
      curve.shown = !curve.shown;
      pick.setAttribute("aria-pressed", String(curve.shown));
      this.#changed();
    });
    const value = create("span", "ros-value-now");
    return { element: create("li", "", pick, value, this.#createRemove(series)), pick, value };
  }

  /** @param {Series} series @returns {Fault} */
  #createFault(series) {
    const text = create("span", "");
    const content = create("span", "ros-path", text);
    return { element: create("li", "ros-silent", content, this.#createRemove(series)), text };
  }

  /** @param {Series} series */
  #createRemove(series) {
    const remove = tool(say("Remove {}", series.text), X, () => this.#remove(series));
    remove.classList.add("ros-remove-series");
    return remove;
  }
}
