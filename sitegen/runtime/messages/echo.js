// @ts-check
// Show the messages of a topic as YAML, the newest at the end, as `ros2 topic echo` does.

import { isHidden, PAGE_NODE } from "../graphNames.js";
import { create, setText } from "../ui/elements.js";
import { Tail } from "../ui/tail.js";
import { setTool, tool } from "../ui/toolbar.js";
import { say } from "../ui/words.js";
import { Eraser, Pause, Play } from "../vendor/icons.js";
import { toYaml } from "./yaml.js";

/** @import { Ros } from "../protocol.js" */

/** @typedef {{type: string, publishers: string[], subscriptions: string[]}} Topic */

// How many messages are kept, and how many elements of a long array or characters of a long text are shown.
const HISTORY = 50;
const LENGTH = 32;

/** The messages of a topic. It subscribes only between `begin` and its end, and not while it is paused. */
export class Echo {
  #ros;
  #name = create("span", "ros-name");
  #kind = create("span", "ros-type");
  #pause = tool(say("Pause"), Pause, () => {
    this.#paused = !this.#paused;
    this.look();
  });
  #controls = create("div", "ros-controls", this.#pause, tool(say("Clear"), Eraser, () => {
    this.#clear();
    this.look();
  }));
  #ends = create("p", "ros-ends");
  #log = create("div", "ros-lines");
  #hint = create("p", "ros-hint");
  element;

  #topic = "";
  #paused = false;
  #working = false;
  /** Topic, type and QoS of the subscription, or "". */
  #subscribed = "";
  #unsubscribe = () => {};
  /** Why subscribing failed, or "". */
  #failure = "";
  /** Messages that are not drawn yet. @type {string[]} */
  #waiting = [];
  #frame = 0;
  #tail = new Tail(this.#log);

  /** @param {Ros} ros */
  constructor(ros) {
    this.#ros = ros;
    this.#log.setAttribute("role", "log");
    this.#log.setAttribute("aria-live", "off"); // screen readers would never fall silent
    this.#log.tabIndex = 0;
    const bar = create("div", "ros-bar", create("div", "ros-node", this.#name, this.#kind), this.#controls);
    this.element = create("div", "ros-echo", bar, this.#ends, this.#log, this.#hint);
  }

  /** Show another topic. @param {string} topic or "" for none */
  choose(topic) {
    this.#topic = topic;
    this.#paused = false;
    this.#tail.following = true;
    this.#clear();
    this.look();
  }

  /** Subscribe while the panel is visible. @returns {() => void} end it */
  begin() {
    this.#working = true;
    this.look();
    return () => {
      this.#working = false;
      cancelAnimationFrame(this.#frame);
      this.#frame = 0;
      this.look();
    };
  }

  /** Follow changes of the graph. */
  look() {
    const topic = describe(this.#ros, this.#topic);
    setText(this.#name, this.#topic);
    setText(this.#kind, topic.type);
    setText(this.#ends, this.#topic ? endsOf(topic) : "");
    this.#log.setAttribute("aria-label", say("messages on {}", this.#topic));
    setTool(this.#pause, this.#paused ? say("Resume") : say("Pause"), this.#paused ? Play : Pause);
    this.#controls.hidden = !this.#topic;
    this.#subscribe(topic.type);
    setText(this.#hint, this.#failure || this.#describeSilence(topic));
    this.#hint.hidden = this.#log.hasChildNodes();
  }

  /** Renew the subscription if it is not the one that is needed now. @param {string} type */
  #subscribe(type) {
    const topic = this.#topic;
    const qos = qosFor(this.#ros, topic);
    const needed = this.#working && topic && this.#ros.types[type] && !this.#paused;
    const wanted = needed ? JSON.stringify([topic, type, qos]) : "";
    if (wanted === this.#subscribed) return;
    this.#subscribed = wanted;
    this.#unsubscribe();
    this.#unsubscribe = () => {};
    this.#failure = "";
    if (!wanted) return;
    try {
      this.#unsubscribe = this.#ros.subscribe(topic, type, (message) => this.#receive(message, type), qos);
    } catch (error) {
      this.#failure = error instanceof Error ? error.message : String(error);
    }
  }

  /** @param {any} message @param {string} type */
  #receive(message, type) {
    this.#waiting.push(toYaml(message, type, this.#ros.types, LENGTH));
    if (this.#waiting.length > HISTORY) this.#waiting.shift();
    this.#frame ||= requestAnimationFrame(() => this.#draw());
  }

  #draw() {
    this.#frame = 0;
    this.#log.append(...this.#waiting.map((text) => create("div", "", `${text}\n---`)));
    this.#waiting = [];
    while (this.#log.childElementCount > HISTORY) this.#log.firstElementChild?.remove();
    this.#tail.follow();
    this.#hint.hidden = true;
  }

  #clear() {
    this.#waiting = [];
    this.#log.replaceChildren();
  }

  /** Why there are no messages. @param {Topic} topic */
  #describeSilence({ type, publishers }) {
    const topic = this.#topic;
    if (!topic) return say("Choose a topic to read its messages");
    if (!type) return say("No node uses {} now. Messages appear here when a node publishes.", topic);
    if (!this.#ros.types[type]) return say("This page has no definition of {}, so it cannot read these messages.", type);
    if (this.#paused) return say("Paused");
    return publishers.length ? say("No message yet") : say("{} has no publishers now", topic);
  }
}

/** @param {Ros} ros @param {string} topic @returns {Topic} */
function describe(ros, topic) {
  const found = ros.graph.topics().find(({ name }) => name === topic);
  const type = found?.types.find((one) => ros.types[one]) ?? found?.types[0] ?? "";
  // Subscriptions of tools, such as this panel, are not part of the robot.
  const subscriptions = found?.subscriptions.filter((node) => !isHidden(node)) ?? [];
  return { type, publishers: found?.publishers ?? [], subscriptions };
}

/** Policies that all publishers of the topic offer, as in `ros2 topic echo`. @param {Ros} ros @param {string} topic */
function qosFor(ros, topic) {
  const publishers = ros.graph.endpoints().filter(({ kind, name }) => kind === "publisher" && name === topic);
  const all = (/** @type {"reliable" | "transientLocal"} */ policy) =>
    publishers.length > 0 && publishers.every(({ qos }) => qos[policy]);
  return { depth: HISTORY, reliable: all("reliable"), transientLocal: all("transientLocal") };
}

/** @param {Topic} topic */
function endsOf({ publishers, subscriptions }) {
  return `${list(publishers, say("no publishers"))} → ${list(subscriptions, say("no subscribers"))}`;
}

/** @param {string[]} nodes @param {string} none */
function list(nodes, none) {
  const names = nodes.map((node) => (node === PAGE_NODE ? say("this page") : node));
  return nodes.length ? [...new Set(names)].join(", ") : none;
}
