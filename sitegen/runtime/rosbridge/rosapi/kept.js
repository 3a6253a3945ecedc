// @ts-check
// Parameters without a node, which one client keeps as the parameter server of ROS 1 did.

import { MOST_NAMES } from "../limits.js";
import { Mistake } from "../mistake.js";

/** Characters of all values in JSON: a description of a robot has some hundred thousand. */
const MOST = 4_000_000;

export class Kept {
  /** In JSON, by name. @type {Map<string, string>} */
  #values = new Map();
  #size = 0;

  names() {
    return [...this.#values.keys()];
  }

  /** @param {string} name */
  get(name) {
    const text = this.#values.get(name);
    return text === undefined ? undefined : JSON.parse(text);
  }

  /** @param {string} name @param {any} value undefined to remove it */
  set(name, value) {
    const text = value === undefined ? "" : JSON.stringify(value);
    const before = this.#values.get(name);
    if (value === undefined && before === undefined) throw new Mistake(`parameter ${name} is not set`);
    const size = this.#size + text.length - (before?.length ?? 0);
    if (size > MOST) throw new Mistake(`parameters without a node have at most ${MOST} characters together`);
    if (before === undefined && this.#values.size >= MOST_NAMES) throw new Mistake("too many parameters without a node");
    this.#size = size;
    if (value === undefined) this.#values.delete(name);
    else this.#values.set(name, text);
  }
}
