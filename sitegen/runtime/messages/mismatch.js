// @ts-check
// Say in words why two nodes on a topic do not hear each other.

import { say } from "../ui/words.js";

/** @import { Mismatch, Policy } from "../protocol.js" */

/** @type {Record<Policy, string>} */
const REASONS = {
  RELIABILITY: say("Reliability: the subscription asks for reliable, the publisher offers best effort"),
  DURABILITY: say("Durability: the subscription asks for transient local, so for earlier messages too; the publisher is volatile and keeps none"),
  DEADLINE: say("Deadline: the subscription asks for messages at shorter intervals than the publisher promises"),
  LIVELINESS: say("Liveliness: the subscription asks for stricter signs of life than the publisher promises"),
  TYPE: say("Type: they use different message types for the same topic"),
};

/** @param {Mismatch} mismatch */
export function explain({ publisher, subscription, policy }) {
  return `${say("{} does not hear {}.", subscription, publisher)} ${REASONS[policy]}`;
}
