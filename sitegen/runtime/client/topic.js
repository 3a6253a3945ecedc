// @ts-check
// A topic, as scripts use it.

import { say } from "../ui/words.js";
import { adapted } from "./adapted.js";
import { Stream } from "./stream.js";

/** @import { MessageInfo, PageNode, Publisher, Qos } from "../protocol.js" */
/** @import { Surroundings } from "./surroundings.js" */

export class Topic {
  #raw;
  #surroundings;
  #type;
  /** @type {Publisher | undefined} */
  #publisher;
  #qos;

  /**
   * @param {PageNode} raw @param {Surroundings} surroundings @param {string} name @param {string} type empty if the graph
   *   knows it @param {Partial<Qos>} qos of publishers and subscriptions
   */
  constructor(raw, surroundings, name, type, qos) {
    this.#raw = raw;
    this.#surroundings = surroundings;
    this.name = name;
    this.#type = type;
    this.#qos = qos;
  }

  /** The type, as given or as the graph has it; "" if neither. */
  get type() {
    return this.#type || this.#surroundings.typeOf("topics", this.name);
  }

  /**
   * Call `callback` with each message, and return a function that ends the subscription. If no type was given, it begins
   * when the graph has the topic.
   * @param {(message: any, info: MessageInfo) => void} callback @param {Partial<Qos>} [qos]
   * @returns {() => void}
   */
  subscribe(callback, qos) {
    return this.#surroundings.whenTyped("topics", this.name, this.#type, (type) => {
      this.#surroundings.check(type);
      return adapted(this.#surroundings, this.name, { ...this.#qos, ...qos }, (best, isNew) =>
        this.#raw.subscribe(this.name, type, (message, info) => {
          if (isNew(info)) callback(message, info);
        }, best));
    });
  }

  /**
   * Iterate over the messages: `for await (const message of topic.messages())`.
   * @param {{most?: number, signal?: AbortSignal, qos?: Partial<Qos>}} [options] of the messages that the loop has not
   *   come to, the newest `most` are kept
   */
  messages({ qos, ...options } = {}) {
    return new Stream((push) => this.subscribe((message) => push(message), qos), options);
  }

  /** Resolve with the next message. @param {{signal?: AbortSignal}} [options] */
  async next({ signal } = {}) {
    for await (const message of this.messages({ signal, most: 1 })) return message;
    throw signal?.reason ?? new Error(say("closed"));
  }

  /** Publish a message; the first one announces the publisher. @param {any} message */
  publish(message) {
    this.advertise();
    this.#publisher?.publish(message);
  }

  /** Announce the publisher before its first message. */
  advertise() {
    if (this.#publisher) return;
    const { type } = this;
    if (!type) throw new Error(say("give {} a type: the graph has no such topic", this.name));
    this.#surroundings.check(type);
    this.#publisher = this.#raw.advertise(this.name, type, this.#qos);
  }

  /** End the publisher. */
  unadvertise() {
    this.#publisher?.close();
    this.#publisher = undefined;
  }
}
