// @ts-check
// Say in words why two nodes on a topic do not hear each other.

/** @import { Mismatch, Policy } from "../protocol.js" */

/** @type {Record<Policy, string>} */
const REASONS = {
  RELIABILITY: "Reliability: the subscription asks for reliable, the publisher offers best effort",
  DURABILITY: "Durability: the subscription asks for transient local, so for earlier messages too; the publisher is volatile and keeps none",
  DEADLINE: "Deadline: the subscription asks for messages at shorter intervals than the publisher promises",
  LIVELINESS: "Liveliness: the subscription asks for stricter signs of life than the publisher promises",
  TYPE: "Type: they use different message types for the same topic",
};

/** @param {Mismatch} mismatch */
export function explain({ publisher, subscription, policy }) {
  return `${subscription} does not hear ${publisher}. ${REASONS[policy]}`;
}
