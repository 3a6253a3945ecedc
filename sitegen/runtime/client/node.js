// @ts-check
// A node of the page, as scripts use it.

import { actionsOf } from "../messages/actionClient.js";
import { Action } from "./action.js";
import { fullName, fullType } from "./names.js";
import { Parameters } from "./parameters.js";
import { Service } from "./service.js";
import { Stream } from "./stream.js";
import { Surroundings } from "./surroundings.js";
import { Tf } from "./tf.js";
import { Topic } from "./topic.js";

/** @import { Endpoint, PageNode, Qos, Ros } from "../protocol.js" */
/** @typedef {{change: "come" | "gone", kind: Endpoint["kind"], node: string, name: string, type: string}} GraphEvent */

export class Node {
  #ros;
  #raw;
  #surroundings;

  /** @param {Ros} ros of the page @param {PageNode} raw the same, or another node of the page @param {string} name */
  constructor(ros, raw, name) {
    this.#ros = ros;
    this.#raw = raw;
    this.#surroundings = new Surroundings(ros);
    /** Empty for the page's own hidden node. */
    this.name = name;
    this.tf = new Tf(raw, this.#surroundings);
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
   * @param {string} name @param {string} [type] @param {Partial<Qos>} [qos]
   */
  topic(name, type = "", qos = {}) {
    return new Topic(this.#raw, this.#surroundings, fullName(name, this.name), type && fullType(type, "msg"), qos);
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
    return new Parameters(this.#raw, this.#surroundings, fullName(node));
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

  /** Another node of the page, with a name of its own. @param {string} name */
  node(name) {
    const full = fullName(name);
    return new Node(this.#ros, this.#ros.node(full), full);
  }

  /** Leave the graph and end all streams. The page's own hidden node stays. */
  close() {
    if (!this.name) return;
    this.#surroundings.close();
    this.#raw.leave();
  }
}
