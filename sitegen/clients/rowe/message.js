// @ts-check
// Messages of rowe: JSON objects, with three fields that rowe itself reads.

/**
 * A message that arrived. `timeToLive` is in seconds.
 * @typedef {{body: Record<string, any>, peer: string, messageId?: string, inReplyTo?: string, timeToLive: number}} Message
 */

const OWN = ["message_id", "in_reply_to", "time_to_live"];
const LONGEST = 2 ** 20;
// Objects and arrays in each other.
const DEEPEST = 100;

/**
 * Return a message as JSON, but for its time to live, which `timed` adds when it is sent. Throw if it is invalid.
 * @param {Record<string, any>} body @param {Record<string, string>} fields
 */
export function encode(body, fields) {
  if (typeof body !== "object" || body === null || Array.isArray(body)) throw new Error("a message is a JSON object");
  const taken = OWN.find((name) => Object.hasOwn(body, name));
  if (taken) throw new Error(`'${taken}' is a field of rowe; use another name`);
  const text = JSON.stringify({ ...fields, ...body });
  const size = bytes(text);
  if (size > LONGEST) throw new Error(`the message has ${size} bytes; the limit is ${LONGEST}`);
  if (tooDeep(text)) throw new Error(`nested more than ${DEEPEST} levels deep`);
  return text;
}

/** Return a message with the time that it has left (s). @param {string} text @param {number} timeToLive */
export function timed(text, timeToLive) {
  if (timeToLive === Infinity) return text;
  const field = `{"time_to_live":${Math.max(timeToLive, 0).toFixed(6)}`;
  return text === "{}" ? `${field}}` : `${field},${text.slice(1)}`;
}

/** Read a message; return what is wrong with it if it is invalid. @param {any} data @param {string} peer */
export function decode(data, peer) {
  if (typeof data !== "string") return "not a text frame";
  if (bytes(data) > LONGEST) return `larger than ${LONGEST} bytes`;
  if (tooDeep(data)) return `nested more than ${DEEPEST} levels deep`;
  let body;
  try {
    body = JSON.parse(data);
  } catch (error) {
    return `not valid JSON: ${error instanceof Error ? error.message : error}`;
  }
  if (typeof body !== "object" || body === null || Array.isArray(body)) return "not a JSON object";
  const { message_id: messageId, in_reply_to: inReplyTo, time_to_live: timeToLive = Infinity, ...rest } = body;
  for (const [name, value] of Object.entries({ message_id: messageId, in_reply_to: inReplyTo })) {
    // Python's None is null.
    if (value !== undefined && value !== null && typeof value !== "string") return `${name}: must be text`;
  }
  if (typeof timeToLive !== "number" || !(timeToLive >= 0)) return "time_to_live: must be a number of seconds, 0 or more";
  const ids = { messageId: messageId ?? undefined, inReplyTo: inReplyTo ?? undefined };
  return /** @type {Message} */ ({ body: rest, peer, ...ids, timeToLive });
}

/** The size of a text as UTF-8, exact only where it matters. @param {string} text */
function bytes(text) {
  return text.length * 3 <= LONGEST ? text.length : new TextEncoder().encode(text).length;
}

/** Whether values are nested too deeply in a text. Most texts have too few brackets. @param {string} text */
function tooDeep(text) {
  let at = -1;
  for (let count = 0; count <= DEEPEST; count += 1) {
    at = nextBegin(text, at + 1);
    if (at < 0) return false;
  }
  let depth = 0;
  for (const [token] of text.matchAll(/"(?:[^"\\]|\\.)*"|[[{\]}]/g)) {
    if (token === "[" || token === "{") depth += 1;
    else if (token === "]" || token === "}") depth -= 1;
    if (depth > DEEPEST) return true;
  }
  return false;
}

/** @param {string} text @param {number} from */
function nextBegin(text, from) {
  for (let at = from; at < text.length; at += 1) {
    const code = text.charCodeAt(at);
    if (code === 0x5b || code === 0x7b) return at;
  }
  return -1;
}
