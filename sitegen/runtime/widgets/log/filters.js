// @ts-check
// The filters of the log: least severity, node and text.

import { create } from "../../ui/elements.js";
import { say } from "../../ui/words.js";
import { LEVELS } from "./entries.js";

/** @import { Shared } from "../../protocol.js" */
/** @import { Entry } from "./entries.js" */

const FIRST = "info";

export class Filters {
  #severity = create("select", "", ...LEVELS.map(([, name]) => new Option(say("{} and above", name), name)));
  #node = create("select", "", new Option(say("all nodes"), ""));
  #text = create("input", "");
  controls = [this.#severity, this.#node, this.#text];

  /** @param {() => void} changed */
  constructor(changed) {
    this.#severity.value = FIRST;
    this.#severity.setAttribute("aria-label", say("severity"));
    this.#node.setAttribute("aria-label", say("node"));
    this.#text.type = "search";
    this.#text.placeholder = say("Find text");
    this.#text.setAttribute("aria-label", say("text"));
    for (const control of this.controls) control.addEventListener("input", changed);
  }

  /** Whether all filters admit `entry`. @param {Entry} entry */
  admit({ level, node, text }) {
    const least = LEVELS.find(([, name]) => name === this.#severity.value)?.[0] ?? 0;
    const wanted = this.#text.value.trim().toLowerCase();
    return level >= least && (!this.#node.value || node === this.#node.value) &&
      (!wanted || text.toLowerCase().includes(wanted));
  }

  /** Admit entries of this severity, if they were not. @param {string} severity */
  admitFrom(severity) {
    const order = LEVELS.map(([, name]) => /** @type {string} */ (name));
    if (order.indexOf(severity) >= order.indexOf(this.#severity.value)) return;
    this.#severity.value = severity;
    this.#severity.dispatchEvent(new Event("input"));
  }

  /** Offer to show only the entries of `node`. @param {string} node */
  offer(node) {
    if (![...this.#node.options].some(({ value }) => value === node)) this.#node.append(new Option(node));
  }

  /** What a link carries of the filters. */
  read() {
    const severity = this.#severity.value === FIRST ? "" : this.#severity.value;
    return { severity, node: this.#node.value, text: this.#text.value.trim() };
  }

  /** @param {Shared} state as `read` returned it @param {() => void} odd called for an unknown severity */
  restore({ severity, node, text }, odd) {
    if (LEVELS.some(([, name]) => name === severity)) this.#severity.value = severity;
    else if (severity) odd();
    if (node) {
      this.offer(node);
      this.#node.value = node;
    }
    this.#text.value = text ?? "";
  }
}
