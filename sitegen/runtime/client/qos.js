// @ts-check
// Quality of service as scripts write it: the name of a profile, or policies with the names of ROS or of this API.

import { POLICIES, PROFILES } from "../messages/qos.js";
import { say } from "../ui/words.js";

/** @import { Qos } from "../protocol.js" */
/** @typedef {string | Record<string, any>} GivenQos */

const LIVELINESS = { automatic: { manual: false }, manual_by_topic: { manual: true } };
const FLAGS = /** @type {const} */ (["reliable", "transientLocal", "keepAll", "manual"]);
const TIMES = /** @type {const} */ (["deadline", "lifespan", "lease"]);
const KEYS = ["profile", ...FLAGS, "depth", ...TIMES, ...Object.keys(POLICIES), "liveliness"];

/**
 * Return what was given as policies; those that were not given are left out. Throws an Error that names what is wrong.
 * @param {GivenQos} [given] @returns {Partial<Qos>}
 */
export function qosOf(given = {}) {
  if (typeof given === "string") return { ...oneOf("profile", PROFILES, given) };
  if (typeof given !== "object" || given === null || Array.isArray(given)) {
    throw new TypeError(say("qos must be the name of a profile, such as 'sensor_data', or an object of policies"));
  }
  const { profile, ...policies } = given;
  /** @type {Record<string, any>} */
  const qos = profile === undefined ? {} : { ...oneOf("profile", PROFILES, profile) };
  for (const [key, value] of Object.entries(policies)) {
    if (value === undefined) continue;
    if (Object.hasOwn(POLICIES, key)) Object.assign(qos, oneOf(key, POLICIES[key] ?? {}, value));
    else if (key === "liveliness") Object.assign(qos, oneOf(key, LIVELINESS, value));
    else qos[key] = plain(key, value);
  }
  return qos;
}

/**
 * @template Value @param {string} key @param {Record<string, Value>} values @param {unknown} name
 * @returns {Value}
 */
function oneOf(key, values, name) {
  const lower = String(name).toLowerCase();
  if (Object.hasOwn(values, lower)) return /** @type {Value} */ (values[lower]);
  throw new Error(say("qos: unknown {} '{}'; known are {}", key, String(name).slice(0, 200), Object.keys(values).join(", ")));
}

/** Return the value of a policy that has no names. @param {string} key @param {any} value */
function plain(key, value) {
  const flag = FLAGS.some((one) => one === key);
  const time = TIMES.some((one) => one === key);
  if (!flag && !time && key !== "depth") {
    throw new Error(say("qos: unknown policy '{}'; known are {}", key.slice(0, 200), KEYS.join(", ")));
  }
  const fits = flag ? typeof value === "boolean"
    : typeof value === "number" && value >= 0 && (time || Number.isSafeInteger(value));
  if (fits) return key === "depth" ? Math.max(1, value) : value;
  throw new TypeError(flag ? say("qos: '{}' must be true or false", key)
    : time ? say("qos: '{}' must be a time in ms", key) : say("qos: '{}' must be a whole number", key));
}
