// @ts-check
// The health of the robot, from diagnostic_msgs/msg/DiagnosticArray: a tree by name, and the values of one status.

import { TopicReader } from "../messages/topicReader.js";
import { arrange, button, create, setText } from "../ui/elements.js";
import { whileNear } from "../ui/looking.js";
import { say } from "../ui/words.js";
import { Detail } from "./diagnostics/detail.js";
import { LEVELS, createSign } from "./diagnostics/level.js";
import { Row } from "./diagnostics/row.js";
import { MOST, StatusTree } from "./diagnostics/statusTree.js";

/** @import { Ros } from "../protocol.js" */
/** @import { Level } from "./diagnostics/level.js" */
/** @import { Branch } from "./diagnostics/statusTree.js" */

const TOPIC = "/diagnostics";
// An aggregator sorts the statuses into groups.
const AGGREGATED = "/diagnostics_agg";
const DEPTH = 50;
// How often a status may have become stale (ms).
const BEAT = 1000;

/**
 * Show the statuses of `topic`; without it, those of an aggregator if there is one, else of /diagnostics.
 * @param {HTMLElement} element
 * @param {Ros} ros
 * @param {{topic?: string | null}} options
 * @returns {() => void} unmount
 */
export function mount(element, ros, { topic }) {
  const panel = new DiagnosticsPanel(ros, topic ?? "");
  element.replaceChildren(...panel.elements);
  ros.keep(element, { level: "string", status: "string" }, () => panel.read(), (state, odd) => panel.restore(state, odd));
  const unlook = whileNear(element, () => panel.begin());
  return () => {
    unlook();
    element.replaceChildren();
  };
}

class DiagnosticsPanel {
  #ros;
  #topic;
  /** @type {TopicReader | undefined} */
  #reader;
  #tree = new StatusTree();
  /** @type {Map<string, Row>} */
  #rows = new Map();
  /** Groups that the visitor opened or closed, by path. @type {Map<string, boolean>} */
  #opened = new Map();
  /** The level that is shown alone, or "". @type {Level | ""} */
  #only = "";
  #chosen = "";
  #frame = 0;
  #list = create("ul", "ros-diagnostic-list");
  #hint = create("p", "ros-hint");
  #note = create("p", "ros-note");
  #detail = new Detail();
  /** @type {Map<Level, {press: HTMLButtonElement, count: HTMLElement}>} */
  #filters = new Map();
  elements;

  /** @param {Ros} ros @param {string} topic */
  constructor(ros, topic) {
    this.#ros = ros;
    this.#topic = topic;
    const filters = create("div", "ros-controls ros-levels");
    filters.setAttribute("role", "group");
    filters.setAttribute("aria-label", say("show only"));
    for (const level of LEVELS) filters.append(this.#createFilter(level));
    const bar = create("div", "ros-bar", create("span", "ros-title", say("Diagnostics")), filters);
    const list = create("div", "ros-list", this.#list, this.#hint, this.#note);
    this.elements = [bar, create("div", "ros-split", list, this.#detail.element)];
    this.#draw();
  }

  read() {
    return { level: this.#only, status: this.#chosen };
  }

  /** @param {Record<string, any>} state @param {() => void} odd */
  restore({ level, status }, odd) {
    const known = LEVELS.find((one) => one === level);
    if (known) this.#only = known;
    else if (level) odd();
    this.#chosen = status ?? "";
    this.#draw();
  }

  /** Subscribe while the panel is visible. @returns {() => void} end it */
  begin() {
    const look = () => this.#look();
    look();
    this.#ros.graph.addEventListener("change", look);
    const timer = setInterval(() => this.#redraw(), BEAT);
    return () => {
      this.#ros.graph.removeEventListener("change", look);
      clearInterval(timer);
      this.#reader?.close();
      cancelAnimationFrame(this.#frame);
      this.#frame = 0;
    };
  }

  #look() {
    const published = (/** @type {string} */ topic) =>
      this.#ros.graph.topics().some(({ name, publishers }) => name === topic && publishers.length > 0);
    const topic = this.#topic || (published(AGGREGATED) ? AGGREGATED : TOPIC);
    if (topic !== this.#reader?.topic) {
      this.#reader?.close();
      this.#reader = new TopicReader(this.#ros, topic, (message) => this.#receive(message), DEPTH);
      this.#tree.clear();
    }
    this.#reader.look(true);
    this.#redraw();
  }

  /** @param {any} message */
  #receive(message) {
    this.#tree.add(message?.status, performance.now());
    this.#redraw();
  }

  #redraw() {
    this.#frame ||= requestAnimationFrame(() => this.#draw());
  }

  #draw() {
    this.#frame = 0;
    this.#tree.grade(performance.now());
    /** @type {Row[]} */
    const shown = [];
    for (const branch of this.#tree.roots) this.#show(branch, 0, shown);
    const paths = new Set(this.#tree.paths);
    for (const path of this.#rows.keys()) if (!paths.has(path)) this.#rows.delete(path);
    arrange(this.#list, shown.map(({ element }) => element));
    for (const [level, { press, count }] of this.#filters) {
      setText(count, String(this.#tree.counts[level]));
      press.setAttribute("aria-pressed", String(level === this.#only));
    }
    this.#detail.show(this.#tree.find(this.#chosen));
    this.#hint.hidden = shown.length > 0;
    const none = this.#tree.size ? say("No status of this level") : this.#reader?.describeSilence() ?? "";
    setText(this.#hint, none);
    setText(this.#note, this.#tree.full ? say("Only the first {} statuses are shown", MOST) : "");
  }

  /** Add the rows of a branch and, if it is open, of what it contains. @param {Branch} branch @param {number} depth @param {Row[]} rows */
  #show(branch, depth, rows) {
    if (this.#only && !branch.levels.has(this.#only)) return;
    // What is wrong is in sight from the beginning.
    const open = this.#opened.get(branch.path) ?? (Boolean(this.#only) || branch.level !== "ok");
    const row = this.#rows.get(branch.path) ?? new Row(branch.path, {
      choose: () => this.#choose(branch.path),
      open: (on) => {
        this.#opened.set(branch.path, on);
        this.#draw();
      },
    });
    this.#rows.set(branch.path, row);
    row.update(branch, { depth, open, chosen: branch.path === this.#chosen });
    rows.push(row);
    if (open) for (const child of branch.children.values()) this.#show(child, depth + 1, rows);
  }

  /** @param {string} path */
  #choose(path) {
    this.#chosen = path === this.#chosen ? "" : path;
    this.#draw();
  }

  /** A button that shows the statuses of one level only. @param {Level} level */
  #createFilter(level) {
    const sign = createSign();
    const count = create("span", "ros-count");
    const press = button("", "ros-level", () => {
      this.#only = this.#only === level ? "" : level;
      this.#draw();
    });
    sign.show(level);
    press.append(sign.element, count);
    this.#filters.set(level, { press, count });
    return press;
  }
}
