// @ts-check
// The list of a robot's readings, which is updated in place.

import { arrange, create, setText } from "../../../ui/elements.js";

/** @import { Reading } from "./robot.js" */

export class Readings {
  element = create("dl", "ros-readings");
  /** By name. @type {Map<string, ReturnType<typeof createRow>>} */
  #rows = new Map();

  /** @param {Reading[]} readings */
  show(readings) {
    arrange(this.element, readings.map((reading) => {
      const row = this.#rows.get(reading.name) ?? createRow(reading);
      this.#rows.set(reading.name, row);
      row.show(reading);
      return row.element;
    }));
  }
}

/** @param {Reading} first */
function createRow({ name, level, color }) {
  const dot = create("span", "ros-dot");
  const text = create("span", "");
  const value = create("dd", "", text);
  if (color !== undefined) value.prepend(dot);
  const meter = create("span", "ros-level");
  const fill = create("i", "");
  meter.append(fill);
  if (level !== undefined) value.append(meter);
  return {
    element: create("div", "", create("dt", "", name), value),
    show(/** @type {Reading} */ reading) {
      setText(text, reading.text);
      dot.style.setProperty("--dot", reading.color || "transparent");
      const share = Math.max(-1, Math.min(1, reading.level ?? 0));
      fill.style.insetInlineStart = `${50 + Math.min(share, 0) * 50}%`;
      fill.style.inlineSize = `${Math.abs(share) * 50}%`;
    },
  };
}
