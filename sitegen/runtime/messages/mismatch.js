// @ts-check
// Say in words why two nodes on a topic do not hear each other.

import { say } from "../ui/words.js";

/** @import { Mismatch, Policy } from "../protocol.js" */

/** @type {Record<Policy, string>} */
const REASONS = {
  RELIABILITY: say("Reliability: the subscription requests reliable, the publisher offers best effort"),
  DURABILITY: say("Durability: the subscription requests transient local, and so earlier messages, but the publisher is volatile and keeps none"),
  DEADLINE: say("Deadline: the subscription requests a shorter period than the publisher offers"),
  LIVELINESS: say("Liveliness: the subscription requests stricter liveliness than the publisher offers"),
  TYPE: say("Type: the topic has different message types"),
};

/** @param {Mismatch} mismatch */
export function explain({ publisher, subscription, policy }) {
  return `${say("{} does not receive messages from {}.", subscription, publisher)} ${REASONS[policy]}`;
}
