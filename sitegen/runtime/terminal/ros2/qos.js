// @ts-check
// The quality of service of the topics that verbs publish and subscribe to.

import { PROFILES } from "../../messages/qos.js";
import { DEFAULT_QOS } from "../../protocol.js";
import { FLOAT, INT } from "../args/types.js";
import { endpoints, option } from "./verb.js";

/** @import { Qos } from "../../protocol.js" */
/** @import { Io } from "../shell/shell.js" */

// The messages that a subscription keeps at least, while the page draws.
const LEAST = 100;

const POLICIES = {
  profile: ["unknown", "default", "system_default", "sensor_data", "services_default", "parameters", "parameter_events", "action_status_default", "best_available"],
  history: ["system_default", "keep_last", "keep_all", "unknown"],
  reliability: ["system_default", "reliable", "best_effort", "unknown", "best_available"],
  durability: ["system_default", "transient_local", "volatile", "unknown", "best_available"],
  liveliness: ["system_default", "automatic", "manual_by_topic", "unknown", "best_available"],
};

/**
 * QoS options. @param {"subscribe" | "publish"} does what the verb does with a topic
 * @param {"sensor_data" | "default"} profile without options
 */
export function qosOptions(does, profile) {
  const overrides = (/** @type {string} */ what) => `(overrides ${what} value of --qos-profile option`;
  const setting = (/** @type {string} */ what) => `Quality of service ${what} setting to ${does} with`;
  const fitting = "default: Compatible profile with running endpoints )";
  return [
    option("qos_profile", ["--qos-profile"], `Quality of service preset profile to ${does} with (default: ${profile})`, { choices: POLICIES.profile, initial: profile }),
    option("qos_depth", ["--qos-depth"], `Queue size setting to ${does} with ${overrides("depth")})`, { metavar: "N", type: INT }),
    option("qos_history", ["--qos-history"], `History of samples setting to ${does} with ${overrides("history")}, default: keep_last)`, { choices: POLICIES.history }),
    option("qos_reliability", ["--qos-reliability"], `${setting("reliability")} ${overrides("reliability")}, ${fitting}`, { choices: POLICIES.reliability }),
    option("qos_durability", ["--qos-durability"], `${setting("durability")} ${overrides("durability")}, ${fitting}`, { choices: POLICIES.durability }),
    option("qos_liveliness", ["--qos-liveliness"], `${setting("liveliness")} ${overrides("liveliness")}`, { choices: POLICIES.liveliness }),
    option("qos_lease", ["--qos-liveliness-lease-duration-seconds"], `${setting("liveliness lease duration")} ${overrides("liveliness lease duration")}`, { type: FLOAT, metavar: "QOS_LIVELINESS_LEASE_DURATION_SECONDS" }),
  ];
}

/** The QoS that the options of a publisher ask for. @param {any} args @returns {Qos} */
export function qosOf(args) {
  const qos = { ...DEFAULT_QOS, ...PROFILES[args.qos_profile] };
  if (args.qos_depth > 0) qos.depth = args.qos_depth;
  if (args.qos_history) qos.keepAll = args.qos_history === "keep_all";
  if (args.qos_reliability) qos.reliable = args.qos_reliability === "reliable";
  if (args.qos_durability) qos.transientLocal = args.qos_durability === "transient_local";
  if (args.qos_liveliness) qos.manual = args.qos_liveliness === "manual_by_topic";
  if (args.qos_lease > 0) qos.lease = args.qos_lease * 1000;
  return qos;
}

/**
 * The QoS of a subscription: that of its options or, without any, one that fits all publishers of the topic.
 * @param {Io} io @param {any} args @param {string} topic @returns {Promise<Qos>}
 */
export async function subscriptionQos({ ros, out }, args, topic) {
  const qos = qosOf(args);
  if (args.qos_depth === undefined) qos.depth = Math.max(qos.depth, LEAST);
  const asked = [args.qos_depth, args.qos_history, args.qos_reliability, args.qos_durability, args.qos_liveliness, args.qos_lease];
  const publishers = endpoints(ros, { kind: "publisher", name: topic });
  if (asked.some((one) => one !== undefined) || !publishers.length) return qos;
  for (const [key, offered, other] of FALLBACKS) {
    const count = publishers.filter(({ qos: { [key]: strong } }) => strong).length;
    qos[key] = count === publishers.length;
    if (count && !qos[key]) {
      await out(`Some, but not all, publishers are offering ${offered}. Falling back to ${other} as it will connect to all publishers\n`);
    }
  }
  return qos;
}

/** @type {["reliable" | "transientLocal", string, string][]} */
const FALLBACKS = [
  ["reliable", "QoSReliabilityPolicy.RELIABLE", "QoSReliabilityPolicy.BEST_EFFORT"],
  ["transientLocal", "QoSDurabilityPolicy.TRANSIENT_LOCAL", "QoSDurabilityPolicy.VOLATILE"],
];
