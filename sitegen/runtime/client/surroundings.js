// @ts-check
// What the graph of the page tells about names: their types, and when they come.

import { Checker } from "../messages/checker.js";
import { say } from "../ui/words.js";

/** @import { Ros } from "../protocol.js" */

export class Surroundings {
  #ros;
  #closing = new AbortController();
  /** What was told about topics. @type {Set<string>} */
  #told = new Set();
  /** Aborted when the node of the script is closed. */
  closed = this.#closing.signal;

  /** @param {Ros} ros */
  constructor(ros) {
    this.#ros = ros;
    this.checker = new Checker(ros.types);
  }

  /** End what waits for something. */
  close() {
    this.#closing.abort(new Error(say("closed")));
  }

  /**
   * The type of a topic or a service, "" if the graph has none.
   * @param {"topics" | "services"} kind @param {string} name
   */
  typeOf(kind, name) {
    return this.#ros.graph[kind]().find((one) => one.name === name)?.types[0] ?? "";
  }

  /**
   * The quality of service with which a subscription to a topic gets most of what its publishers offer now; `known` if
   * there are any.
   * @param {string} name @returns {{reliable: boolean, transientLocal: boolean, known: boolean}}
   */
  qosOf(name) {
    const publishers = this.publishersOf(name);
    const all = (/** @type {"reliable" | "transientLocal"} */ key) =>
      publishers.length > 0 && publishers.every(({ qos }) => qos[key]);
    return { reliable: all("reliable"), transientLocal: all("transientLocal"), known: publishers.length > 0 };
  }

  /** The publishers of a topic. @param {string} name */
  publishersOf(name) {
    return this.#ros.graph.endpoints().filter((one) => one.kind === "publisher" && one.name === name);
  }

  /** The nodes that serve a service. @param {string} name */
  serversOf(name) {
    return this.#ros.graph.services().find((one) => one.name === name)?.servers ?? [];
  }

  /**
   * Throw an Error if the page has no definition of a type.
   * @param {string} name of what has the type @param {string} type @param {string} [part] of a service or an action
   */
  check(name, type, part = "") {
    if (!this.#ros.types[type + part]) throw new Error(`${name}: ${say("this page has no definition of {}", type)}`);
  }

  /**
   * Warn once if others use a topic with another type, now or later. As in ROS, that is no error, but nothing arrives.
   * @param {string} name @param {string} type @returns {() => void} stop
   */
  compare(name, type) {
    const key = `${name} ${type}`;
    // Passive: a program that waits for nothing else is done.
    const stop = this.watch(() => look(), { passive: true });
    const look = () => {
      const other = this.#ros.graph.endpoints().find((one) =>
        (one.kind === "publisher" || one.kind === "subscription") && one.name === name && one.type !== type);
      if (!other) return;
      stop();
      if (!this.#told.has(key)) console.warn(`${name} has the type ${other.type}, not ${type}, at ${other.node}`);
      this.#told.add(key);
    };
    look();
    return stop;
  }

  /**
   * Call `begin` with the type of a topic or a service: `type`, or else, when the graph has it, that. Return a function
   * that ends what `begin` returns, or the wait.
   * @param {"topics" | "services"} kind @param {string} name @param {string} type
   * @param {(type: string) => () => void} begin @returns {() => void}
   */
  whenTyped(kind, name, type, begin) {
    const known = type || this.typeOf(kind, name);
    if (known) return begin(known);
    /** @type {(() => void) | undefined} */
    let end;
    const stop = this.watch(() => {
      const found = this.typeOf(kind, name);
      if (!found) return;
      stop();
      end = begin(found);
    });
    return () => {
      stop();
      end?.();
    };
  }

  /**
   * Resolve when `found` returns something else than undefined, with that; reject after `timeout` ms.
   * @template Found
   * @param {() => Found | undefined} find @param {number} timeout @param {string} fault @param {AbortSignal} [signal]
   * @returns {Promise<Found>}
   */
  when(find, timeout, fault, signal) {
    return new Promise((resolve, reject) => {
      const look = () => {
        const found = find();
        if (found !== undefined) done(() => resolve(found));
      };
      const timer = timeout === Infinity ? undefined : setTimeout(() => done(() => reject(new Error(fault))), timeout);
      const aborted = () => done(() => reject(signal?.reason));
      const stop = this.watch(look);
      const done = (/** @type {() => void} */ settle) => {
        clearTimeout(timer);
        stop();
        signal?.removeEventListener("abort", aborted);
        this.closed.removeEventListener("abort", closed);
        settle();
      };
      const closed = () => done(() => reject(this.closed.reason));
      signal?.addEventListener("abort", aborted);
      this.closed.addEventListener("abort", closed);
      if (signal?.aborted) aborted();
      else if (this.closed.aborted) closed();
      else look();
    });
  }

  /**
   * Call `changed` after changes of the graph, until the node is closed.
   * @param {() => void} changed @param {AddEventListenerOptions} [options] @returns {() => void} stop
   */
  watch(changed, options) {
    const stop = () => {
      this.#ros.graph.removeEventListener("change", changed);
      this.closed.removeEventListener("abort", stop);
    };
    if (!this.closed.aborted) {
      this.#ros.graph.addEventListener("change", changed, options);
      this.closed.addEventListener("abort", stop);
    }
    return stop;
  }
}
