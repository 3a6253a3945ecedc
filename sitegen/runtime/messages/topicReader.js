// @ts-check
// The messages of a topic for a panel, which subscribes as soon as the topic has a known type.

import { say } from "../ui/words.js";

/** @import { MessageInfo, Ros } from "../protocol.js" */

export class TopicReader {
  #ros;
  #receive;
  #depth;
  /** Topic, type and QoS of the subscription, or "". */
  #subscribed = "";
  #unsubscribe = () => {};
  #failure = "";
  topic;
  /** The type of the topic, or "". */
  type = "";

  /**
   * @param {Ros} ros @param {string} topic @param {(message: any, info: MessageInfo) => void} receive
   * @param {number} depth how many messages may wait to be taken
   */
  constructor(ros, topic, receive, depth) {
    this.#ros = ros;
    this.topic = topic;
    this.#receive = receive;
    this.#depth = depth;
  }

  /**
   * Follow changes of the graph; subscribe if the messages are `wanted`.
   * @param {boolean} wanted
   */
  look(wanted) {
    const { graph, types } = this.#ros;
    const known = graph.topics().find(({ name }) => name === this.topic)?.types ?? [];
    this.type = known.find((type) => types[type]) ?? known[0] ?? "";
    const qos = qosFor(this.#ros, this.topic, this.#depth);
    const needed = wanted && this.topic && types[this.type];
    const subscription = needed ? JSON.stringify([this.topic, this.type, qos]) : "";
    if (subscription === this.#subscribed) return;
    this.close();
    if (!subscription) return;
    this.#subscribed = subscription;
    try {
      this.#unsubscribe = this.#ros.subscribe(this.topic, this.type, this.#receive, qos);
    } catch (error) {
      this.#failure = error instanceof Error ? error.message : String(error);
    }
  }

  close() {
    this.#subscribed = "";
    this.#failure = "";
    this.#unsubscribe();
    this.#unsubscribe = () => {};
  }

  /** Why there are no messages, in a sentence. */
  describeSilence() {
    const { topic, type } = this;
    if (this.#failure) return this.#failure;
    if (!type) return say("No node uses {} now. Messages appear here when a node publishes.", topic);
    if (!this.#ros.types[type]) return say("This page has no definition of {}, so it cannot read these messages.", type);
    const publishers = this.#ros.graph.topics().find(({ name }) => name === topic)?.publishers ?? [];
    return publishers.length ? say("No message yet") : say("{} has no publishers now", topic);
  }
}

/**
 * Policies that all publishers of the topic offer, as in `ros2 topic echo`.
 * @param {Ros} ros @param {string} topic @param {number} depth
 */
function qosFor(ros, topic, depth) {
  const publishers = ros.graph.endpoints().filter(({ kind, name }) => kind === "publisher" && name === topic);
  const all = (/** @type {"reliable" | "transientLocal"} */ policy) =>
    publishers.length > 0 && publishers.every(({ qos }) => qos[policy]);
  return { depth, reliable: all("reliable"), transientLocal: all("transientLocal") };
}
