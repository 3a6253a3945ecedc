// @ts-check
// Which endpoints of a page and of remote nodes meet each other, and under which names.

import { infrastructureOf, isHidden } from "../graphNames.js";

/** @import { Endpoint } from "../protocol.js" */
/** @import { Connect, Names } from "./orders.js" */

const ACTION = /^(.+)\/_action\/\w+$/;

/** What a connection lets through. */
export class Scope {
  #send;
  #receive;
  #prefix;
  #rates;

  /** @param {Connect} connect */
  constructor({ send, receive, namespace, rates }) {
    this.#send = filterOf(send);
    this.#receive = filterOf(receive);
    this.#prefix = namespace ?? "";
    this.#rates = Object.entries(rates ?? {}).map(([name, rate]) => ({ pattern: patternOf(name), rate }));
  }

  /**
   * Whether others are told of an endpoint of the page. Publishers and services offer something; subscriptions and
   * clients get something.
   * @param {Pick<Endpoint, "kind" | "name">} endpoint
   */
  shows({ kind, name }) {
    return kind === "node" || (offers(kind) ? this.#send : this.#receive)(kind, name);
  }

  /** Whether the page is told of a remote endpoint. @param {Pick<Endpoint, "kind" | "name">} endpoint */
  admits({ kind, name }) {
    return kind === "node" || (offers(kind) ? this.#receive : this.#send)(kind, name);
  }

  /** The name elsewhere of something of the page. @param {string} name */
  outside(name) {
    return this.#prefix + name;
  }

  /** The name in the page of something elsewhere. @param {string} name */
  inside(name) {
    return this.#prefix && name.startsWith(`${this.#prefix}/`) ? name.slice(this.#prefix.length) : name;
  }

  /** The largest number of messages per second that the page gets of a topic, if any. @param {string} topic */
  rate(topic) {
    return this.#rates.find(({ pattern }) => pattern.test(topic))?.rate;
  }
}

/** @param {Endpoint["kind"]} kind */
function offers(kind) {
  return kind === "publisher" || kind === "service";
}

/** @param {Names} [names] all, if undefined @returns {(kind: Endpoint["kind"], name: string) => boolean} */
function filterOf(names) {
  if (!names) return () => true;
  const matcher = (/** @type {string[]} */ patterns = []) => {
    const known = patterns.map(patternOf);
    return (/** @type {string} */ name) => known.some((pattern) => pattern.test(name));
  };
  const [topics, services, actions] = [matcher(names.topics), matcher(names.services), matcher(names.actions)];
  return (kind, name) => {
    // The log and the parameters of a node belong to it.
    if (infrastructureOf(name)) return true;
    const action = ACTION.exec(name);
    if (action) return actions(action[1] ?? "");
    return (kind === "publisher" || kind === "subscription" ? topics : services)(name);
  };
}

/** @param {string} text */
function patternOf(text) {
  const parts = text.split(/(\*\*|\*)/).map((part) => {
    if (part === "**") return ".*";
    return part === "*" ? "[^/]*" : part.replace(/[.*+?^${}()|[\]\\]/g, "\\$&");
  });
  return new RegExp(`^${parts.join("")}$`);
}

/** Whether a node is not shown elsewhere. @param {string} node */
export function isPrivate(node) {
  return isHidden(node);
}
