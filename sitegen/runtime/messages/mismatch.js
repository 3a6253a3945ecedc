// @ts-check
// Explain why two endpoints of a topic are incompatible.

import { say } from "../ui/words.js";

/** @import { Mismatch, Policy } from "../protocol.js" */

/** @type {Record<Policy, string>} */
const REASONS = {
  RELIABILITY: say("Reliability: the subscription requests reliable, the publisher offers best effort"),
  DURABILITY: say("Durability: the subscription requests transient local, the publisher offers volatile and keeps no earlier messages"),
  DEADLINE: say("Deadline: the subscription requests a shorter period than the publisher offers"),
  LIVELINESS: say("Liveliness: the subscription requests a stricter policy than the publisher offers"),
  TYPE: say("Type: they use different message types for the same topic"),
};

/** @param {Mismatch} mismatch */
export function explain({ publisher, subscription, policy }) {
  return `${say("{} does not receive from {}.", subscription, publisher)} ${REASONS[policy]}`;
}
