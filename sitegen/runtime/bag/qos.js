// @ts-check
// Quality of service as the metadata of bags has it: the YAML that rosbag2 writes.

import { DEFAULT_QOS } from "../protocol.js";
import { FAILSAFE_SCHEMA, load } from "../vendor/yaml.js";

/** @import { Qos } from "../protocol.js" */

// What stands for no limit: the largest duration of ROS.
const FOREVER = { sec: "9223372036", nsec: "854775807" };
// Longer texts are not read.
const LONGEST = 100_000;

// Before Iron, policies are numbers.
const RELIABLE = ["reliable", "1", "system_default", "0"];
const LATCHED = ["transient_local", "1"];
const KEEP_ALL = ["keep_all", "2"];

/** Return the profiles that publishers offer. @param {Qos[]} all */
export function writeProfiles(all) {
  return all.map((qos) => `- history: ${qos.keepAll ? "keep_all" : "keep_last"}
  depth: ${qos.keepAll ? 0 : qos.depth}
  reliability: ${qos.reliable ? "reliable" : "best_effort"}
  durability: ${qos.transientLocal ? "transient_local" : "volatile"}
  deadline:
${duration(qos.deadline)}
  lifespan:
${duration(qos.lifespan)}
  liveliness: ${qos.manual ? "manual_by_topic" : "automatic"}
  liveliness_lease_duration:
${duration(qos.lease)}
  avoid_ros_namespace_conventions: false`).join("\n");
}

/** @param {number} milliseconds */
function duration(milliseconds) {
  const { sec, nsec } = milliseconds === Infinity
    ? FOREVER
    : { sec: Math.floor(milliseconds / 1000), nsec: Math.round((milliseconds % 1000) * 1e6) };
  return `    sec: ${sec}\n    nsec: ${nsec}`;
}

/**
 * Return the quality of service that a topic is played with: what all recorded publishers offered. What cannot be
 * read is the default, and so are deadlines, lifespans and leases: a bag that is paused would miss them.
 * @param {string} text @returns {Qos}
 */
export function readProfiles(text) {
  const profiles = profilesOf(text);
  if (profiles.length === 0) return DEFAULT_QOS;
  const all = (/** @type {string} */ name, /** @type {string[]} */ values) =>
    profiles.every((profile) => values.includes(String(profile[name])));
  const depths = profiles.map(({ depth }) => Number(depth)).filter((depth) => depth > 0 && depth < 1e6);
  return {
    ...DEFAULT_QOS,
    depth: depths.length ? Math.max(...depths) : DEFAULT_QOS.depth,
    keepAll: all("history", KEEP_ALL),
    reliable: all("reliability", RELIABLE),
    transientLocal: all("durability", LATCHED),
  };
}

/** @param {string} text @returns {Record<string, unknown>[]} */
function profilesOf(text) {
  if (!text || text.length > LONGEST) return [];
  try {
    const found = load(text, { schema: FAILSAFE_SCHEMA });
    return Array.isArray(found) ? found.filter((one) => one && typeof one === "object") : [];
  } catch {
    return [];
  }
}
