// @ts-check
// Show the messages of a topic as YAML, the newest at the end, as `ros2 topic echo` does.

import { isHidden, PAGE_NODE } from "../graphNames.js";
import { button, create, setText } from "../ui/elements.js";
import { toYaml } from "./yaml.js";
import { say } from "../ui/words.js";

/** @import { Ros } from "../protocol.js" */

// What is kept of the past, in messages; and how much of a long array or text is shown.
const HISTORY = 50;
const LENGTH = 32;
// A reader this near to the end, in pixels, is taken to read the newest message.
const NEAR = 24;

/**
 * `choose` says which topic; `begin` lets it work and returns what ends that; `look` is for changes of
 * the graph. Without a topic, or paused, it subscribes to nothing.
 * @param {Ros} ros
 * @returns {{element: HTMLElement, choose(topic: string): void, begin(): () => void, look(): void}}
 */
export function createEcho(ros) {
  const name = create("span", "ros-name");
  const kind = create("span", "ros-type");
  const pause = button(say("Pause"), "ros-pause", () => {
    paused = !paused;
    look();
  });
  const clear = button(say("Clear"), "ros-clear", () => {
    waiting = [];
    log.replaceChildren();
    look();
  });
  const controls = create("div", "ros-controls", pause, clear);
  const bar = create("div", "ros-bar", create("div", "ros-node", name, kind), controls);
  const ends = create("p", "ros-ends");
  const log = create("div", "ros-lines");
  log.setAttribute("role", "log");
  log.setAttribute("aria-live", "off"); // a topic never stops talking
  log.tabIndex = 0;
  const hint = create("p", "ros-hint");
  const element = create("div", "ros-echo", bar, ends, log, hint);

  let topic = "";
  let paused = false;
  let working = false;
  /** What is subscribed to now: the topic, its type and how. */
  let subscribed = "";
  let failure = "";
  /** @type {() => void} */
  let unsubscribe = () => {};
  /** @type {string[]} */
  let waiting = [];
  let frame = 0;
  let following = true;

  const draw = () => {
    frame = 0;
    const rows = waiting.map((text) => create("div", "", `${text}\n---`));
    waiting = [];
    log.append(...rows);
    while (log.childElementCount > HISTORY) log.firstElementChild?.remove();
    if (following) log.scrollTop = log.scrollHeight;
    hint.hidden = true;
  };

  /** @param {any} message @param {string} type */
  const receive = (message, type) => {
    waiting.push(toYaml(message, type, ros.types, LENGTH));
    if (waiting.length > HISTORY) waiting.shift();
    frame ||= requestAnimationFrame(draw);
  };

  const look = () => {
    const { type, publishers, subscriptions } = describe(ros, topic);
    setText(name, topic);
    setText(kind, type);
    setText(ends, topic ? `${list(publishers, say("no publishers"))} → ${list(subscriptions, say("no subscribers"))}` : "");
    log.setAttribute("aria-label", say("messages on {}", topic));
    setText(pause, paused ? say("Resume") : say("Pause"));
    controls.hidden = !topic;
    const known = Boolean(ros.types[type]);
    const qos = qosFor(ros, topic);
    const wanted = working && topic && known && !paused ? JSON.stringify([topic, type, qos]) : "";
    if (wanted !== subscribed) {
      unsubscribe();
      unsubscribe = () => {};
      failure = "";
      try {
        if (wanted) unsubscribe = ros.subscribe(topic, type, (message) => receive(message, type), qos);
      } catch (error) {
        failure = error instanceof Error ? error.message : String(error);
      }
      subscribed = wanted;
    }
    setText(hint, failure || hintFor(topic, type, known, publishers.length, paused));
    hint.hidden = log.hasChildNodes();
  };
  log.addEventListener("scroll", () => {
    following = log.scrollHeight - log.scrollTop - log.clientHeight < NEAR;
  });

  return {
    element,
    look,
    choose(chosen) {
      topic = chosen;
      paused = false;
      following = true;
      waiting = [];
      log.replaceChildren();
      look();
    },
    begin() {
      working = true;
      look();
      return () => {
        working = false;
        cancelAnimationFrame(frame);
        frame = 0;
        look();
      };
    },
  };
}

/** @param {string} topic @param {string} type @param {boolean} known @param {number} publishers @param {boolean} paused */
function hintFor(topic, type, known, publishers, paused) {
  if (!topic) return say("Choose a topic to read its messages");
  if (!type) return say("No node uses {} now. Messages appear here when a node publishes.", topic);
  if (!known) return say("This page has no definition of {}, so it cannot read these messages.", type);
  if (paused) return say("Paused");
  return publishers ? say("No message yet") : say("{} has no publishers now", topic);
}

/** @param {Ros} ros @param {string} topic */
function describe(ros, topic) {
  const found = ros.graph.topics().find(({ name }) => name === topic);
  const type = found?.types.find((one) => ros.types[one]) ?? found?.types[0] ?? "";
  // What only a tool listens to, this panel for one, is no part of the robot.
  const subscriptions = found?.subscriptions.filter((node) => !isHidden(node)) ?? [];
  return { type, publishers: found?.publishers ?? [], subscriptions };
}

/** What all publishers of the topic offer, as `ros2 topic echo` asks for. @param {Ros} ros @param {string} topic */
function qosFor(ros, topic) {
  const publishers = ros.graph.endpoints().filter(({ kind, name }) => kind === "publisher" && name === topic);
  const all = (/** @type {"reliable" | "transientLocal"} */ policy) =>
    publishers.length > 0 && publishers.every(({ qos }) => qos[policy]);
  return { depth: HISTORY, reliable: all("reliable"), transientLocal: all("transientLocal") };
}

/** @param {string[]} nodes @param {string} none */
function list(nodes, none) {
  const names = nodes.map((node) => (node === PAGE_NODE ? say("this page") : node));
  return nodes.length ? [...new Set(names)].join(", ") : none;
}
