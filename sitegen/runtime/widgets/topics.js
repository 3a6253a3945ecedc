// @ts-check
// A table of the topics of the page, and the messages of one of them.

import { isHidden, isShown } from "../graphNames.js";
import { Echo } from "../messages/echo.js";
import { arrange, create, setText, toggle } from "../ui/elements.js";
import { whileNear } from "../ui/looking.js";
import { say } from "../ui/words.js";
import { HEADINGS, Row } from "./topics/row.js";

/** @import { Ros } from "../protocol.js" */
/** @import { Topic } from "./topics/row.js" */

// The time between updates of the rates (ms).
const REFRESH = 500;
const NONE = say("No topics now. They appear when nodes start.");
const ALL_HIDDEN = say("Only hidden topics now.");

/**
 * Show all topics, or only those in `show`, and at first the messages of `echo`.
 * @param {HTMLElement} element
 * @param {Ros} ros
 * @param {{show?: string[] | null, echo?: string | null}} options
 * @returns {() => void} unmount
 */
export function mount(element, ros, { show, echo }) {
  const table = new TopicTable(ros, show ?? null);
  element.replaceChildren(...table.elements);
  const first = echo ?? "";
  if (first) table.choose(first);
  const read = () => ({ topic: table.chosen === first ? "" : table.chosen || "none", hidden: table.hidden });
  ros.keep(element, { topic: "string", hidden: "boolean" }, read, ({ topic, hidden }, odd) => {
    // A link chooses among what the visitor could choose.
    if (topic && topic !== "none" && show && ![...show, echo].includes(topic)) odd();
    else if (topic) table.choose(topic === "none" ? "" : topic);
    if (hidden) table.showHidden();
  });
  const unlook = whileNear(element, () => table.begin());
  return () => {
    unlook();
    element.replaceChildren();
  };
}

class TopicTable {
  #ros;
  #show;
  hidden = false;
  /** The topic whose messages are shown, or "". */
  chosen = "";
  /** @type {Map<string, Row>} */
  #rows = new Map();
  #all = toggle(say("Show hidden"), (on) => {
    this.hidden = on;
    this.#look();
  });
  #body = create("tbody", "");
  #head = create("thead", "", create("tr", "", ...HEADINGS.map(createHeading)));
  #table = create("table", "ros-table", this.#head, this.#body);
  #hint = create("p", "ros-hint");
  #echo;
  elements;

  /** @param {Ros} ros @param {string[] | null} show */
  constructor(ros, show) {
    this.#ros = ros;
    this.#show = show;
    this.#echo = new Echo(ros);
    const bar = create("div", "ros-bar", create("span", "ros-title", say("Topics")));
    if (!show) bar.append(this.#all);
    const list = create("div", "ros-list", this.#table, this.#hint);
    this.elements = [bar, create("div", "ros-split", list, this.#echo.element)];
  }

  /** Show the messages of another topic. @param {string} topic or "" */
  choose(topic) {
    this.chosen = topic;
    this.#echo.choose(topic);
    for (const [name, { pick }] of this.#rows) pick.setAttribute("aria-pressed", String(name === topic));
  }

  showHidden() {
    this.#all.querySelector("input")?.click();
  }

  /** Subscribe and measure while the panel is visible. @returns {() => void} end it */
  begin() {
    const look = () => this.#look();
    look();
    this.#ros.graph.addEventListener("change", look);
    const endEcho = this.#echo.begin();
    const timer = setInterval(() => {
      for (const row of this.#rows.values()) row.measure();
    }, REFRESH);
    return () => {
      this.#ros.graph.removeEventListener("change", look);
      endEcho();
      clearInterval(timer);
      for (const row of this.#rows.values()) row.stop();
    };
  }

  #look() {
    const known = this.#ros.graph.topics();
    const topics = listed(known, this.#show, this.hidden);
    const names = new Set(topics.map(({ name }) => name));
    for (const [name, row] of this.#rows) {
      if (names.has(name)) continue;
      row.stop();
      this.#rows.delete(name);
    }
    arrange(this.#body, topics.flatMap((topic) => {
      const row = this.#rows.get(topic.name) ?? this.#createRow(topic.name);
      row.show(topic);
      return row.elements;
    }));
    this.#table.hidden = topics.length === 0;
    this.#hint.hidden = topics.length > 0;
    if (!this.#hint.hidden) setText(this.#hint, listed(known, null, true).length ? ALL_HIDDEN : NONE);
    this.#echo.look();
  }

  /** @param {string} name */
  #createRow(name) {
    const row = new Row(this.#ros, name, () => this.choose(name === this.chosen ? "" : name));
    row.pick.setAttribute("aria-pressed", String(name === this.chosen));
    this.#rows.set(name, row);
    return row;
  }
}

/** @param {readonly [text: string, meaning: string]} heading */
function createHeading([text, meaning]) {
  const heading = create("th", "", text);
  heading.scope = "col";
  heading.title = meaning;
  return heading;
}

/**
 * The topics to show: those in `show`, whether they exist or not, or else all but hidden ones.
 * @param {Topic[]} topics @param {string[] | null} show @param {boolean} hidden whether to include hidden ones
 */
function listed(topics, show, hidden) {
  const none = { types: [], publishers: [], subscriptions: [], missed: 0, mismatches: [] };
  if (show) return show.map((name) => topics.find((topic) => topic.name === name) ?? { name, ...none });
  // Topics that only panels use are not part of the robot.
  const used = topics.filter(({ publishers, subscriptions }) =>
    [...publishers, ...subscriptions].some((node) => !isHidden(node)));
  return hidden ? used : used.filter(({ name }) => isShown(name));
}
