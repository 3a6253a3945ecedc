// @ts-check
// A row of the tree of diagnostics: a group that can be opened, or a status.

import { button, create, pressAnywhere, setText } from "../../ui/elements.js";
import { say } from "../../ui/words.js";
import { createSign } from "./level.js";

/** @import { Branch } from "./statusTree.js" */

export class Row {
  #open;
  #pick;
  #sign = createSign();
  #message = create("small", "");
  element;

  /** @param {string} path @param {{choose: () => void, open: (on: boolean) => void}} press */
  constructor(path, { choose, open }) {
    this.#open = button("", "ros-fold", () => open(this.#open.getAttribute("aria-expanded") !== "true"));
    this.#open.setAttribute("aria-label", say("Show what {} contains", path));
    this.#pick = button("", "ros-pick", choose);
    this.element = create("li", "ros-diagnostic", this.#open, this.#pick, this.#sign.element, this.#message);
    pressAnywhere(this.element, this.#pick);
    // The click that opens a group does not choose it.
    this.#open.addEventListener("click", (event) => event.stopPropagation());
  }

  /** @param {Branch} branch @param {{depth: number, open: boolean, chosen: boolean}} how */
  update({ name, status, level, children }, { depth, open, chosen }) {
    this.element.dataset.depth = String(Math.min(depth, 6));
    this.#open.toggleAttribute("disabled", children.size === 0);
    this.#open.setAttribute("aria-expanded", String(open && children.size > 0));
    setText(this.#pick, name);
    this.#pick.setAttribute("aria-pressed", String(chosen));
    this.#sign.show(level);
    setText(this.#message, status?.message.slice(0, 300) ?? "");
  }
}
