// @ts-check
// The types of message fields, as written in .msg files, and their values, as visitors type them.

import { say } from "../ui/words.js";

/**
 * @typedef {{base: string, capacity: number, array: "" | "fixed" | "bounded" | "unbounded",
 *   size: number}} FieldType `capacity` is the bound of a string, `size` that of an array; Infinity if
 *   unbounded
 */

const TYPE = /^([^\s<[]+)(?:<=(\d+))?(\[(<=)?(\d*)\])?$/;

/** The types of numbers, and of arrays of them. */
export const INTEGERS = {
  int8: Int8Array,
  uint8: Uint8Array,
  int16: Int16Array,
  uint16: Uint16Array,
  int32: Int32Array,
  uint32: Uint32Array,
  int64: BigInt64Array,
  uint64: BigUint64Array,
};
export const FLOATS = { float32: Float32Array, float64: Float64Array };

/** Parse a type, for example "string<=10[<=5]". @param {string} text @returns {FieldType} */
export function parseFieldType(text) {
  const [, base = text, capacity, array, bounded, size] = TYPE.exec(text) ?? [];
  return {
    base,
    capacity: capacity ? Number(capacity) : Infinity,
    array: !array ? "" : !size ? "unbounded" : bounded ? "bounded" : "fixed",
    size: size ? Number(size) : Infinity,
  };
}

/** @param {string} base @returns {base is keyof typeof INTEGERS} */
export function isInteger(base) {
  return base in INTEGERS;
}

/** @param {string} base @returns {base is keyof typeof FLOATS} */
export function isFloat(base) {
  return base in FLOATS;
}

/** Whether a type is a message. @param {string} base */
export function isMessage(base) {
  return base.includes("/");
}

/** Return the smallest and the largest value of a type. @param {keyof typeof INTEGERS} base */
export function range(base) {
  const signed = base.startsWith("i");
  const bits = BigInt(INTEGERS[base].BYTES_PER_ELEMENT * 8) - (signed ? 1n : 0n);
  return { least: signed ? -(2n ** bits) : 0n, most: 2n ** bits - 1n };
}

/**
 * Parse a value. Throws an Error that says what is wrong with the text.
 * @param {string} text @param {FieldType} type
 */
export function readScalar(text, { base, capacity }) {
  if (isInteger(base)) return readInteger(text.trim(), base);
  if (isFloat(base)) return readFloat(text.trim(), base);
  if (base === "bool") return readFlag(text.trim());
  const length = base === "wstring" ? text.length : new TextEncoder().encode(text).length;
  if (length > capacity) throw new Error(say("holds at most {} bytes, not {}", capacity, length));
  return text;
}

/**
 * Parse an array such as "[1, 2, 3]"; the brackets are optional.
 * @param {string} text @param {FieldType} type
 */
export function readList(text, type) {
  const inner = /^\s*\[([^]*)\]\s*$/.exec(text)?.[1] ?? text;
  const values = items(inner).map((item, index) => {
    try {
      return readScalar(item, type);
    } catch (error) {
      throw new Error(say("item {}: {}", index + 1, error instanceof Error ? error.message : error));
    }
  });
  return toArray(values, type);
}

/**
 * Return values as an array of a message. Throws an Error if their number is wrong.
 * @param {unknown[]} values @param {FieldType} type
 */
export function toArray(values, { base, array, size }) {
  if (array === "fixed" && values.length !== size) {
    throw new Error(say("needs {} items, not {}", size, values.length));
  }
  if (values.length > size) throw new Error(say("holds at most {} items, not {}", size, values.length));
  /** @type {Record<string, {from(values: unknown[]): any}>} */
  const arrays = { .../** @type {any} */ (INTEGERS), ...FLOATS };
  return arrays[base]?.from(values) ?? values;
}

/** @param {string} text @param {keyof typeof INTEGERS} base */
function readInteger(text, base) {
  if (!text) throw new Error(say("enter a whole number"));
  if (!/^[-+]?(\d+|0x[\da-f]+)$/i.test(text)) throw new Error(say("'{}' is not a whole number", text));
  const size = BigInt(text.replace(/^[-+]/, ""));
  const value = text.startsWith("-") ? -size : size;
  const { least, most } = range(base);
  if (value < least || value > most) throw new Error(say("{} holds {} to {}", base, least, most));
  return base.endsWith("64") ? value : Number(value);
}

/** @param {string} text @param {keyof typeof FLOATS} base */
function readFloat(text, base) {
  if (!text) throw new Error(say("enter a number"));
  const special = /^([-+]?)\.?(inf|infinity|nan)$/i.exec(text);
  if (special) return special[2]?.toLowerCase() === "nan" ? NaN : Number(`${special[1]}Infinity`);
  if (/^[-+]?\d+,\d+$/.test(text)) {
    throw new Error(say("'{}' is not a number; write {}", text, text.replace(",", ".")));
  }
  if (!/^[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/i.test(text)) throw new Error(say("'{}' is not a number", text));
  const value = Number(text);
  if (!Number.isFinite(base === "float32" ? Math.fround(value) : value)) {
    throw new Error(say("'{}' is too large for {}", text, base));
  }
  return value;
}

/** @param {string} text */
function readFlag(text) {
  if (!/^(true|false)$/i.test(text)) throw new Error(say("'{}' is neither true nor false", text));
  return text.toLowerCase() === "true";
}

/** Split at commas that are not in quotes. @param {string} text */
function items(text) {
  /** @type {string[]} */
  const found = [];
  if (!text.trim()) return found;
  const item = /\s*(?:"((?:[^"\\]|\\.)*)"|'((?:[^']|'')*)'|((?!\s*["'])[^,]*))\s*(,|$)/y;
  for (;;) {
    const match = item.exec(text);
    if (!match) throw new Error(say("separate items with commas and close every quote"));
    const [, double, single, plain, comma] = match;
    found.push(
      double !== undefined
        ? unescaped(double)
        : (single?.replaceAll("''", "'") ?? plain?.trim() ?? ""),
    );
    if (!comma) return found;
  }
}

/** @param {string} text between double quotes */
function unescaped(text) {
  try {
    return JSON.parse(`"${text.replaceAll("\n", "\\n").replaceAll("\t", "\\t")}"`);
  } catch {
    throw new Error(say('"{}" has an invalid escape; write \\\\ for a backslash', text));
  }
}
