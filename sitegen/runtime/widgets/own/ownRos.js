// @ts-check
// The ROS API that an author's panel is given. It ends with the panel, and what its callbacks throw is shown there.
// Its types for authors are in sitegen/interfaces/ros.d.ts.

import { whileSeen } from "../../ui/looking.js";
import { say } from "../../ui/words.js";

/** @import { MessageInfo, Publisher, Qos, Ros, Shared } from "../../protocol.js" */
/** @import { Faults } from "./faults.js" */

export class OwnRos {
  #element;
  #ros;
  #faults;
  #closing = new AbortController();
  /** What ends with the panel. @type {Set<() => void>} */
  #ends = new Set();
  signal = this.#closing.signal;

  /** @param {HTMLElement} element @param {Ros} ros @param {Faults} faults */
  constructor(element, ros, faults) {
    this.#element = element;
    this.#ros = ros;
    this.#faults = faults;
  }

  /** What `mount` is given; its functions can be taken out of it. */
  get api() {
    const { nodes, graph, types } = this.#ros;
    const { signal } = this;
    return {
      nodes, graph, types, signal,
      subscribe: this.#subscribe.bind(this),
      advertise: this.#advertise.bind(this),
      call: (/** @type {[string, string, any, number?]} */ ...given) => this.#call(...given),
      watch: this.#watch.bind(this),
      whileSeen: this.#whileSeen.bind(this),
      keep: this.#keep.bind(this),
    };
  }

  close() {
    this.#closing.abort(new Error("the panel was removed"));
    for (const end of [...this.#ends]) end();
  }

  /**
   * Subscribe while the panel is visible, or `always`.
   * @param {string} topic @param {string} type @param {(message: any, info: MessageInfo) => void} callback
   * @param {Partial<Qos> & {always?: boolean}} [qos]
   */
  #subscribe(topic, type, callback, { always = false, ...qos } = {}) {
    this.#check(type);
    const begin = () => this.#ros.subscribe(topic, type, this.#faults.guard(callback), qos);
    return this.#until(always ? begin() : whileSeen(this.#element, begin));
  }

  /** @param {string} topic @param {string} type @param {Partial<Qos>} [qos] @returns {Publisher} */
  #advertise(topic, type, qos) {
    this.#check(type);
    const publisher = this.#ros.advertise(topic, type, qos);
    return { publish: (message) => publisher.publish(message), close: this.#until(() => publisher.close()) };
  }

  /** @param {string} service @param {string} type @param {any} request @param {number} [timeout] */
  #call(service, type, request, timeout) {
    return this.#ros.call(service, type, request, timeout, this.signal);
  }

  /** Call `callback` after changes of the graph. @param {() => void} callback */
  #watch(callback) {
    const changed = this.#faults.guard(callback);
    this.#ros.graph.addEventListener("change", changed);
    return this.#until(() => this.#ros.graph.removeEventListener("change", changed));
  }

  /** @param {() => (() => void) | void} begin */
  #whileSeen(begin) {
    return this.#until(whileSeen(this.#element, () => {
      /** @type {(() => void) | void} */
      let end;
      this.#faults.guard(() => { end = begin(); })();
      return () => {
        if (end) this.#faults.guard(end)();
      };
    }));
  }

  /**
   * @param {Record<string, "string" | "boolean" | "number" | "object">} shape @param {() => Shared} read
   * @param {(state: Shared, odd: () => void) => void} restore
   */
  #keep(shape, read, restore) {
    const state = () => {
      let found = {};
      this.#faults.guard(() => { found = read() ?? {}; })();
      return found;
    };
    this.#ros.keep(this.#element, shape, state, this.#faults.guard(restore));
  }

  /** @param {string} type */
  #check(type) {
    if (!this.#ros.types[type]) throw new Error(say("no node on this page uses {}", type));
  }

  /** @param {() => void} end */
  #until(end) {
    const once = () => {
      if (this.#ends.delete(once)) end();
    };
    this.#ends.add(once);
    return once;
  }
}
