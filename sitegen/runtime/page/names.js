// @ts-check
// Which names a worker may use: its endpoints belong to nodes that it has announced, and nobody is the page.

import { PAGE_NODE } from "../graphNames.js";

/** @import { Endpoint } from "../protocol.js" */

const NODE = /^(?:\/[^/\s\p{C}]+)+$/u;

export class Names {
  /** The programs to which site.yaml gives a name. @type {Map<string, Set<string>>} */
  #reserved = new Map();

  /** Keep a name for a program. @param {string} name @param {string} origin */
  reserve(name, origin) {
    const origins = this.#reserved.get(name) ?? new Set();
    this.#reserved.set(name, origins.add(origin));
  }

  /**
   * Return why a worker may not announce an endpoint, or "". Like in ROS, several nodes may have the same name; but a
   * name from site.yaml is that of its own program only.
   * @param {Endpoint} endpoint @param {string | undefined} origin of the worker's program; undefined for parts of the page
   * @param {Map<string, number>} nodes those that it has announced
   */
  fault({ kind, node }, origin, nodes) {
    if (origin === undefined) return "";
    if (kind !== "node") return nodes.has(node) ? "" : "of a node that it has not announced";
    if (!NODE.test(node)) return "with an invalid name";
    if (node === PAGE_NODE || node.startsWith(`${PAGE_NODE}/`)) return "with the name of the page";
    const origins = this.#reserved.get(node);
    return origins && !origins.has(origin) ? `with the name of another node, ${node}` : "";
  }
}
