// @ts-check
// Turn YAML into messages. The message type, not YAML, determines the types of scalars.

import { FAILSAFE_SCHEMA, load } from "../vendor/yaml.js";
import { isMessage, parseFieldType, readScalar, toArray } from "./fieldType.js";

/** @import { MessageType } from "../protocol.js" */

// The field that rosidl adds to messages without fields, because C has no empty structures.
const FILLER = "structure_needs_at_least_one_member";

/**
 * Parse a message, whose fields may be missing. Throws an Error that says what is wrong.
 * @param {string} text @param {string} type @param {Record<string, MessageType>} types
 * @returns {any}
 */
export function fromYaml(text, type, types) {
  // A message without fields may be written as an empty text.
  const blank = !text.trim() && types[type]?.fields.length === 0;
  return readMessage(blank ? {} : parse(text), type, types);
}

/** @param {string} text @returns {unknown} */
function parse(text) {
  try {
    return load(text, { schema: FAILSAFE_SCHEMA });
  } catch (error) {
    throw new Error(error instanceof Error ? error.message.split("\n")[0] : String(error));
  }
}

/** @param {unknown} value @param {string} name @param {Record<string, MessageType>} types */
function readMessage(value, name, types) {
  const type = types[name];
  if (!type) throw new Error(`there is no definition of ${name}`);
  if (typeof value !== "object" || value === null || Array.isArray(value)) {
    throw new Error(`expected the fields of ${name}, not ${describe(value)}`);
  }
  /** @type {Record<string, any>} */
  const message = {};
  for (const [key, given] of Object.entries(value)) {
    const field = type.fields.find((one) => one.name === key);
    if (field) {
      try {
        message[key] = readField(given, field.type, types);
      } catch (error) {
        throw new Error(`${key}: ${error instanceof Error ? error.message : error}`);
      }
    } else if (key !== FILLER) {
      throw new Error(`${name} has no field '${key}'`);
    }
  }
  return message;
}

/** @param {unknown} value @param {string} text the field's type @param {Record<string, MessageType>} types */
function readField(value, text, types) {
  const type = parseFieldType(text);
  const read = (/** @type {unknown} */ one) => {
    if (isMessage(type.base)) return readMessage(one, type.base, types);
    if (typeof one !== "string") throw new Error(`expected a ${type.base}, not ${describe(one)}`);
    return readScalar(one, type);
  };
  if (!type.array) return read(value);
  // yaml-cpp may write empty lists like this.
  if (value === "" || value === "~") return toArray([], type);
  if (!Array.isArray(value)) throw new Error(`expected a list, not ${describe(value)}`);
  return toArray(value.map(read), type);
}

/** @param {unknown} value */
function describe(value) {
  if (typeof value === "string") return `'${value.length > 40 ? `${value.slice(0, 40)}…` : value}'`;
  return Array.isArray(value) ? "a list" : "fields";
}
