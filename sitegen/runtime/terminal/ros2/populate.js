// @ts-check
// Messages of the values that a command line gives, converted and refused as rosidl_runtime_py does.

import { FAILSAFE_SCHEMA, load } from "../../vendor/yaml.js";
import { isFloat, isInteger, isMessage, parseFieldType, range, toArray } from "../../messages/fieldType.js";
import { filled } from "./filled.js";
import { quoted } from "./python.js";

/** @import { Types } from "./python.js" */
/** @typedef {{sec: number, nanosec: number}} Time */

const [HEADER, TIME] = ["std_msgs/msg/Header", "builtin_interfaces/msg/Time"];
const FLAG = /^(?:(yes|true|on)|no|false|off)$/i;
const INTEGER = /^[-+]?(?:0x[\da-f]+|\d[\d_]*)$/i;
const FLOAT = /^[-+]?(?:(?:\d[\d_]*)?\.?\d[\d_]*(?:e[-+]?\d+)?|\d+\.(?:e[-+]?\d+)?)$/i;
const SPECIAL = /^([-+]?)\.(inf|nan)$/i;

/** What Python says of values that do not fit; `kind` is the name of the exception. */
export class Unfit extends Error {
  /** @param {string} kind @param {string} text */
  constructor(kind, text) {
    super(text);
    this.kind = kind;
  }
}

/**
 * Return the values that a YAML text means: mappings, lists and texts. Throws an Unfit. @param {string} text
 * @returns {unknown}
 */
export function readYaml(text) {
  try {
    return text.trim() ? load(text, { schema: FAILSAFE_SCHEMA }) : "";
  } catch (error) {
    throw new Unfit("YAMLError", error instanceof Error ? error.message.split("\n")[0] ?? "" : String(error));
  }
}

/** Whether a value of readYaml is a dictionary. @param {unknown} value @returns {value is Record<string, unknown>} */
export function isDictionary(value) {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}

/**
 * Return a message, and functions that set the times in it that were given as 'now', or the header given as 'auto'.
 * Throws an Unfit.
 * @param {unknown} values of readYaml @param {string} type @param {Types} types
 * @returns {{message: any, stamps: ((now: Time) => void)[]}}
 */
export function populated(values, type, types) {
  /** @type {((now: Time) => void)[]} */
  const stamps = [];
  const message = filled({}, type, types);
  fill(message, values, type);
  return { message, stamps };

  /** @param {any} target @param {unknown} given @param {string} name */
  function fill(target, given, name) {
    if (!isDictionary(given)) {
      throw new Unfit("TypeError", `Value '${shown(given)}' is expected to be a dictionary but is a ${typeName(given)}`);
    }
    for (const [key, value] of Object.entries(given)) {
      const field = types[name]?.fields.find((one) => one.name === key);
      if (!field) throw new Unfit("AttributeError", `'${name.split("/").at(-1)}' object has no attribute '${key}'`);
      const parsed = parseFieldType(field.type);
      const { base, array } = parsed;
      if (!array && base === HEADER && value === "auto") stamps.push((now) => Object.assign(target[key].stamp, now));
      else if (!array && base === TIME && value === "now") stamps.push((now) => Object.assign(target[key], now));
      else if (array) target[key] = list(value, key, parsed);
      else if (isMessage(base)) fill(target[key], value, base);
      else target[key] = scalar(value, base, key);
    }
  }

  /** @param {unknown} given @param {string} key @param {ReturnType<typeof parseFieldType>} parsed */
  function list(given, key, parsed) {
    if (!Array.isArray(given)) throw new Unfit("TypeError", `'${typeName(given)}' object is not iterable`);
    const { base, array, size } = parsed;
    const items = given.map((one) => {
      if (!isMessage(base)) return scalar(one, base, key);
      const inner = filled({}, base, types);
      fill(inner, one, base);
      return inner;
    });
    if ((array === "fixed" && items.length !== size) || items.length > size) {
      const what = isMessage(base) ? base.split("/").at(-1) : base;
      throw new Unfit("AssertionError", array === "fixed"
        ? `The '${key}' numpy.ndarray() must have a size of ${size}`
        : `The '${key}' field must be a set or sequence with length <= ${size} and each value of type '${what}'`);
    }
    return toArray(items, parsed);
  }
}

/** A value as Python's int(), float(), bool() and str() make it. @param {unknown} given @param {string} base @param {string} key */
function scalar(given, base, key) {
  if (/^w?string$/.test(base)) return typeof given === "string" ? given : shown(given);
  if (typeof given !== "string") {
    if (base === "bool") return Array.isArray(given) ? given.length > 0 : true;
    const what = isFloat(base) ? "float() argument must be a string or a real number" : "int() argument must be a string, a bytes-like object or a real number";
    throw new Unfit("TypeError", `${what}, not '${typeName(given)}'`);
  }
  const text = given.trim();
  const special = SPECIAL.exec(text);
  const flag = FLAG.exec(text);
  if (base === "bool") return flag ? Boolean(flag[1]) : FLOAT.test(text) || INTEGER.test(text) ? Number(plain(text)) !== 0 : text !== "";
  const value = flag ? Number(Boolean(flag[1])) : Number(plain(text));
  if (isFloat(base)) {
    if (special) return special[2]?.toLowerCase() === "nan" ? NaN : Number(`${special[1]}Infinity`);
    if (text === "" || Number.isNaN(value)) throw new Unfit("ValueError", `could not convert string to float: ${quoted(given)}`);
    return value;
  }
  return integer(text, base === "byte" ? "uint8" : base, key, flag ? value : undefined);
}

/** @param {string} text @param {string} base @param {string} key @param {number | undefined} flag */
function integer(text, base, key, flag) {
  if (flag === undefined && !INTEGER.test(text) && !FLOAT.test(text)) {
    throw new Unfit("ValueError", `invalid literal for int() with base 10: ${quoted(text)}`);
  }
  const digits = plain(text);
  const sign = digits.startsWith("-") ? -1n : 1n;
  // As int(), which drops what is behind the point.
  const value = flag !== undefined ? BigInt(flag) : INTEGER.test(text)
    ? sign * BigInt(digits.replace(/^[-+]/, "")) : BigInt(Math.trunc(Number(digits)));
  const { least, most } = range(isInteger(base) ? base : "uint8");
  if (value < least || value > most) throw new Unfit("AssertionError", `The '${key}' field must be an integer in [${least}, ${most}]`);
  return base.endsWith("64") ? value : Number(value);
}

/** @param {string} text */
function plain(text) {
  return text.replaceAll("_", "");
}

/** The Python type of a value. @param {unknown} value */
function typeName(value) {
  if (isDictionary(value)) return "dict";
  if (typeof value !== "string") return Array.isArray(value) ? "list" : "NoneType";
  const text = value.trim();
  if (/^(|~|null)$/i.test(text)) return "NoneType";
  if (FLAG.test(text)) return "bool";
  return INTEGER.test(text) ? "int" : FLOAT.test(text) || SPECIAL.test(text) ? "float" : "str";
}

/** str() of a value. @param {unknown} value @returns {string} */
function shown(value) {
  if (typeof value === "string") {
    const kind = typeName(value);
    if (kind === "NoneType") return "None";
    return kind === "bool" ? (FLAG.exec(value.trim())?.[1] ? "True" : "False") : value;
  }
  const inner = (/** @type {unknown} */ one) => (typeof one === "string" && typeName(one) === "str" ? quoted(one) : shown(one));
  if (Array.isArray(value)) return `[${value.map(inner).join(", ")}]`;
  return `{${Object.entries(/** @type {any} */ (value)).map(([key, one]) => `${inner(key)}: ${inner(one)}`).join(", ")}}`;
}
