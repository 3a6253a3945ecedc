// @ts-check
// Read and write what travels to a gateway (docs/gateway-protocol.md). What comes is checked: it may be any server.

import { HEAD_SIZE, KINDS, readRecords, recordSize, writeHead } from "../protocol.js";

/** @import { Endpoint, Head, MessageType, Qos } from "../protocol.js" */

/** @typedef {Endpoint & {hash: string}} RemoteEndpoint */

export const PROTOCOL = "sitegen.1";
/** Of a record of a topic: it was sent before the page looked. */
export const LATCHED = 1;

// Names, and endpoints in one message.
const LONGEST = 255;
const MOST = 100_000;
const TYPE = /^[a-z]\w*\/(msg|srv|action)\/[A-Z]\w*$/;
const FRAME = 64 * 1024;

/**
 * Return the message in a text, or undefined if it is none.
 * @param {string} text @returns {any}
 */
export function parse(text) {
  try {
    const message = JSON.parse(text);
    return typeof message?.op === "string" ? message : undefined;
  } catch {
    return undefined;
  }
}

/** Whether a text is the name of an interface, such as std_msgs/msg/String. @param {string} text */
export function isType(text) {
  return TYPE.test(text);
}

/** Return the endpoints of a list that are valid. @param {unknown} given @returns {RemoteEndpoint[]} */
export function endpointsOf(given) {
  if (!Array.isArray(given) || given.length > MOST) return [];
  return given.flatMap((one) => {
    const { id, kind, node, name, type, hash = "", qos } = one ?? {};
    const texts = [node, name, type, hash].every((text) => typeof text === "string" && text.length <= LONGEST);
    return isId(id) && KINDS.includes(kind) && texts ? [{ id, kind, node, name, type, hash, qos: qosOf(qos) }] : [];
  });
}

/** Return the ids of a list that are valid. @param {unknown} given @returns {number[]} */
export function idsOf(given) {
  return Array.isArray(given) ? given.filter(isId) : [];
}

/** Return the definitions of types that are valid. @param {any} given @returns {Record<string, MessageType>} */
export function typesOf(given) {
  const isText = (/** @type {unknown} */ text) => typeof text === "string" && text.length <= LONGEST;
  const valid = Object.entries(given ?? {}).slice(0, MOST).filter(([name, one]) =>
    isType(name) && Array.isArray(one?.fields) && one.fields.every(
      (/** @type {any} */ field) => isText(field?.name) && isText(field?.type)));
  return Object.fromEntries(valid.map(([name, { fields }]) =>
    [name, { fields: fields.map((/** @type {any} */ { name, type }) => ({ name, type })), constants: [] }]));
}

/** @param {any} given @returns {Qos} */
function qosOf(given) {
  const time = (/** @type {unknown} */ value) => (typeof value === "number" && value > 0 ? value : Infinity);
  const { depth, reliable, transientLocal, keepAll, deadline, lifespan, manual, lease } = given ?? {};
  return {
    depth: Number.isSafeInteger(depth) && depth > 0 ? Math.min(depth, MOST) : 10,
    reliable: reliable === true,
    transientLocal: transientLocal === true,
    keepAll: keepAll === true,
    manual: manual === true,
    deadline: time(deadline),
    lifespan: time(lifespan),
    lease: time(lease),
  };
}

/** @param {Qos} qos */
export function writtenQos(qos) {
  const time = (/** @type {number} */ value) => (value === Infinity ? null : value);
  return { ...qos, deadline: time(qos.deadline), lifespan: time(qos.lifespan), lease: time(qos.lease) };
}

/**
 * Call `deliver` for each record of a frame; return false if it is not valid.
 * @param {ArrayBuffer} frame @param {(head: Head, message: Uint8Array) => void} deliver
 */
export function deliverFrame(frame, deliver) {
  return readRecords(frame, deliver) === 0;
}

/** Records on their way into frames. */
export class Frames {
  #send;
  #frame = new Uint8Array(FRAME);
  #used = 0;

  /** @param {(frame: Uint8Array<ArrayBuffer>) => void} send */
  constructor(send) {
    this.#send = send;
  }

  /** @param {Head} head @param {Uint8Array} message */
  add(head, message) {
    const size = recordSize(message.length);
    if (this.#used + size > FRAME) this.flush();
    if (size > FRAME) {
      const frame = new Uint8Array(size);
      writeHead(frame, 0, head, message.length);
      frame.set(message, HEAD_SIZE);
      this.#send(frame);
      return;
    }
    writeHead(this.#frame, this.#used, head, message.length);
    this.#frame.set(message, this.#used + HEAD_SIZE);
    this.#used += size;
  }

  flush() {
    if (this.#used === 0) return;
    this.#send(this.#frame.slice(0, this.#used));
    this.#used = 0;
  }
}

/** @param {unknown} value */
function isId(value) {
  return Number.isSafeInteger(value) && Number(value) > 0 && Number(value) < 2 ** 32;
}
