// @ts-check
// Every topic of the page with what is on it, and the messages of one.

import { isHidden, isShown } from "../graphNames.js";
import { arrange, button, create, setText, toggle } from "../ui/elements.js";
import { whileSeen } from "../ui/looking.js";
import { createEcho } from "../messages/echo.js";
import { explain } from "../messages/mismatch.js";
import { Rate } from "../messages/rate.js";
import { now } from "../protocol.js";
import { say } from "../ui/words.js";

/** @import { Mismatch, Ros } from "../protocol.js" */

// How often rates are written, in milliseconds.
const REFRESH = 500;
// What a robot's own machinery talks on, which a list of topics leaves out at first.

const HEADINGS = /** @type {const} */ ([
  [say("Topic"), say("name and type")],
  [say("Pub"), say("number of publishers")],
  [say("Sub"), say("number of subscriptions")],
  [say("Rate"), say("messages and bytes per second, over the last five seconds")],
]);

// More of those who do not hear each other than this are counted, not listed.
const WARNINGS = 3;
const NONE = say("No topics now. They appear when nodes start.");
const ALL_HIDDEN = say("Only hidden topics now.");
const MISSED = say("Messages replaced by newer ones before a subscription took them");
const compact = new Intl.NumberFormat("en", { notation: "compact" });

/**
 * @typedef {{name: string, types: string[], publishers: string[], subscriptions: string[],
 *   missed: number, mismatches: Mismatch[]}} Topic
 * @typedef {{elements(): HTMLElement[], pick: HTMLButtonElement, show(topic: Topic): void,
 *   measure(): void, stop(): void}} Row
 */

/**
 * Show the topics, or those named in `show` only; `echo` is the one whose messages are shown at first.
 * @param {HTMLElement} element
 * @param {Ros} ros
 * @param {{show?: string[] | null, echo?: string | null}} options
 * @returns {() => void} unmount
 */
export function mount(element, ros, { show, echo: first }) {
  let hidden = false;
  let chosen = "";
  /** @type {Map<string, Row>} */
  const rows = new Map();

  const bar = create("div", "ros-bar", create("span", "ros-title", say("Topics")));
  const all = toggle(say("Show hidden"), (on) => {
    hidden = on;
    look();
  });
  if (!show) bar.append(all);
  const body = create("tbody", "");
  const headings = HEADINGS.map(([text, meaning]) => {
    const heading = create("th", "", text);
    heading.scope = "col";
    heading.title = meaning;
    return heading;
  });
  const table = create("table", "ros-table", create("thead", "", create("tr", "", ...headings)), body);
  const hint = create("p", "ros-hint");
  const list = create("div", "ros-list", table, hint);
  const echo = createEcho(ros);
  element.replaceChildren(bar, create("div", "ros-split", list, echo.element));

  /** @param {string} name */
  const choose = (name) => {
    chosen = name === chosen ? "" : name;
    echo.choose(chosen);
    for (const [topic, { pick }] of rows) pick.setAttribute("aria-pressed", String(topic === chosen));
  };

  const look = () => {
    const there = ros.graph.topics();
    const topics = listed(there, show ?? null, hidden);
    const names = topics.map(({ name }) => name);
    for (const [name, row] of rows) {
      if (names.includes(name)) continue;
      row.stop();
      rows.delete(name);
    }
    for (const topic of topics) {
      let row = rows.get(topic.name);
      if (!row) {
        row = createRow(ros, topic.name, () => choose(topic.name));
        row.pick.setAttribute("aria-pressed", String(topic.name === chosen));
        rows.set(topic.name, row);
      }
      row.show(topic);
    }
    arrange(body, names.flatMap((name) => rows.get(name)?.elements() ?? []));
    table.hidden = names.length === 0;
    hint.hidden = names.length > 0;
    if (!hint.hidden) setText(hint, listed(there, null, true).length ? ALL_HIDDEN : NONE);
    echo.look();
  };

  if (first) choose(first);
  const read = () => ({ topic: chosen === (first ?? "") ? "" : chosen || "none", hidden });
  ros.keep(element, { topic: "string", hidden: "boolean" }, read, (state) => {
    if (state.topic === "none") choose(chosen);
    else if (state.topic && state.topic !== chosen) choose(state.topic);
    if (state.hidden) all.querySelector("input")?.click();
  });
  const unlook = whileSeen(element, () => {
    look();
    ros.graph.addEventListener("change", look);
    const stopEcho = echo.begin();
    const timer = setInterval(() => {
      for (const row of rows.values()) row.measure();
    }, REFRESH);
    return () => {
      ros.graph.removeEventListener("change", look);
      stopEcho();
      clearInterval(timer);
      for (const row of rows.values()) row.stop();
    };
  });
  return () => {
    unlook();
    element.replaceChildren();
  };
}

/**
 * The topics that the panel shows: all but the hidden ones, or those of `show`, there or not.
 * @param {Topic[]} topics @param {string[] | null} show @param {boolean} hidden
 */
function listed(topics, show, hidden) {
  const none = { types: [], publishers: [], subscriptions: [], missed: 0, mismatches: [] };
  if (show) return show.map((name) => topics.find((topic) => topic.name === name) ?? { name, ...none });
  // What only panels ask for is nothing of the robot.
  const used = topics.filter(({ publishers, subscriptions }) => [...publishers, ...subscriptions].some((node) => !isHidden(node)));
  if (hidden) return used;
  return used.filter(({ name }) => isShown(name));
}

/** @param {Ros} ros @param {string} name @param {() => void} choose @returns {Row} */
function createRow(ros, name, choose) {
  const pick = button(name, "ros-pick", choose);
  const type = create("small", "");
  const head = create("th", "", pick, type);
  head.scope = "row";
  const from = create("td", "");
  const listening = create("span", "");
  const lost = create("small", "");
  const to = create("td", "", listening, lost);
  const rate = create("span", "");
  const bandwidth = create("small", "");
  const element = create("tr", "", head, from, to, create("td", "", rate, bandwidth));
  const warnings = create("td", "");
  warnings.colSpan = HEADINGS.length;
  const below = create("tr", "ros-warnings", warnings);
  let measure = new Rate();
  let measured = "";
  let unsubscribe = () => {};

  const stop = () => {
    unsubscribe();
    unsubscribe = () => {};
    measured = "";
    measure = new Rate();
    setText(rate, "–");
    setText(bandwidth, "");
  };
  stop();

  return {
    elements: () => (warnings.hasChildNodes() ? [element, below] : [element]),
    pick,
    stop,
    show({ types, publishers, subscriptions, missed, mismatches }) {
      setText(type, types.join(", "));
      const listeners = subscriptions.filter((node) => !isHidden(node));
      setText(from, String(publishers.length));
      from.title = publishers.join(", ");
      setText(listening, String(listeners.length));
      listening.title = listeners.join(", ");
      setText(lost, missed ? say("{} missed", compact.format(missed)) : "");
      lost.title = MISSED;
      warn(warnings, mismatches.filter((pair) => !isHidden(pair.publisher) && !isHidden(pair.subscription)));
      element.classList.toggle("ros-idle", !publishers.length);
      const wanted = publishers.length ? (types[0] ?? "") : "";
      if (wanted === measured) return;
      stop();
      measured = wanted;
      if (!wanted) return;
      // Best effort and volatile suits every publisher.
      const qos = { depth: 1000, reliable: false, transientLocal: false };
      unsubscribe = ros.subscribeBytes(name, wanted, (_, info) => {
        measure.add(info.timestamp, info.size);
      }, qos);
    },
    measure() {
      const { hertz, bytes } = measure.read(now());
      setText(rate, hertz ? `${rounded(hertz)} Hz` : "–");
      setText(bandwidth, bytes ? size(bytes) : "");
    },
  };
}

/** Say who does not hear whom. @param {Element} element @param {Mismatch[]} mismatches */
function warn(element, mismatches) {
  const texts = [...new Set(mismatches.map(explain))];
  const more = texts.length - WARNINGS;
  const shown = [...texts.slice(0, WARNINGS), ...(more > 0 ? [say("and {} more", more)] : [])];
  if (shown.join() === [...element.children].map((child) => child.textContent).join()) return;
  element.replaceChildren(...shown.map((text) => create("p", "", text)));
}

/** @param {number} bytes a second */
function size(bytes) {
  if (bytes < 1000) return `${Math.round(bytes)} B/s`;
  return bytes < 1e6 ? `${rounded(bytes / 1000)} kB/s` : `${rounded(bytes / 1e6)} MB/s`;
}

/** Three digits. @param {number} number */
function rounded(number) {
  return number.toFixed(number < 10 ? 2 : number < 100 ? 1 : 0);
}
