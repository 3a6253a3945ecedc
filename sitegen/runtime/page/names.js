// @ts-check
// Which names a worker may use: its endpoints belong to nodes that it has announced, and nobody is the page, or a node
// of site.yaml that runs.

import { PAGE_NODE } from "../graphNames.js";

/** @import { Endpoint, NodeEntry } from "../protocol.js" */

const NODE = /^(?:\/[^/\s\p{C}]+)+$/u;

/**
 * Return whose program a node runs: those of one origin may use each other's names. What the author built from the
 * workspace is of one origin. @param {NodeEntry} entry
 */
export function originOf({ package: from, executable, foreign, ros2wasm }) {
  return ros2wasm?.script ?? (foreign ? `${from}/${executable}` : "");
}

export class Names {
  /** The programs that run under names of site.yaml, by worker. @type {Map<string, Map<number, string>>} */
  #reserved = new Map();

  /** Keep a name for a program that starts. @param {string} name @param {number} worker @param {string} origin */
  reserve(name, worker, origin) {
    const origins = this.#reserved.get(name) ?? new Map();
    this.#reserved.set(name, origins.set(worker, origin));
  }

  /** @param {string} name @param {number} worker that has ended */
  release(name, worker) {
    const origins = this.#reserved.get(name);
    origins?.delete(worker);
    if (!origins?.size) this.#reserved.delete(name);
  }

  /**
   * Return why a worker may not announce an endpoint, or "". Like in ROS, several nodes may have the same name; but while
   * a node of site.yaml runs, only programs of its origin may use its name.
   * @param {Endpoint} endpoint @param {string | undefined} origin of the worker's program; undefined for parts of the page
   * @param {Map<string, number>} nodes those that it has announced
   */
  fault({ kind, node }, origin, nodes) {
    if (origin === undefined) return "";
    if (kind !== "node") return nodes.has(node) ? "" : "of a node that it has not announced";
    if (!NODE.test(node)) return "with an invalid name";
    if (node === PAGE_NODE || node.startsWith(`${PAGE_NODE}/`)) return "with the name of the page";
    const origins = [...this.#reserved.get(node)?.values() ?? [origin]];
    return origins.includes(origin) ? "" : `with the name of another node, ${node}`;
  }
}
