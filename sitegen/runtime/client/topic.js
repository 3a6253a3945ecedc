// @ts-check
// A topic, as scripts use it.

import { say } from "../ui/words.js";
import { adapted } from "./adapted.js";
import { endingWith } from "./ending.js";
import { qosOf } from "./qos.js";
import { Stream } from "./stream.js";

/** @import { MessageInfo, PageNode, Publisher, Qos } from "../protocol.js" */
/** @import { GivenQos } from "./qos.js" */
/** @import { Surroundings } from "./surroundings.js" */

export class Topic {
  #raw;
  #surroundings;
  #type;
  /** @type {Publisher | undefined} */
  #publisher;
  /** What the publisher has. */
  #published = "";
  #end = () => {};
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
   * @param {(message: any, info: MessageInfo) => void} callback
   * @param {{qos?: GivenQos, signal?: AbortSignal}} [options] `signal` ends it, too @returns {() => void}
   */
  subscribe(callback, { qos, signal, ...others } = {}) {
    const [odd] = Object.keys(others);
    if (odd) throw new Error(say("{}: unknown option '{}'; known are qos and signal", this.name, odd));
    const wanted = { ...this.#qos, ...qosOf(qos) };
    this.#surroundings.closed.throwIfAborted();
    return signal?.aborted ? () => {} : endingWith([signal], this.#begin(callback, wanted));
  }

  /**
   * @param {(message: any, info: MessageInfo) => void} callback @param {Partial<Qos>} qos @returns {() => void} end
   */
  #begin(callback, qos) {
    return this.#surroundings.whenTyped("topics", this.name, this.#type, (type) => {
      this.#surroundings.check(this.name, type);
      const stop = this.#surroundings.compare(this.name, type);
      const end = adapted(this.#surroundings, this.name, qos, (best, isNew) =>
        this.#raw.subscribe(this.name, type, (message, info) => {
          if (isNew(info)) callback(message, info);
        }, best));
      return () => {
        stop();
        end();
      };
    });
  }

  /** Iterate over the messages: `for await (const message of topic)`. */
  [Symbol.asyncIterator]() {
    return this.messages();
  }

  /**
   * Iterate over the messages: `for await (const message of topic.messages({ signal }))`.
   * @param {{most?: number, signal?: AbortSignal, qos?: GivenQos}} [options] of the messages that the loop has not come
   *   to, the newest `most` are kept
   */
  messages({ qos, ...options } = {}) {
    const begin = (/** @type {(message: any) => void} */ push) =>
      this.subscribe((message) => push(message), qos === undefined ? {} : { qos });
    return new Stream(begin, options, this.#surroundings.closed);
  }

  /** Resolve with the next message. @param {{signal?: AbortSignal}} [options] */
  async next({ signal } = {}) {
    for await (const message of this.messages({ signal, most: 1 })) return message;
    throw signal?.reason ?? new Error(say("closed"));
  }

  /**
   * Publish a message; the first one announces the publisher. What does not fit the type is an error.
   * @param {any} message its fields, or all of it in CDR
   */
  publish(message) {
    this.#surroundings.closed.throwIfAborted();
    const type = this.#publisher ? this.#published : this.#known();
    const bytes = message instanceof Uint8Array;
    const checked = bytes ? message : this.#surroundings.checker.read(type, message, this.name);
    this.#announce(type);
    this.#publisher?.publish(checked);
  }

  /** Announce the publisher before its first message. @param {{signal?: AbortSignal}} [options] `signal` ends it */
  advertise({ signal } = {}) {
    this.#surroundings.closed.throwIfAborted();
    if (signal?.aborted) return;
    if (!this.#publisher) this.#announce(this.#known());
    this.#end = endingWith([signal], this.#end);
  }

  /** End the publisher. */
  unadvertise() {
    this.#end();
  }

  /** Return the type, which the page has to know. */
  #known() {
    const { type } = this;
    if (!type) throw new Error(say("give {} a type: the graph has no such topic", this.name));
    this.#surroundings.check(this.name, type);
    return type;
  }

  /** @param {string} type */
  #announce(type) {
    if (this.#publisher) return;
    this.#published = type;
    const stop = this.#surroundings.compare(this.name, type);
    const publisher = this.#raw.advertise(this.name, type, this.#qos);
    this.#publisher = publisher;
    this.#end = () => {
      stop();
      publisher.close();
      this.#publisher = undefined;
    };
  }
}
