// @ts-check
// Definitions of types, as rosapi describes them.

import { isMessage, parseFieldType } from "../../messages/fieldType.js";
import { fullType } from "../../client/names.js";
import { short } from "../values.js";
import { NAMES, pythonText } from "./python.js";
import { textsOf } from "./texts.js";

/** @import { MessageType } from "../../protocol.js" */
/** @import { Values } from "../values.js" */

const LINE = "=".repeat(80);
/** A part of a service or an action. */
export const PARTS = /^(.+?)_((SendGoal_|GetResult_)?(Request|Response)|Goal|Result|Feedback|FeedbackMessage)$/;
/** The types of ROS 1 that are not messages. */
const TIMES = ["time", "duration"];

/**
 * Return the definitions of a type and of all types nested in it, as rosapi_msgs/msg/TypeDef.
 * @param {Values} values @param {Record<string, MessageType>} types @param {string} root
 */
export function typedefs(values, types, root) {
  return nested(values, root).map((type) => {
    const fields = (types[type]?.fields ?? []).map((field) => ({ ...field, ...parseFieldType(field.type) }));
    const constants = [...(types[type]?.constants ?? [])].sort((a, b) => (a.name < b.name ? -1 : 1));
    return {
      type: short(type),
      fieldnames: fields.map(({ name }) => name),
      fieldtypes: fields.map(({ base, octet }) => (isMessage(base) ? short(base) : NAMES[octet ? "byte" : base] ?? base)),
      fieldarraylen: fields.map(({ array, size }) => (!array ? -1 : array === "fixed" ? size : 0)),
      examples: fields.map(({ base, array, octet, default: value }) =>
        (array ? "[]" : isMessage(base) ? "{}" : pythonText(octet ? "byte" : base, value))),
      constnames: constants.map(({ name }) => name),
      constvalues: constants.map(({ type: kind, value }) => pythonText(kind, value)),
    };
  });
}

/**
 * Return the definition of a name without a package, undefined if it is none of ROS: times of ROS 1 have fields, numbers
 * and texts are not described.
 * @param {string} name
 */
export function withoutPackage(name) {
  if (TIMES.includes(name)) {
    const fields = { fieldnames: ["secs", "nsecs"], fieldtypes: ["int32", "int32"], fieldarraylen: [-1, -1] };
    return [{ type: name, ...fields, examples: ["0", "0"], constnames: [], constvalues: [] }];
  }
  const scalar = /^(bool|byte|u?int(8|16|32|64)|float(32|64)|string)$/.test(name);
  return scalar || Object.values(NAMES).includes(name) ? [] : undefined;
}

/**
 * Return the definition of a message and of all that is nested in it as one text, in the order of rosapi, where the last
 * type of a message comes first: as their files have them, or what the page knows of those without a file.
 * @param {Values} values @param {Record<string, MessageType>} types @param {string} root
 */
export async function fullText(values, types, root) {
  const seen = new Set();
  const left = [root];
  /** @type {string[]} */
  const order = [];
  for (let type = left.pop(); type !== undefined; type = left.pop()) {
    order.push(type);
    const others = inside(values, type).filter((one) => !seen.has(one));
    for (const one of others) seen.add(one);
    left.push(...others);
  }
  const texts = await textsOf(order);
  return order.map((type, index) =>
    (index ? `\n${LINE}\nMSG: ${short(type)}\n` : "") + (texts[type] ?? ownText(types[type]))).join("");
}

/**
 * Return the full name of a type that a client writes: a message, or a part of a service or an action.
 * @param {Values} values @param {string} given
 */
export function typeNamed(values, given) {
  const [, base = given] = PARTS.exec(given) ?? [];
  for (const kind of /** @type {const} */ (["msg", "srv", "action"])) {
    const parts = base.split("/");
    if (parts.length === 3 && parts[1] !== kind) continue;
    const full = fullType(base, kind) + given.slice(base.length);
    if (values.knows(full)) return full;
  }
  return fullType(given, "msg");
}

/** The text of a message, as its file has it without comments. @param {MessageType} [type] */
function ownText(type) {
  const constants = (type?.constants ?? []).map(({ type: kind, name, value }) => `${kind} ${name}=${value}`);
  const fields = (type?.fields ?? []).map(({ name, type: written, octet, default: value }) => {
    const shown = octet ? written.replace("uint8", "byte") : isMessage(written) ? short(written) : written;
    return `${shown} ${name}${value === undefined ? "" : ` ${defaultText(written, value)}`}`;
  });
  return [...constants, ...fields].map((line) => `${line}\n`).join("");
}

/** @param {string} written @param {any} value */
function defaultText(written, value) {
  const { base, array } = parseFieldType(written);
  const isText = base === "string" || base === "wstring";
  const one = (/** @type {any} */ each) => (isText ? JSON.stringify(each) : pythonText(base, each));
  return array ? `[${value.map(one).join(", ")}]` : one(value);
}

/** The type and all types nested in it, each once, depth first. @param {Values} values @param {string} root */
function nested(values, root) {
  /** @type {Set<string>} */
  const found = new Set();
  const add = (/** @type {string} */ type) => {
    if (found.has(type)) return;
    found.add(type);
    inside(values, type).forEach(add);
  };
  add(root);
  return [...found];
}

/** The messages among the fields of a type. @param {Values} values @param {string} type */
function inside(values, type) {
  const bases = Array.from(values.fieldsOf(type).values(), ({ type: { base } }) => base);
  return [...new Set(bases.filter(isMessage))];
}
