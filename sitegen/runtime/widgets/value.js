// @ts-check
// The latest value of a message path, as a number, a gauge, a light or a text.

import { Derivative } from "../messages/derivative.js";
import { isNumeric, isSliced, parsePath, readPath, toNumber, typeAt } from "../messages/path.js";
import { TopicReader } from "../messages/topicReader.js";
import { create, setText } from "../ui/elements.js";
import { whileNear } from "../ui/looking.js";
import { say } from "../ui/words.js";
import { createFace } from "./value/face.js";
import { StateSign, stateOf } from "./value/state.js";

/** @import { MessageInfo, Ros } from "../protocol.js" */
/** @import { Path } from "../messages/path.js" */
/** @import { Face, Show } from "./value/face.js" */
/** @import { Threshold } from "./value/state.js" */

/**
 * @typedef {{path: string, show?: Show | null, title?: string | null, unit?: string | null, scale?: number | null,
 *   decimals?: number | null, min?: number | null, max?: number | null, thresholds?: Threshold[] | null}} Options
 */

// Of a fast topic, the newest message counts.
const DEPTH = 10;

/**
 * Show the value of `path`.
 * @param {HTMLElement} element
 * @param {Ros} ros
 * @param {Options} options
 * @returns {() => void} unmount
 */
export function mount(element, ros, options) {
  const panel = new ValuePanel(ros, options);
  element.replaceChildren(...panel.elements);
  const unlook = whileNear(element, () => panel.begin());
  return () => {
    unlook();
    element.replaceChildren();
  };
}

class ValuePanel {
  #ros;
  #options;
  /** @type {Path | undefined} */
  #path;
  /** @type {TopicReader | undefined} */
  #reader;
  /** What is wrong with the path, or "". */
  #error = "";
  #checked = "";
  /** @type {Face | undefined} */
  #face;
  #derivative = new Derivative();
  /** The latest value: a number, or a text. @type {number | string | undefined} */
  #value;
  #frame = 0;
  #place = create("div", "ros-face");
  #sign = new StateSign();
  #note = create("p", "ros-note");
  elements;

  /** @param {Ros} ros @param {Options} options */
  constructor(ros, options) {
    this.#ros = ros;
    this.#options = options;
    const title = create("span", options.title ? "ros-title" : "ros-name", options.title || options.path);
    title.title = options.path;
    this.elements = [
      create("div", "ros-bar", create("div", "ros-node", title)),
      create("div", "ros-value-area", this.#place, this.#sign.element, this.#note),
    ];
    this.#place.setAttribute("aria-label", options.title || options.path);
    try {
      this.#path = parsePath(options.path);
      if (isSliced(this.#path)) throw new Error(say("{} names several values; name one, such as [0]", options.path));
      this.#reader = new TopicReader(ros, this.#path.topic, (message, info) => this.#receive(message, info), DEPTH);
    } catch (error) {
      this.#error = error instanceof Error ? error.message : String(error);
    }
    this.#draw();
  }

  /** Subscribe while the panel is visible. @returns {() => void} end it */
  begin() {
    const look = () => this.#look();
    look();
    this.#ros.graph.addEventListener("change", look);
    return () => {
      this.#ros.graph.removeEventListener("change", look);
      this.#reader?.close();
      this.#derivative.clear();
      cancelAnimationFrame(this.#frame);
      this.#frame = 0;
    };
  }

  /** Follow changes of the graph. */
  #look() {
    this.#reader?.look(true);
    const type = this.#reader?.type ?? "";
    if (this.#path && this.#ros.types[type] && type !== this.#checked) this.#check(this.#path, type);
    if (this.#error) this.#reader?.close();
    this.#draw();
  }

  /** @param {Path} path @param {string} type */
  #check(path, type) {
    this.#checked = type;
    this.#error = "";
    try {
      const { base, array } = typeAt(path, type, this.#ros.types);
      if (array) throw new Error(say("{} names several values; name one, such as [0]", path.text));
      const text = /^w?string$/.test(base);
      if (!text && !isNumeric(base)) throw new Error(say("{} is a whole {}; name one of its fields", path.text, base));
      const { show } = this.#options;
      if (text && ((show && show !== "text") || path.derivative)) throw new Error(say("{} is text, not a number", path.text));
      this.#setFace(show ?? (text ? "text" : base === "bool" && !path.derivative ? "light" : "number"));
    } catch (error) {
      this.#error = error instanceof Error ? error.message : String(error);
      this.#value = undefined;
    }
  }

  /** @param {Show} show */
  #setFace(show) {
    this.#face = createFace(show, this.#options);
    this.#place.replaceChildren(this.#face.element);
  }

  /** @param {any} message @param {MessageInfo} info */
  #receive(message, { received }) {
    const path = /** @type {Path} */ (this.#path);
    readPath(path, message, (_, value) => {
      if (typeof value === "string") {
        this.#value = value;
        return;
      }
      const number = toNumber(value);
      if (number === undefined) return;
      const found = path.derivative ? this.#derivative.of(received / 1000, number) : number;
      if (found !== undefined) this.#value = found * (this.#options.scale ?? 1);
    });
    this.#frame ||= requestAnimationFrame(() => this.#draw());
  }

  #draw() {
    this.#frame = 0;
    const value = this.#value;
    const state = typeof value === "number" ? stateOf(value, this.#options.thresholds ?? []) : undefined;
    this.#place.hidden = value === undefined || !this.#face;
    if (value !== undefined) this.#face?.show(value, state);
    this.#sign.show(state);
    const silent = value === undefined || !this.#published();
    setText(this.#note, this.#error || (silent ? this.#reader?.describeSilence() ?? "" : ""));
    this.#note.classList.toggle("ros-wrong", Boolean(this.#error));
    // A value whose publisher has gone is no longer true.
    this.#place.classList.toggle("ros-idle", silent);
  }

  #published() {
    const topic = this.#path?.topic;
    return (this.#ros.graph.topics().find(({ name }) => name === topic)?.publishers.length ?? 0) > 0;
  }
}
