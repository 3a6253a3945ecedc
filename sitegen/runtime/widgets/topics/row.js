// @ts-check
// A topic in the table of topics: its type, who uses it, its rate, and which nodes are incompatible.

import { isHidden } from "../../graphNames.js";
import { explain } from "../../messages/mismatch.js";
import { Rate } from "../../messages/rate.js";
import { now } from "../../protocol.js";
import { button, create, pressAnywhere, setText } from "../../ui/elements.js";
import { say } from "../../ui/words.js";

/** @import { Mismatch, Ros } from "../../protocol.js" */

/**
 * @typedef {{name: string, types: string[], publishers: string[], subscriptions: string[],
 *   missed: number, mismatches: Mismatch[]}} Topic
 */

export const HEADINGS = /** @type {const} */ ([
  [say("Topic"), say("name and type")],
  [say("Pub"), say("number of publishers")],
  [say("Sub"), say("number of subscriptions")],
  [say("Rate"), say("messages and bytes per second, over the last five seconds")],
]);

// Further incompatible pairs of nodes are counted instead of listed.
const WARNINGS = 3;
// Best effort and volatile is compatible with every publisher.
const QOS = { depth: 1000, reliable: false, transientLocal: false };
const compact = new Intl.NumberFormat("en", { notation: "compact" });

export class Row {
  #ros;
  #name;
  #type = create("small", "");
  #publishers = create("td", "");
  #subscriptions = create("span", "");
  #missed = create("small", "");
  #hertz = create("span", "");
  #bandwidth = create("small", "");
  #warnings = create("td", "");
  #line;
  #below = create("tr", "ros-warnings", this.#warnings);
  pick;

  #rate = new Rate();
  /** The type that the rate is measured with, or "". */
  #measured = "";
  #unsubscribe = () => {};

  /** @param {Ros} ros @param {string} name @param {() => void} choose called when the visitor selects the topic */
  constructor(ros, name, choose) {
    this.#ros = ros;
    this.#name = name;
    this.pick = button(name, "ros-pick", choose);
    const head = create("th", "", this.pick, this.#type);
    head.scope = "row";
    const to = create("td", "", this.#subscriptions, this.#missed);
    const rate = create("td", "", this.#hertz, this.#bandwidth);
    this.#line = create("tr", "", head, this.#publishers, to, rate);
    pressAnywhere(this.#line, this.pick);
    this.#warnings.colSpan = HEADINGS.length;
    this.#missed.title = say("Messages replaced by newer ones before a subscription took them");
    this.stop();
  }

  get elements() {
    return this.#warnings.hasChildNodes() ? [this.#line, this.#below] : [this.#line];
  }

  /** Show the topic and begin to measure its rate. @param {Topic} topic */
  show({ types, publishers, subscriptions, missed, mismatches }) {
    setText(this.#type, types.join(", "));
    setText(this.#publishers, String(publishers.length));
    this.#publishers.title = publishers.join(", ");
    const visible = subscriptions.filter((node) => !isHidden(node));
    setText(this.#subscriptions, String(visible.length));
    this.#subscriptions.title = visible.join(", ");
    setText(this.#missed, missed ? say("{} missed", compact.format(missed)) : "");
    warn(this.#warnings, mismatches.filter((pair) => !isHidden(pair.publisher) && !isHidden(pair.subscription)));
    this.#line.classList.toggle("ros-idle", !publishers.length);
    this.#subscribe(publishers.length ? (types[0] ?? "") : "");
  }

  /** Write the rate of the last seconds. */
  measure() {
    const { hertz, bytes } = this.#rate.read(now());
    setText(this.#hertz, hertz ? `${rounded(hertz)} Hz` : "–");
    setText(this.#bandwidth, bytes ? bandwidth(bytes) : "");
  }

  /** Stop measuring. */
  stop() {
    this.#unsubscribe();
    this.#unsubscribe = () => {};
    this.#measured = "";
    this.#rate = new Rate();
    setText(this.#hertz, "–");
    setText(this.#bandwidth, "");
  }

  /** @param {string} type or "" */
  #subscribe(type) {
    if (type === this.#measured) return;
    this.stop();
    this.#measured = type;
    if (!type) return;
    this.#unsubscribe = this.#ros.subscribeBytes(this.#name, type, (_, info) => {
      this.#rate.add(info.timestamp, info.size);
    }, QOS);
  }
}

/** List nodes that are incompatible. @param {Element} element @param {Mismatch[]} mismatches */
function warn(element, mismatches) {
  const texts = [...new Set(mismatches.map(explain))];
  const more = texts.length - WARNINGS;
  const shown = [...texts.slice(0, WARNINGS), ...(more > 0 ? [say("and {} more", more)] : [])];
  if (shown.join() === [...element.children].map((child) => child.textContent).join()) return;
  element.replaceChildren(...shown.map((text) => create("p", "", text)));
}

/** @param {number} bytes per second */
function bandwidth(bytes) {
  if (bytes < 1000) return `${Math.round(bytes)} B/s`;
  return bytes < 1e6 ? `${rounded(bytes / 1000)} kB/s` : `${rounded(bytes / 1e6)} MB/s`;
}

/** Format with three significant digits. @param {number} number below 1000 */
function rounded(number) {
  return number.toFixed(number < 10 ? 2 : number < 100 ? 1 : 0);
}
