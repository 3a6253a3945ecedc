// @ts-check
// Quality of service, as clients write it.

import { POLICIES } from "../messages/qos.js";
import { Mistake } from "./mistake.js";
import { MOST_QUEUE } from "./limits.js";

/** @import { Qos } from "../protocol.js" */

/** @param {any} given @returns {Partial<Qos>} */
export function qosOf(given) {
  if (!given) return {};
  /** @type {Partial<Qos>} */
  const qos = {};
  for (const [name, values] of Object.entries(POLICIES)) {
    if (given[name] === undefined) continue;
    const value = String(given[name]).toLowerCase();
    const policy = Object.hasOwn(values, value) ? values[value] : undefined;
    if (!policy) throw new Mistake(`qos: ${name} is one of ${Object.keys(values).join(", ")}`);
    Object.assign(qos, policy);
  }
  if (given.depth !== undefined) {
    if (!Number.isInteger(given.depth) || given.depth < 0) throw new Mistake("qos: depth must be a whole number");
    qos.depth = Math.min(MOST_QUEUE, Math.max(1, given.depth));
  }
  for (const name of /** @type {const} */ (["deadline", "lifespan"])) {
    if (given[name] !== undefined) qos[name] = milliseconds(given[name], name);
  }
  return qos;
}

/** @param {any} given @param {string} name */
function milliseconds(given, name) {
  if (["infinite", "best_available"].includes(String(given).toLowerCase())) return Infinity;
  const seconds = typeof given === "object" && given ? Number(given.secs) + Number(given.nsecs) / 1e9 : Number(given);
  if (!(seconds >= 0)) throw new Mistake(`qos: ${name} is a time in seconds, or "infinite"`);
  return seconds * 1000 || Infinity;
}
