// @ts-check
// The filters of the log: least severity, node and text. In a narrow panel, a button opens them.

import { create } from "../../ui/elements.js";
import { setTool, tool } from "../../ui/toolbar.js";
import { say } from "../../ui/words.js";
import { ListFilter } from "../../vendor/icons.js";
import { LEVELS } from "./entries.js";

/** @import { Shared } from "../../protocol.js" */
/** @import { Entry } from "./entries.js" */

const FIRST = "info";
let panels = 0;

export class Filters {
  #severity = create("select", "", ...LEVELS.map(([, name]) => new Option(say("{} and above", name), name)));
  #node = create("select", "", new Option(say("all nodes"), ""));
  #text = create("input", "");
  #fields = create("div", "ros-filter-fields", this.#severity, this.#node, this.#text);
  #press = tool(say("Filters"), ListFilter, () => this.#open(this.#press.getAttribute("aria-expanded") !== "true"));
  controls = [this.#press, this.#fields];

  /** @param {() => void} changed */
  constructor(changed) {
    this.#press.classList.add("ros-filter-press");
    this.#fields.id = `ros-filter-fields-${panels += 1}`;
    this.#press.setAttribute("aria-controls", this.#fields.id);
    this.#open(false);
    this.#severity.value = FIRST;
    this.#severity.setAttribute("aria-label", say("severity"));
    this.#node.setAttribute("aria-label", say("node"));
    this.#text.type = "search";
    this.#text.placeholder = say("Find text");
    this.#text.setAttribute("aria-label", say("text"));
    this.#fields.addEventListener("input", () => {
      this.#mark();
      changed();
    });
  }

  /** @param {boolean} open */
  #open(open) {
    this.#press.setAttribute("aria-expanded", String(open));
  }

  /** Say at the button whether a visitor has set one of the filters. */
  #mark() {
    const active = Object.values(this.read()).some(Boolean);
    this.#press.classList.toggle("ros-active", active);
    setTool(this.#press, active ? say("Filters (active)") : say("Filters"), ListFilter);
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
    this.#severity.dispatchEvent(new Event("input", { bubbles: true }));
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
    this.#mark();
  }
}
