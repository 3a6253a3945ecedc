// @ts-check
// The log messages of all nodes, from /rosout, filtered by severity, node and text.

import { ROSOUT } from "../graphNames.js";
import { ROSOUT_QOS } from "../protocol.js";
import { create, setText } from "../ui/elements.js";
import { whileNear } from "../ui/looking.js";
import { plain } from "../ui/plain.js";
import { Tail } from "../ui/tail.js";
import { tool } from "../ui/toolbar.js";
import { say } from "../ui/words.js";
import { Eraser } from "../vendor/icons.js";
import { Entries, readEntry } from "./log/entries.js";
import { Filters } from "./log/filters.js";
import { Levels } from "./log/levels.js";

/** @import { Ros } from "../protocol.js" */
/** @import { Entry } from "./log/entries.js" */

const TYPE = "rcl_interfaces/msg/Log";

/**
 * Show the log, of which `lines` entries are kept.
 * @param {HTMLElement} element
 * @param {Ros} ros
 * @param {{lines?: number}} options
 * @returns {() => void} unmount
 */
export function mount(element, ros, { lines: limit = 1000 }) {
  const log = new Log(ros, limit);
  element.replaceChildren(...log.elements);
  const { filters } = log;
  ros.keep(element, { severity: "string", node: "string", text: "string" }, () => filters.read(), (state, odd) => {
    filters.restore(state, odd);
    log.redraw();
  });
  const unlook = whileNear(element, () => log.begin());
  return () => {
    unlook();
    element.replaceChildren();
  };
}

class Log {
  #ros;
  #limit;
  filters = new Filters(() => this.redraw());
  #rows = create("div", "ros-lines");
  #hint = create("p", "ros-hint");
  elements;
  #tail = new Tail(this.#rows);
  #entries;
  #levels;
  /** Entries that are not drawn yet, or "all" if they do not belong at the end. @type {Entry[] | "all"} */
  #fresh = [];
  #frame = 0;

  /** @param {Ros} ros @param {number} limit */
  constructor(ros, limit) {
    this.#ros = ros;
    this.#limit = limit;
    this.#entries = new Entries(limit);
    // Who asks a node for more lines wants to see them.
    this.#levels = new Levels(ros, (severity) => this.filters.admitFrom(severity));
    const clear = tool(say("Clear"), Eraser, () => {
      this.#entries.clear();
      this.redraw();
    });
    const controls = create("div", "ros-controls ros-filters", ...this.filters.controls, this.#levels.press, clear);
    const bar = create("div", "ros-bar", create("span", "ros-title", say("Log")), controls);
    this.#rows.setAttribute("role", "log");
    this.#rows.setAttribute("aria-label", say("log of all nodes"));
    this.#rows.tabIndex = 0;
    this.elements = [bar, this.#levels.element, create("div", "ros-logged", this.#rows, this.#hint)];
    this.#draw();
  }

  /** Subscribe while the panel is visible. @returns {() => void} end it */
  begin() {
    this.#draw();
    let unsubscribe = () => {};
    const look = () => {
      // A bag may bring the type later.
      if (!this.#ros.types[TYPE]) return;
      this.#ros.graph.removeEventListener("change", look);
      unsubscribe = this.#ros.subscribe(ROSOUT, TYPE, (message) => this.#add(readEntry(message)), ROSOUT_QOS);
    };
    this.#ros.graph.addEventListener("change", look);
    look();
    const endLevels = this.#levels.begin();
    return () => {
      endLevels();
      this.#ros.graph.removeEventListener("change", look);
      unsubscribe();
      cancelAnimationFrame(this.#frame);
      this.#frame = 0;
    };
  }

  /** Draw all entries again. */
  redraw() {
    this.#fresh = "all";
    this.#frame ||= requestAnimationFrame(() => this.#draw());
  }

  /** @param {Entry} entry */
  #add(entry) {
    const place = this.#entries.add(entry);
    if (!place) return;
    this.filters.offer(entry.node);
    this.#levels.offer(entry.node);
    if (this.#fresh === "all" || place === "between" || this.#fresh.length >= this.#limit) {
      this.redraw();
    } else {
      this.#fresh.push(entry);
      this.#frame ||= requestAnimationFrame(() => this.#draw());
    }
  }

  #draw() {
    this.#frame = 0;
    if (this.#fresh === "all") {
      this.#rows.replaceChildren();
      this.#fresh = this.#entries.list;
    }
    this.#rows.append(...this.#fresh.filter((entry) => this.filters.admit(entry)).map(createRow));
    this.#fresh = [];
    while (this.#rows.childElementCount > this.#limit) this.#rows.firstElementChild?.remove();
    this.#tail.follow();
    this.#hint.hidden = this.#rows.hasChildNodes();
    setText(this.#hint, this.#describeSilence());
  }

  #describeSilence() {
    if (!this.#ros.types[TYPE]) return say("No program on this page logs to /rosout");
    return this.#entries.list.length ? say("No lines match the filters") : say("Nothing logged yet");
  }
}

/** @param {Entry} entry */
function createRow({ time, severity, node, text }) {
  const at = new Date(time);
  const when = `${at.toTimeString().slice(0, 8)}.${String(at.getMilliseconds()).padStart(3, "0")}`;
  const row = create("div", "", create("span", "ros-when", when), ` ${severity.toUpperCase()} `);
  row.append(create("b", "", node), `: ${plain(text)}`);
  row.dataset.severity = severity;
  return row;
}
