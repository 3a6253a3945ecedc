// @ts-check
// The frames as a table: parent, publisher, rate and age.

import { now } from "../../protocol.js";
import { arrange, create, setText } from "../../ui/elements.js";
import { say } from "../../ui/words.js";

/** @import { FrameSources } from "./sources.js" */
/** @import { Transforms } from "./transforms.js" */

export class FrameTable {
  /** @type {Map<string, {row: HTMLTableRowElement, cells: HTMLTableCellElement[]}>} */
  #rows = new Map();
  #body = create("tbody", "");
  element;

  constructor() {
    const titles = [say("Frame"), say("Parent"), say("Publisher"), say("Rate"), say("Age")].map((text) => {
      const cell = create("th", "", text);
      cell.scope = "col";
      return cell;
    });
    const table = create("table", "ros-table", create("thead", "", create("tr", "", ...titles)), this.#body);
    this.element = create("div", "ros-list ros-frames", table);
    // What scrolls has to be reached by keys.
    this.element.tabIndex = 0;
    this.element.setAttribute("role", "region");
    this.element.setAttribute("aria-label", say("all frames"));
  }

  /** @param {string[]} frames @param {Transforms} transforms @param {FrameSources} sources */
  show(frames, transforms, sources) {
    this.element.hidden = frames.length === 0;
    for (const frame of this.#rows.keys()) if (!frames.includes(frame)) this.#rows.delete(frame);
    const time = now();
    arrange(this.#body, frames.map((frame) => {
      const { row, cells } = this.#row(frame);
      const source = sources.about(frame, time);
      const fixed = transforms.about(frame)?.fixed;
      const texts = [
        transforms.parentOf(frame) ?? "–",
        source?.node || "–",
        !source ? "–" : fixed ? say("fixed") : `${source.hertz.toFixed(1)} Hz`,
        !source ? "–" : `${Math.max(0, source.age).toFixed(1)} s`,
      ];
      texts.forEach((text, index) => setText(/** @type {Element} */ (cells[index]), text));
      return row;
    }));
  }

  /** @param {string} frame */
  #row(frame) {
    let found = this.#rows.get(frame);
    if (!found) {
      const head = create("th", "", frame);
      head.scope = "row";
      const cells = Array.from({ length: 4 }, () => create("td", ""));
      found = { row: create("tr", "", head, ...cells), cells };
      this.#rows.set(frame, found);
    }
    return found;
  }
}
