// @ts-check
// Messages in several parts.

import { Mistake } from "./mistake.js";
import { LONGEST_ID, MOST_FRAGMENTS, MOST_PARTIAL, MOST_TEXT } from "./limits.js";

/** Puts the fragments of a client's messages together. */
export class Fragments {
  /**
   * By id, in the order of their begin.
   * @type {Map<unknown, {parts: string[], left: number, size: number, total: number}>}
   */
  #partial = new Map();

  /** Return the message, once all its fragments are there. @param {any} message @returns {any} */
  add({ id, data, num, total }) {
    const named = typeof id === "string" ? id.length <= LONGEST_ID : typeof id === "number";
    const sound = named && typeof data === "string" &&
      Number.isInteger(num) && Number.isInteger(total) && total > 0 && total <= MOST_FRAGMENTS && num >= 0 && num < total;
    if (!sound) throw new Mistake(`fragment: it needs an id, data, num and total, which is at most ${MOST_FRAGMENTS}`);
    let one = this.#partial.get(id);
    if (!one) {
      // Those that came first are the least likely to be completed.
      for (const old of this.#partial.keys()) if (this.#partial.size >= MOST_PARTIAL) this.#partial.delete(old);
      one = { parts: [], left: total, size: 0, total };
      this.#partial.set(id, one);
    }
    if (one.total !== total) throw new Mistake("fragment: its total is not that of the first fragment");
    if (one.parts[num] !== undefined) return undefined;
    one.size += data.length;
    if (this.#size() > MOST_TEXT) {
      this.#partial.delete(id);
      throw new Mistake(`fragment: a message has at most ${MOST_TEXT} characters`);
    }
    one.parts[num] = data;
    one.left--;
    if (one.left) return undefined;
    this.#partial.delete(id);
    return one.parts.join("");
  }

  #size() {
    return [...this.#partial.values()].reduce((sum, { size }) => sum + size, 0);
  }
}

/**
 * Return a text in fragments of at most `size` characters; as it is if it is short enough.
 * @param {string} text @param {number} size @param {string} id @returns {string[]}
 */
export function inFragments(text, size, id) {
  if (!(size > 0) || text.length <= size) return [text];
  const step = Math.max(Math.floor(size) || 1, Math.ceil(text.length / MOST_FRAGMENTS));
  const total = Math.ceil(text.length / step);
  return Array.from({ length: total }, (_, num) =>
    JSON.stringify({ op: "fragment", id, data: text.slice(num * step, (num + 1) * step), num, total }));
}
