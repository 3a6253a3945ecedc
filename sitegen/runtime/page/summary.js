// @ts-check
// What panels ask about a topic or a service.

import { incompatibility } from "../protocol.js";

/** @import { Mismatch } from "../protocol.js" */
/** @import { Channel, Member } from "./graph.js" */

/** @param {[string, Channel]} a @param {[string, Channel]} b */
export function byName([a], [b]) {
  return a < b ? -1 : 1;
}

/** @param {Channel} channel */
export function types({ senders, receivers }) {
  return [...new Set([...senders, ...receivers].map((member) => member.endpoint.type))];
}

/** @param {Set<Member>} members */
export function nodesOf(members) {
  return [...members].map((member) => member.endpoint.node);
}

/** Return the incompatible pairs of a topic. @param {Channel} channel @returns {Mismatch[]} */
export function mismatches({ senders, receivers }) {
  return [...senders].flatMap(({ endpoint: from }) =>
    [...receivers].flatMap(({ endpoint: to }) => {
      const policy = incompatibility(from, to);
      return policy ? [{ publisher: from.node, subscription: to.node, policy }] : [];
    }),
  );
}

/** The number of messages that a subscription missed, 0 for the page's own. @param {Member} member */
export function missed({ owner, endpoint }) {
  return owner.program ? owner.missed.get(endpoint.id) ?? 0 : 0;
}

/** @param {number[]} numbers */
export function sum(numbers) {
  return numbers.reduce((total, number) => total + number, 0);
}
