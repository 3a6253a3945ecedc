// @ts-check
// Topics: what the page publishes goes to the robot, and what it looks at comes from there.

import { now } from "../../protocol.js";
import { Echoes } from "./echoes.js";

/** @import { RemoteEndpoint } from "../../gateway/wire.js" */
/** @import { Bridge } from "./bridge.js" */
/**
 * @typedef {{name: string, type: string, writers: Set<number>, sequence: number, echoes: Echoes}} Subscribed
 *   `writers` are the ids of the robot's publishers that the page looks at
 */

export class Topics {
  #bridge;
  /** Publishers of the page that the server has not taken; it would complain of each message. @type {Set<number>} */
  #refused = new Set();
  /** By name. @type {Map<string, Subscribed>} */
  #subscribed = new Map();

  /** @param {Bridge} bridge */
  constructor(bridge) {
    this.#bridge = bridge;
  }

  /** Offer a publisher of the page. @param {RemoteEndpoint} endpoint */
  offer(endpoint) {
    const { id, name, type } = endpoint;
    this.#bridge.emit({ op: "advertise", id: `own:${id}`, topic: name, type, ...historyOf(endpoint) });
    // rosbridge tells of no tools that subscribe, such as `ros2 topic echo`.
    this.#bridge.say({ op: "open", id });
  }

  /** A publisher of the page has gone. @param {RemoteEndpoint} endpoint */
  withdraw({ id, name }) {
    this.#bridge.emit({ op: "unadvertise", id: `own:${id}`, topic: name });
    this.#refused.delete(id);
  }

  /** Send nothing, or something again. @param {number} id of a publisher of the page @param {boolean} yes */
  refuse(id, yes) {
    if (yes) this.#refused.add(id);
    else this.#refused.delete(id);
  }

  /** Whether the page has subscribed to a topic. @param {string} name */
  subscribes(name) {
    return this.#subscribed.has(name);
  }

  /** Publish a message of the page. @param {RemoteEndpoint} publisher @param {Uint8Array} bytes */
  publish(publisher, bytes) {
    const { id, name, type } = publisher;
    if (this.#refused.has(id)) return;
    const message = this.#bridge.codec.read(type, bytes);
    this.#subscribed.get(name)?.echoes.add(this.#bridge.codec.write(type, message));
    const msg = this.#bridge.values.toExact(type, message);
    this.#bridge.emit({ op: "publish", id: `own:${id}`, topic: name, msg, ...historyOf(publisher) });
  }

  /**
   * The page looks at a publisher of the robot.
   * @param {RemoteEndpoint} endpoint @param {number} [rate] the most messages per second
   */
  async look({ id, name, type }, rate) {
    const known = this.#subscribed.get(name);
    if (known) {
      known.writers.add(id);
      return;
    }
    const topic = { name, type, writers: new Set([id]), sequence: 0, echoes: new Echoes() };
    this.#subscribed.set(name, topic);
    const compression = (await this.#bridge.types.hasCbor(type)) ? "cbor" : "none";
    if (this.#subscribed.get(name) !== topic) return;
    const throttle = rate ? { throttle_rate: Math.round(1000 / rate) } : {};
    this.#bridge.emit({ op: "subscribe", id: `topic:${name}`, topic: name, type, compression, ...throttle });
  }

  /** The page no longer looks at a publisher of the robot. @param {RemoteEndpoint} endpoint */
  leave({ id, name }) {
    const topic = this.#subscribed.get(name);
    if (!topic?.writers.delete(id) || topic.writers.size > 0) return;
    this.#subscribed.delete(name);
    this.#bridge.emit({ op: "unsubscribe", id: `topic:${name}`, topic: name });
  }

  /** Handle a message of a topic. @param {{topic?: unknown, msg?: any}} message */
  receive({ topic: name, msg }) {
    const topic = this.#subscribed.get(String(name));
    const [writer] = topic?.writers ?? [];
    if (!topic || writer === undefined) return;
    const message = this.#bridge.codec.write(topic.type, this.#bridge.values.read(topic.type, msg));
    if (topic.echoes.take(message)) return;
    topic.sequence += 1;
    this.#bridge.deliver({ reader: 0, writer, sequence: topic.sequence, timestamp: now() }, message);
  }
}

/** How much the robot's server keeps of a topic. @param {RemoteEndpoint} endpoint */
function historyOf({ qos }) {
  return { latch: qos.transientLocal, queue_size: Math.min(qos.depth, 1000) || 1 };
}
