// @ts-check
// The choice of the fixed frame.

import { create } from "../../ui/elements.js";
import { say } from "../../ui/words.js";

/** @import { World } from "./world.js" */

export class FrameChooser {
  #world;
  #select = create("select", "");
  element = create("div", "ros-frame", this.#select);
  /** The frame that the visitor has chosen, or "". */
  chosen = "";
  #shown = "";

  /** @param {World} world */
  constructor(world) {
    this.#world = world;
    this.#select.setAttribute("aria-label", say("Fixed frame"));
    this.#select.title = say("Fixed frame");
    this.#select.addEventListener("change", () => {
      this.chosen = this.#select.value;
      world.choose(this.chosen);
    });
    this.look();
  }

  /** Offer the frames that there are. */
  look() {
    const { fixed, transforms } = this.#world;
    const names = transforms.frames();
    if (!names.includes(fixed)) names.unshift(fixed);
    const list = JSON.stringify(names);
    if (list !== this.#shown) {
      this.#shown = list;
      this.#select.replaceChildren(...names.map((name) => new Option(name || say("none yet"), name)));
    }
    this.#select.value = fixed;
    this.element.hidden = names.length < 2 && !fixed;
  }
}
