// @ts-check
// A subscription that asks for what the publishers of its topic offer, also of those that come later.

/** @import { MessageInfo, Qos } from "../protocol.js" */
/** @import { Surroundings } from "./surroundings.js" */

// How long a subscription goes on beside the next one (ms), because messages for it are on their way.
const OVERLAP = 1000;
/** Writers whose last message is remembered. */
const MOST = 1000;

/**
 * Call `begin` with a quality of service, and again, while the first subscription goes on, when publishers have come that
 * offer another. A latched message of such a publisher would be lost otherwise. `isNew` tells whether a message has not
 * been seen by the subscription before.
 * @param {Surroundings} surroundings @param {string} topic @param {Partial<Qos>} wanted by the author or the client
 * @param {(qos: Partial<Qos>, isNew: (info: MessageInfo) => boolean) => () => void} begin @returns {() => void} end
 */
export function adapted(surroundings, topic, wanted, begin) {
  /** The last sequence number by gid of the writer. @type {Map<number, number>} */
  const last = new Map();
  const isNew = (/** @type {MessageInfo} */ { writer, sequence }) => {
    if ((last.get(writer) ?? 0) >= sequence) return false;
    last.set(writer, sequence);
    if (last.size > MOST) for (const old of [...last.keys()].slice(0, MOST / 2)) last.delete(old);
    return true;
  };
  const best = () => {
    const { known, ...offered } = surroundings.qosOf(topic);
    return { known, qos: { ...offered, ...wanted } };
  };
  /** @type {Set<() => void>} */
  const replaced = new Set();
  let { qos } = best();
  let end = begin(qos, isNew);
  const stop = surroundings.watch(() => {
    const { known, qos: now } = best();
    if (!known || (now.reliable === qos.reliable && now.transientLocal === qos.transientLocal)) return;
    const before = end;
    replaced.add(before);
    setTimeout(() => {
      if (replaced.delete(before)) before();
    }, OVERLAP);
    qos = now;
    end = begin(qos, isNew);
  });
  return () => {
    stop();
    for (const one of [...replaced, end]) one();
    replaced.clear();
  };
}
