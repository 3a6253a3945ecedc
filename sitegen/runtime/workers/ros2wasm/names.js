// @ts-check
// The names of the ROS2WASM project: which topics make up a service, and what each node has for itself.

import { infrastructureOf } from "../../graphNames.js";

// A service is two topics to its middleware; the second form is that of its first versions.
const PART = /^\/(request|response)_?(\/.+)$/;

/** The name in the graph that a script means by `topic`. @param {string} topic */
export function absolute(topic) {
  return topic.startsWith("/") ? topic : `/${topic}`;
}

/**
 * The service that a topic belongs to, if it may be of one, and whether requests travel on it.
 * @param {string} name
 */
export function partOf(name) {
  const [, part, service] = PART.exec(name) ?? [];
  return service ? { service, isRequest: part === "request" } : null;
}

/**
 * All names of the topic for requests, or for responses, of a service: its own is one of them.
 * @param {string} service @param {boolean} isRequest
 */
export function topicsOf(service, isRequest) {
  const part = isRequest ? "request" : "response";
  return [`/${part}${service}`, `/${part}_${service}`, service];
}

/**
 * Whether a topic or service is one that each node has for its log and its parameters, and the node's
 * name where it tells.
 * @param {string} name @returns {{node: string} | null}
 */
export function ownOf(name) {
  return infrastructureOf(partOf(name)?.service ?? name);
}
