// @ts-check
// Check the messages of workers to the page: a worker may run any program.

import { KINDS } from "../protocol.js";

/** @import { FromWorker, Refusal } from "../protocol.js" */

// The longest names and types, and the longest texts, in characters; and the most entries of a list.
const NAME = 4096;
const TEXT = 2 ** 24;
const LIST = 100_000;

const SEVERITIES = ["debug", "info", "warn", "error", "fatal", "stdout", "stderr", "typed"];
const KEYBOARDS = ["lines", "hidden", "keys", "raw"];

/**
 * What a worker refuses to take from another one, in the words of that one's console.
 * @type {Record<Refusal, string>}
 */
export const REFUSALS = {
  frame: "a frame that is not valid",
  large: "a frame that is too large",
  unmatched: "messages to an endpoint that does not match",
  overrun: "more messages than it had credits for",
  response: "a response to a request that it did not get",
  news: "credits or a sign of life of an endpoint that does not match",
};

/** @typedef {(value: any) => boolean} Check */

/** @type {Check} */
const isText = (value) => typeof value === "string" && value.length <= TEXT;
/** @type {Check} */
const isName = (value) => typeof value === "string" && value.length <= NAME;
/** @type {Check} */
const isCount = (value) => Number.isSafeInteger(value) && value >= 0;
/** A duration or depth; may be Infinity. @type {Check} */
const isLimit = (value) => typeof value === "number" && value >= 0;
/** @type {Check} */
const isId = (value) => Number.isSafeInteger(value) && value > 0 && value < 2 ** 32;
/** Other clients leave out what is false. @type {Check} */
const isFlag = (value) => value === undefined || typeof value === "boolean";

/** @param {any} value @param {Check} check of each entry */
function isList(value, check) {
  return Array.isArray(value) && value.length <= LIST && value.every(check);
}

/** @type {Check} */
function isQos(qos) {
  return typeof qos === "object" && qos !== null &&
    [qos.depth, qos.deadline, qos.lifespan, qos.lease].every(isLimit) &&
    [qos.reliable, qos.transientLocal, qos.keepAll, qos.manual].every(isFlag);
}

/** Whether `endpoint` is a valid Endpoint. @type {Check} */
export function isEndpoint(endpoint) {
  const { id, kind, node, name, type, qos } = endpoint ?? {};
  return isId(id) && KINDS.includes(kind) && [node, name, type].every(isName) && isQos(qos);
}

/** By `op`, whether the rest of a message is valid. @type {Record<FromWorker["op"], Check>} */
const CHECKS = {
  running: () => true,
  create: ({ endpoint }) => isEndpoint(endpoint),
  destroy: ({ id }) => isId(id),
  missed: ({ id, count }) => isId(id) && isCount(count),
  complain: ({ peer, what, count }) =>
    [peer, count].every(isCount) && typeof what === "string" && Object.hasOwn(REFUSALS, what),
  look: () => true,
  settle: () => true,
  lines: ({ lines }) =>
    isList(lines, (line) => isText(line?.text) && SEVERITIES.includes(line.severity)),
  progress: ({ loaded, total }) => [loaded, total].every((bytes) => Number.isFinite(bytes) && bytes >= 0),
  memory: ({ bytes }) => isCount(bytes),
  reading: ({ keyboard }) => KEYBOARDS.includes(keyboard),
  ready: ({ more }) => typeof more === "boolean",
  answer: ({ text }) => isText(text),
  words: ({ text, words }) => isText(text) && isList(words, isText),
  checked: ({ text, line, error }) => isText(text) && isCount(line) && isText(error),
  // Only workers of the page itself have something to tell; who asked for it knows what.
  tell: () => true,
  // Python has exit codes of any size.
  exit: ({ code, error }) => ["number", "bigint"].includes(typeof code) && isText(error),
};

/**
 * Return what is wrong with a message of a worker: its `op`, "of an unknown kind", or "" for a valid one.
 * @param {any} message
 */
export function faultOf(message) {
  const op = message?.op;
  if (typeof op !== "string" || !Object.hasOwn(CHECKS, op)) return "of an unknown kind";
  return CHECKS[/** @type {FromWorker["op"]} */ (op)](message) ? "" : op;
}
