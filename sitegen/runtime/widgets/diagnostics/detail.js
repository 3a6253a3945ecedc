// @ts-check
// One diagnostic status with its values.

import { arrange, create, setText } from "../../ui/elements.js";
import { say } from "../../ui/words.js";
import { createSign } from "./level.js";

/** @import { Branch } from "./statusTree.js" */

// Longer texts are cut.
const LONGEST = 2000;

export class Detail {
  #name = create("span", "ros-name");
  #sign = createSign();
  #message = create("p", "ros-ends");
  #values = create("tbody", "");
  #rows = new Map();
  #table = create("table", "ros-table ros-values", this.#values);
  #hint = create("p", "ros-hint", say("Choose a status to see its values"));
  #bar = create("div", "ros-bar", create("div", "ros-node", this.#name), this.#sign.element);
  element = create("div", "ros-detail", this.#bar, this.#message, create("div", "ros-list", this.#table), this.#hint);

  /** @param {Branch | undefined} branch */
  show(branch) {
    this.#hint.hidden = Boolean(branch);
    for (const element of [this.#bar, this.#message, this.#table]) element.hidden = !branch;
    if (!branch) return;
    const { status } = branch;
    setText(this.#name, branch.path);
    this.#sign.show(branch.level);
    const about = [status?.message, status?.hardware && say("hardware: {}", status.hardware)];
    setText(this.#message, about.filter(Boolean).join(" · ").slice(0, LONGEST));
    arrange(this.#values, (status?.values ?? []).map(({ key, value }, index) => this.#row(index, key, value)));
  }

  /** @param {number} index @param {string} key @param {string} value */
  #row(index, key, value) {
    let row = this.#rows.get(index);
    if (!row) {
      const head = create("th", "");
      head.scope = "row";
      row = create("tr", "", head, create("td", ""));
      this.#rows.set(index, row);
    }
    setText(row.children[0], key.slice(0, LONGEST));
    setText(row.children[1], value.slice(0, LONGEST));
    return row;
  }
}
