// @ts-check
// The structs and strings of clients/cpp/include/rclcpp/detail/host.h in WebAssembly's memory.

import { KINDS } from "../../protocol.js";

/** @import { Neighbour, Policy, Qos } from "../../protocol.js" */
/** @import { Event } from "../../participant/status.js" */
/** @import { Received } from "../../participant/queue.js" */

const RELIABLE = 1;
const TRANSIENT_LOCAL = 2;
const KEEP_ALL = 4;
const MANUAL = 8;
/** The size of a ros_entry. */
const ENTRY = 48;
/** As rmw numbers them. @type {Partial<Record<Policy, number>>} */
const POLICIES = { DURABILITY: 2, DEADLINE: 4, LIVELINESS: 8, RELIABILITY: 16 };
const decoder = new TextDecoder();
const encoder = new TextEncoder();

/** Read a string that ends with a zero. @param {Uint8Array} heap @param {number} pointer */
export function readText(heap, pointer) {
  return decoder.decode(heap.subarray(pointer, heap.indexOf(0, pointer)));
}

/**
 * Read `count` strings, each of which ends with a zero.
 * @param {Uint8Array} heap @param {number} pointer @param {number} count
 */
export function readTexts(heap, pointer, count) {
  const texts = [];
  for (let at = pointer; texts.length < count; at = heap.indexOf(0, at) + 1) texts.push(readText(heap, at));
  return texts;
}

/**
 * Write up to `capacity` bytes of a text, without a zero at the end, and return their number.
 * @param {Uint8Array} heap @param {number} pointer @param {string} text @param {number} capacity
 */
export function writeText(heap, pointer, text, capacity) {
  const bytes = encoder.encode(text).subarray(0, capacity);
  heap.set(bytes, pointer);
  return bytes.length;
}

/** @param {Uint8Array} heap @param {number} pointer to a ros_qos @returns {Qos} */
export function readQos(heap, pointer) {
  const view = new DataView(heap.buffer, pointer);
  const flags = view.getInt32(28, true);
  return {
    deadline: view.getFloat64(0, true),
    lifespan: view.getFloat64(8, true),
    lease: view.getFloat64(16, true),
    depth: view.getInt32(24, true),
    reliable: (flags & RELIABLE) !== 0,
    transientLocal: (flags & TRANSIENT_LOCAL) !== 0,
    keepAll: (flags & KEEP_ALL) !== 0,
    manual: (flags & MANUAL) !== 0,
  };
}

/** Write a ros_event. @param {Uint8Array} heap @param {number} pointer @param {Event} event */
export function writeEvent(heap, pointer, { total, totalChange, current, currentChange, policy }) {
  const number = (policy && POLICIES[policy]) || 0;
  new Int32Array(heap.buffer, pointer, 5).set([total, totalChange, current, currentChange, number]);
}

/** Write a ros_message_info. @param {Uint8Array} heap @param {number} pointer @param {Received} message */
export function writeInfo(heap, pointer, { timestamp, received, writer, sequence }) {
  const view = new DataView(heap.buffer, pointer);
  view.setFloat64(0, timestamp, true);
  view.setFloat64(8, received, true);
  view.setFloat64(16, writer, true);
  view.setUint32(24, sequence, true);
}

/** Encode endpoints for ros_read: a ros_entry for each, followed by its strings. @param {Neighbour[]} neighbours */
export function encodeGraph(neighbours) {
  const all = neighbours.map(({ gid, endpoint }) => {
    const texts = encoder.encode(`${endpoint.node}\0${endpoint.name}\0${endpoint.type}\0`);
    return { gid, endpoint, texts, size: Math.ceil((ENTRY + texts.length) / 8) * 8 };
  });
  const bytes = new Uint8Array(all.reduce((sum, { size }) => sum + size, 0));
  const view = new DataView(bytes.buffer);
  let at = 0;
  for (const { gid, endpoint, texts, size } of all) {
    view.setFloat64(at, gid, true);
    if (endpoint.qos) writeQos(view, at + 8, endpoint.qos);
    view.setInt32(at + 40, KINDS.indexOf(endpoint.kind), true);
    view.setInt32(at + 44, size, true);
    bytes.set(texts, at + ENTRY);
    at += size;
  }
  return bytes;
}

/** @param {DataView} view @param {number} at @param {Qos} qos */
function writeQos(view, at, qos) {
  view.setFloat64(at, qos.deadline, true);
  view.setFloat64(at + 8, qos.lifespan, true);
  view.setFloat64(at + 16, qos.lease, true);
  view.setInt32(at + 24, qos.depth, true);
  const flags = (qos.reliable ? RELIABLE : 0) | (qos.transientLocal ? TRANSIENT_LOCAL : 0) |
    (qos.keepAll ? KEEP_ALL : 0) | (qos.manual ? MANUAL : 0);
  view.setInt32(at + 28, flags, true);
}
