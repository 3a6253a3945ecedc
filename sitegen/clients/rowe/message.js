// @ts-check
// Messages of rowe: JSON objects, with three fields that rowe itself reads.

/**
 * A message that arrived. `timeToLive` is in seconds.
 * @typedef {{body: Record<string, any>, peer: string, messageId?: string, inReplyTo?: string, timeToLive: number}} Message
 */

const OWN = ["message_id", "in_reply_to", "time_to_live"];
const LONGEST = 2 ** 20;

/**
 * Return a message as JSON. Throw if it is invalid.
 * @param {Record<string, any>} body @param {Record<string, string>} fields @param {number} timeToLive in seconds
 */
export function encode(body, fields, timeToLive) {
  if (typeof body !== "object" || body === null || Array.isArray(body)) throw new Error("a message is a JSON object");
  const taken = OWN.find((name) => Object.hasOwn(body, name));
  if (taken) throw new Error(`'${taken}' is a field of rowe; use another name`);
  const time = timeToLive < Infinity ? { time_to_live: Math.max(timeToLive, 0) } : {};
  const text = JSON.stringify({ ...fields, ...time, ...body });
  if (text.length > LONGEST) throw new Error(`the message has ${text.length} bytes; the limit is ${LONGEST}`);
  return text;
}

/** Read a message; return what is wrong with it if it is invalid. @param {any} data @param {string} peer */
export function decode(data, peer) {
  if (typeof data !== "string") return "not a text frame";
  if (data.length > LONGEST) return "too long";
  let body;
  try {
    body = JSON.parse(data);
  } catch (error) {
    return `not valid JSON: ${error instanceof Error ? error.message : error}`;
  }
  if (typeof body !== "object" || body === null || Array.isArray(body)) return "not a JSON object";
  const { message_id: messageId, in_reply_to: inReplyTo, time_to_live: timeToLive = Infinity, ...rest } = body;
  for (const [name, value] of Object.entries({ message_id: messageId, in_reply_to: inReplyTo })) {
    if (value !== undefined && typeof value !== "string") return `${name}: must be text`;
  }
  if (typeof timeToLive !== "number" || !(timeToLive >= 0)) return "time_to_live: must be a number of seconds, 0 or more";
  return /** @type {Message} */ ({ body: rest, peer, messageId, inReplyTo, timeToLive });
}
