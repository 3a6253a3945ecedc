// @ts-check
// The naming of ROS2WASM: the topics of services, and the infrastructure of nodes.

import { infrastructureOf } from "../../graphNames.js";

// A service consists of two topics; the form with the underscore is that of early versions.
const PART = /^\/(request|response)_?(\/.+)$/;

/** Return the absolute name of a topic. @param {string} topic */
export function absolute(topic) {
  return topic.startsWith("/") ? topic : `/${topic}`;
}

/**
 * Return the service that a topic may belong to, and whether the topic is for requests; else null.
 * @param {string} name
 */
export function partOf(name) {
  const [, part, service] = PART.exec(name) ?? [];
  return service ? { service, isRequest: part === "request" } : null;
}

/**
 * Return all names of the topic for the requests, or the responses, of a service, including the service's own.
 * @param {string} service @param {boolean} isRequest
 */
export function topicsOf(service, isRequest) {
  const part = isRequest ? "request" : "response";
  return [`/${part}${service}`, `/${part}_${service}`, service];
}

/**
 * Return whether a topic or service is for the log or the parameters of a node, with the node's name if it has one.
 * @param {string} name @returns {{node: string} | null}
 */
export function ownOf(name) {
  return infrastructureOf(partOf(name)?.service ?? name);
}
