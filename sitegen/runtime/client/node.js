// @ts-check
// A node of the page, as scripts use it.

import { PAGE_NODE } from "../graphNames.js";
import { actionsOf } from "../messages/actionClient.js";
import { say } from "../ui/words.js";
import { Action } from "./action.js";
import { Clock } from "./clock.js";
import { endingWith } from "./ending.js";
import { Log } from "./log.js";
import { fullName, fullType } from "./names.js";
import { OwnParameters } from "./ownParameters.js";
import { Parameters } from "./parameters.js";
import { qosOf } from "./qos.js";
import { Service } from "./service.js";
import { Stream } from "./stream.js";
import { Surroundings } from "./surroundings.js";
import { Tf } from "./tf.js";
import { Topic } from "./topic.js";

/** @import { Endpoint, PageNode, Ros } from "../protocol.js" */
/** @import { Options } from "./descriptor.js" */
/** @import { GivenQos } from "./qos.js" */
/** @typedef {{change: "come" | "gone", kind: Endpoint["kind"], node: string, name: string, type: string}} GraphEvent */

export class Node {
  #ros;
  #raw;
  #surroundings;
  /** @type {Clock | undefined} */
  #clock;
  /** @type {OwnParameters | undefined} */
  #own;

  /**
   * @param {Ros} ros of the page @param {PageNode} raw the same, or another node of the page @param {string} name
   * @param {Record<string, any>} [parameters] values of those that are declared later
   */
  constructor(ros, raw, name, parameters = {}) {
    this.#ros = ros;
    this.#raw = raw;
    this.#surroundings = new Surroundings(ros);
    /** Empty for the page's own hidden node. */
    this.name = name;
    this.tf = new Tf(raw, this.#surroundings);
    this.log = new Log(raw, this.#surroundings, () => this.#time, name || (ros.own ?? PAGE_NODE));
    if (!name) return;
    this.log.announce();
    this.#own = new OwnParameters(raw, this.#surroundings, this.#time, name, parameters);
  }

  /** The definitions of all interfaces, by name. */
  get types() {
    return this.#raw.types;
  }

  /** The programs of the page by their names in site.yaml, which it can start and stop. */
  get programs() {
    return this.#ros.nodes;
  }

  /**
   * A topic; without a type, it has that of the graph.
   * @param {string} name @param {string} [type] @param {GivenQos} [qos]
   */
  topic(name, type = "", qos) {
    return new Topic(this.#raw, this.#surroundings, fullName(name, this.name), type && fullType(type, "msg"),
      qosOf(qos));
  }

  /** A service; without a type, it has that of the graph. @param {string} name @param {string} [type] */
  service(name, type = "") {
    return new Service(this.#raw, this.#surroundings, fullName(name, this.name), type && fullType(type, "srv"));
  }

  /** An action; without a type, it has that of the graph. @param {string} name @param {string} [type] */
  action(name, type = "") {
    return new Action(this.#raw, this.#ros.graph, this.#surroundings, fullName(name, this.name),
      type && fullType(type, "action"));
  }

  /** The parameters of a node. @param {string} node */
  parameters(node) {
    return new Parameters(this.#raw, this.#surroundings, fullName(node, this.name));
  }

  /**
   * Declare a parameter of this node, which others can see and set. It throws if the value does not fit.
   * @param {string} name @param {any} [value] unless the node was made with another; it may be left out with a type
   * @param {Options} [options]
   */
  declare(name, value, options) {
    if (!this.#own) throw new Error(say("the page itself has no parameters; make a node with ros.node()"));
    return this.#own.declare(name, value, options);
  }

  /** The parameters that this node has declared, by name. */
  get declared() {
    return this.#own?.declared ?? new Map();
  }

  /** The time of ROS now, as builtin_interfaces/msg/Time. */
  now() {
    return this.#time.now();
  }

  /**
   * Call `callback` with the time each `period` ms, until the function that this returns is called.
   * @param {number} period @param {(time: {sec: number, nanosec: number}) => void} callback
   * @param {{signal?: AbortSignal}} [options]
   */
  timer(period, callback, options) {
    return this.#time.timer(period, callback, options);
  }

  /** Iterate over the time, each `period` ms. @param {number} period @param {{signal?: AbortSignal}} [options] */
  ticks(period, options) {
    return this.#time.ticks(period, options);
  }

  /** Resolve after `ms`. @param {number} ms @param {{signal?: AbortSignal}} [options] */
  sleep(ms, options) {
    return this.#time.sleep(ms, options);
  }

  /** The full names of all nodes. */
  nodes() {
    return this.#ros.graph.nodes();
  }

  topics() {
    return this.#ros.graph.topics();
  }

  services() {
    return this.#ros.graph.services();
  }

  actions() {
    return actionsOf(this.#ros);
  }

  /**
   * Iterate over what comes into the graph and what leaves it, beginning with what is there.
   * @param {{most?: number, signal?: AbortSignal}} [options] @returns {Stream<GraphEvent>}
   */
  events({ most = 10_000, signal } = {}) {
    return new Stream((push) => {
      /** By gid. @type {Map<number, GraphEvent>} */
      let known = new Map();
      const look = () => {
        const now = new Map(this.#ros.graph.endpoints().map(({ gid, kind, node, name, type }) =>
          [gid, /** @type {GraphEvent} */ ({ change: "come", kind, node, name, type })]));
        for (const [gid, one] of known) if (!now.has(gid)) push({ ...one, change: "gone" });
        for (const [gid, one] of now) if (!known.has(gid)) push(one);
        known = now;
      };
      look();
      return this.#surroundings.watch(look);
    }, { most, signal }, this.#surroundings.closed);
  }

  /**
   * Another node of the page, with a name, a log and parameters of its own.
   * @param {string} name @param {{parameters?: Record<string, any>, signal?: AbortSignal}} [options] `parameters` has
   *   values for those that it declares, such as use_sim_time; `signal` closes it
   */
  node(name, { parameters, signal } = {}) {
    signal?.throwIfAborted();
    const full = fullName(name, this.name);
    if (this.#ros.graph.nodes().includes(full)) {
      console.warn(`there is another node with the name ${full}; ROS cannot tell their parameters and logs apart`);
    }
    const raw = this.#ros.node(full);
    const node = made(raw, () => new Node(this.#ros, raw, full, parameters));
    const { closed } = node.#surroundings;
    const forget = endingWith([signal], () => {
      if (!closed.aborted) node.close();
    });
    closed.addEventListener("abort", forget);
    return node;
  }

  /** Leave the graph and end all streams. The page's own hidden node stays. */
  close() {
    if (!this.name) return;
    this.#surroundings.close();
    this.#raw.leave();
  }

  /** The page itself has the time of its panels. */
  get #time() {
    if (this.#clock) return this.#clock;
    this.#clock = new Clock(this.#raw, this.#surroundings);
    if (!this.name) this.#clock.follow(this.#ros.graph);
    return this.#clock;
  }
}

/** Return the node that `make` makes. If that fails, nothing of it is left. @param {PageNode} raw @param {() => Node} make */
function made(raw, make) {
  try {
    return make();
  } catch (error) {
    raw.leave();
    throw error;
  }
}
