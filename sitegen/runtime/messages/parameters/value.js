// @ts-check
// Values of parameters: rcl_interfaces/msg/ParameterValue as text and back.

import { parseFieldType, readList, readScalar } from "../fieldType.js";
import { isPlain } from "../yaml.js";
import { say } from "../../ui/words.js";

/** The fields of a value by its type number, with their types. @type {Record<number, [string, string]>} */
const FIELDS = {
  1: ["bool_value", "bool"],
  2: ["integer_value", "int64"],
  3: ["double_value", "float64"],
  4: ["string_value", "string"],
  5: ["byte_array_value", "uint8[]"],
  6: ["bool_array_value", "bool[]"],
  7: ["integer_array_value", "int64[]"],
  8: ["double_array_value", "float64[]"],
  9: ["string_array_value", "string[]"],
};
/** The names of types by their numbers. */
export const NAMES = ["not set", "bool", "integer", "double", "string", "byte array", "bool array", "integer array",
  "double array", "string array"];

export const [NOT_SET, BOOL, INTEGER, DOUBLE, STRING] = [0, 1, 2, 3, 4];
const [DOUBLE_ARRAY, STRING_ARRAY] = [8, 9];

/** The name of a type as ROS has it. @param {number} type */
export function nameOf(type) {
  return NAMES[type] ?? say("type {}", type);
}

/** The field of rcl_interfaces/msg/ParameterValue that has a value of a type. @param {number} type */
export function fieldOf(type) {
  return FIELDS[type]?.[0] ?? "";
}

/** The type of lists of a type. @param {number} scalar */
export function listOf(scalar) {
  return scalar + STRING + 1;
}

/** Whether values of a type are lists. @param {number} type */
export function isList(type) {
  return type > STRING;
}

/** @param {any} value a ParameterValue @returns {any} a boolean, number, text or an array of these; undefined if not set */
export function plainOf(value) {
  const field = fieldOf(value.type);
  return field ? value[field] : undefined;
}

/** Return a value as it is typed into a field. @param {any} value a ParameterValue */
export function textOf(value) {
  const plain = plainOf(value);
  if (plain === undefined) return "";
  return isList(value.type) ? listText(plain, value.type) : scalarText(plain, value.type);
}

/** Return a value as YAML. @param {any} value a ParameterValue */
export function yamlOf(value) {
  const plain = plainOf(value);
  if (plain === undefined) return "null";
  if (isList(value.type)) return listText(plain, value.type);
  return value.type === STRING ? quoted(plain) : scalarText(plain, value.type);
}

/** Return the ParameterValue that a text means. Throws an Error that says what is wrong. @param {string} text @param {number} type */
export function parse(text, type) {
  const [field, fieldType] = FIELDS[type] ?? [];
  if (!field || !fieldType) return { type: NOT_SET };
  const parsed = parseFieldType(fieldType);
  const read = isList(type) ? readList(text, parsed) : readScalar(text, parsed);
  return { type, [field]: read };
}

/** Return the ParameterValue of a number or a flag. @param {any} plain @param {number} type */
export function valueOf(plain, type) {
  return { type, [fieldOf(type)]: type === INTEGER ? BigInt(Math.round(plain)) : plain };
}

/** @param {any} plain @param {number} type */
function scalarText(plain, type) {
  if (type !== DOUBLE) return String(plain);
  if (!Number.isFinite(plain)) return Number.isNaN(plain) ? ".nan" : plain > 0 ? ".inf" : "-.inf";
  // A double stays one when it is read again.
  return Number.isInteger(plain) && Math.abs(plain) < 1e15 ? plain.toFixed(1) : String(plain);
}

/** @param {Iterable<any>} items @param {number} type */
function listText(items, type) {
  const texts = Array.from(items, (item) => (
    type === DOUBLE_ARRAY ? scalarText(item, DOUBLE) : type === STRING_ARRAY ? JSON.stringify(item) : String(item)));
  return `[${texts.join(", ")}]`;
}

/** Return a text as it stands in YAML. @param {string} text */
export function quoted(text) {
  return text && isPlain(text) && !/[\n"']/.test(text) ? text : JSON.stringify(text);
}

/**
 * Return the ParameterValue that a text means in YAML, as `ros2 param set` takes it: "1" is an integer, "1.0" a double.
 * @param {string} text
 */
export function guess(text) {
  const trimmed = text.trim();
  const list = /^\[([^]*)\]$/.exec(trimmed);
  if (!list) return scalarOf(trimmed, text);
  const items = readList(trimmed, parseFieldType("string[]")).map((/** @type {string} */ item) => scalarOf(item, item));
  // Text in quotes looks like numbers after it was read.
  const types = new Set(/["']/.test(trimmed) ? [STRING] : items.map((/** @type {any} */ { type }) => type));
  if (types.has(INTEGER) && types.has(DOUBLE)) types.delete(INTEGER);
  const [type = STRING] = types.size === 1 ? types : [STRING];
  return parse(trimmed, items.length ? listOf(type) : STRING_ARRAY);
}

/** @param {string} trimmed @param {string} text */
function scalarOf(trimmed, text) {
  if (/^(true|false|yes|no|on|off)$/i.test(trimmed)) return valueOf(/^(true|yes|on)$/i.test(trimmed), BOOL);
  if (/^[-+]?(\d+|0x[\da-f]+)$/i.test(trimmed)) return parse(trimmed, INTEGER);
  if (/^[-+]?(\d+\.\d*|\.\d+|\d+(\.\d*)?e[-+]?\d+)$/i.test(trimmed) || /^[-+]?\.(inf|nan)$/i.test(trimmed)) return parse(trimmed, DOUBLE);
  const quotes = /^(["'])([^]*)\1$/.exec(trimmed);
  return { type: STRING, string_value: quotes?.[2] ?? text };
}
