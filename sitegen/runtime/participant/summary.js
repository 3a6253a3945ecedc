// @ts-check
// What panels and programs ask about topics and services.

import { incompatibility } from "../protocol.js";

/** @import { Endpoint, GraphView } from "../protocol.js" */

/** @template {{endpoint: Endpoint}} M @typedef {{senders: Iterable<M>, receivers: Iterable<M>}} Sides of a channel */

/**
 * Return all topics, sorted by name, with their types and nodes.
 * @template {{endpoint: Endpoint}} M
 * @param {Iterable<[string, Sides<M>]>} channels
 * @param {(receiver: M) => number} missed the number of messages that a subscription missed
 * @returns {ReturnType<GraphView["topics"]>}
 */
export function topicsOf(channels, missed) {
  return listed(channels, (from, to, { receivers }) => ({
    publishers: nodesOf(from),
    subscriptions: nodesOf(to),
    missed: [...receivers].reduce((total, receiver) => total + missed(receiver), 0),
    mismatches: from.flatMap((one) => to.flatMap((other) => {
      const policy = incompatibility(one, other);
      return policy ? [{ publisher: one.node, subscription: other.node, policy }] : [];
    })),
  }));
}

/**
 * Return all services, sorted by name, with their types and nodes.
 * @param {Iterable<[string, Sides<{endpoint: Endpoint}>]>} channels @returns {ReturnType<GraphView["services"]>}
 */
export function servicesOf(channels) {
  return listed(channels, (from, to) => ({ servers: nodesOf(to), clients: nodesOf(from) }));
}

/**
 * @template {{endpoint: Endpoint}} M @template T
 * @param {Iterable<[string, Sides<M>]>} channels
 * @param {(senders: Endpoint[], receivers: Endpoint[], sides: Sides<M>) => T} described
 */
function listed(channels, described) {
  return [...channels].sort(([a], [b]) => (a < b ? -1 : 1)).map(([name, sides]) => {
    const [from, to] = [endpoints(sides.senders), endpoints(sides.receivers)];
    return { name, types: [...new Set([...from, ...to].map(({ type }) => type))], ...described(from, to, sides) };
  });
}

/** @param {Iterable<{endpoint: Endpoint}>} members */
function endpoints(members) {
  return Array.from(members, ({ endpoint }) => endpoint);
}

/** @param {Endpoint[]} ends */
function nodesOf(ends) {
  return ends.map(({ node }) => node);
}
