// @ts-check
// Definitions of types, as rosapi describes them.

import { isMessage } from "../../messages/fieldType.js";
import { fullType } from "../../client/names.js";
import { short } from "../values.js";

/** @import { MessageType } from "../../protocol.js" */
/** @import { Values } from "../values.js" */

const LINE = "=".repeat(80);
/** How rclpy names the types of fields. @type {Record<string, string>} */
const NAMES = { bool: "boolean", float32: "float", float64: "double" };
/** A part of a service or an action. */
export const PARTS = /^(.+?)_((SendGoal_|GetResult_)?(Request|Response)|Goal|Result|Feedback|FeedbackMessage)$/;

/**
 * Return the definitions of a type and of all types nested in it, as rosapi_msgs/msg/TypeDef.
 * @param {Values} values @param {Record<string, MessageType>} types @param {string} root
 */
export function typedefs(values, types, root) {
  return nested(values, root).map((type) => {
    const fields = [...values.fieldsOf(type).values()];
    const constants = types[type]?.constants ?? [];
    return {
      type: short(type),
      fieldnames: fields.map(({ name }) => name),
      fieldtypes: fields.map(({ type: { base } }) => (isMessage(base) ? short(base) : NAMES[base] ?? base)),
      fieldarraylen: fields.map(({ type: { array, size } }) => (!array ? -1 : array === "fixed" ? size : 0)),
      examples: fields.map(({ type: { base, array } }) => exampleOf(base, array)),
      constnames: constants.map(({ name }) => name),
      constvalues: constants.map(({ value }) => String(value)),
    };
  });
}

/**
 * Return the definition of a message and of all that is nested in it as one text, as bags have it.
 * @param {Values} values @param {Record<string, MessageType>} types @param {string} root
 */
export function fullText(values, types, root) {
  const [own, ...others] = nested(values, root).map((type) => {
    const constants = (types[type]?.constants ?? []).map(({ type: kind, name, value }) => `${kind} ${name}=${value}`);
    const fields = Array.from(values.fieldsOf(type).values(), ({ name, written }) =>
      `${isMessage(written) ? short(written) : written} ${name}`);
    return { type, text: [...constants, ...fields].join("\n") };
  });
  return [own?.text ?? "", ...others.map(({ type, text }) => `${LINE}\nMSG: ${short(type)}\n${text}`)].join("\n");
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

/** The type and all types nested in it, each once. @param {Values} values @param {string} root */
function nested(values, root) {
  const found = new Set([root]);
  for (const type of found) { // the set grows during the loop
    for (const { type: { base } } of values.fieldsOf(type).values()) if (isMessage(base)) found.add(base);
  }
  return [...found];
}

/** @param {string} base @param {string} array */
function exampleOf(base, array) {
  if (array) return "[]";
  if (isMessage(base)) return "{}";
  if (base === "bool") return "False";
  if (base === "string" || base === "wstring") return "";
  return base.startsWith("float") ? "0.0" : "0";
}
