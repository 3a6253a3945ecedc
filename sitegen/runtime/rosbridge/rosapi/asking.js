// @ts-check
// The order of requests about nodes: a node that is silent delays nobody but those who ask for it.

import { Parameters } from "../../client/parameters.js";

/** @import { Session } from "../session.js" */

/** How long a node may take to answer what all nodes are asked (ms). */
const BRIEF = 1000;

export class Asking {
  #session;
  /** The last request about each node; that of "" is about all nodes. @type {Map<string, Promise<unknown>>} */
  #last = new Map();
  /** The nodes that have not answered in time, until they do. @type {Set<string>} */
  #silent = new Set();
  /** What has not been answered, by node. @type {Set<string>} */
  #asked = new Set();

  /** @param {Session} session */
  constructor(session) {
    this.#session = session;
  }

  /**
   * Answer a request about a node, or with "" about all nodes, after those before: what was set is what is read.
   * @template Answer @param {string} node @param {() => Promise<Answer>} answer @returns {Promise<Answer>}
   */
  inTurn(node, answer) {
    const own = this.#before(node).then(answer);
    const ended = own.catch(() => {}).then(() => {
      if (this.#last.get(node) === ended) this.#last.delete(node);
    });
    this.#last.set(node, ended);
    return own;
  }

  /**
   * Return what all nodes answer that answer soon.
   * @template Answer
   * @param {string[]} nodes @param {(parameters: Parameters) => Promise<Answer[]>} ask
   * @returns {Promise<Answer[]>}
   */
  async all(nodes, ask) {
    // One that is silent has a request already, which it will answer first.
    const answers = await Promise.all(nodes.filter((node) => !this.#asked.has(node)).map((node) => this.#one(node, ask)));
    return answers.flat();
  }

  /** @param {string} node @returns {Promise<unknown>} */
  #before(node) {
    if (node) return Promise.all([this.#last.get(node), this.#last.get("")]);
    const others = [...this.#last].filter(([name]) => name && !this.#silent.has(name)).map(([, last]) => last);
    return Promise.all([this.#last.get(""), soon(Promise.all(others), () => [])]);
  }

  /**
   * @template Answer
   * @param {string} node @param {(parameters: Parameters) => Promise<Answer[]>} ask @returns {Promise<Answer[]>}
   */
  #one(node, ask) {
    const { raw, surroundings } = this.#session;
    /** @type {Answer[]} */
    const none = [];
    this.#asked.add(node);
    const answer = ask(new Parameters(raw, surroundings, node)).then((found) => {
      this.#silent.delete(node);
      return found;
    }, () => none).finally(() => this.#asked.delete(node));
    if (this.#silent.has(node)) return Promise.resolve(none);
    return soon(answer, () => {
      this.#silent.add(node);
      return none;
    });
  }
}

/**
 * Resolve as a promise does, or soon, with what `otherwise` returns.
 * @template Answer @param {Promise<Answer>} answer @param {() => Answer} otherwise @returns {Promise<Answer>}
 */
function soon(answer, otherwise) {
  return new Promise((resolve) => {
    const timer = setTimeout(() => resolve(otherwise()), BRIEF);
    answer.then(resolve).finally(() => clearTimeout(timer));
  });
}
