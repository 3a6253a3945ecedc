// @ts-check
// Quality of service by the names of ROS.

/** @import { Qos } from "../protocol.js" */

/** The policies of ROS with their values. @type {Record<string, Record<string, Partial<Qos>>>} */
export const POLICIES = {
  history: { keep_last: { keepAll: false }, keep_all: { keepAll: true } },
  reliability: { reliable: { reliable: true }, best_effort: { reliable: false }, best_available: {} },
  durability: { transient_local: { transientLocal: true }, volatile: { transientLocal: false }, best_available: {} },
};
/** The profiles of ROS, as far as they differ from what its name stands for there. @type {Record<string, Partial<Qos>>} */
export const PROFILES = {
  default: { depth: 10, reliable: true, transientLocal: false },
  system_default: {},
  best_available: {},
  sensor_data: { depth: 5, reliable: false, transientLocal: false },
  services_default: { depth: 10, reliable: true, transientLocal: false },
  parameters: { depth: 1000, reliable: true, transientLocal: false },
  parameter_events: { depth: 1000, reliable: true, transientLocal: false },
  action_status_default: { depth: 1, reliable: true, transientLocal: true },
};
