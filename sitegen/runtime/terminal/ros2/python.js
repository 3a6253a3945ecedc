// @ts-check
// Values as Python prints them, because `ros2` is a Python program.

import { isFloat, isMessage, parseFieldType } from "../../messages/fieldType.js";
import { floatText } from "../../messages/yaml.js";

/** @import { MessageType } from "../../protocol.js" */
/** @typedef {Record<string, MessageType>} Types */

const SHORT = { "\n": "\\n", "\r": "\\r", "\t": "\\t", "\\": "\\\\" };
/** The code of array.array for a type. @type {Record<string, string>} */
const CODES = {
  float32: "f", float64: "d", int8: "b", uint8: "B", char: "B", int16: "h", uint16: "H", int32: "i", uint32: "I",
  int64: "q", uint64: "Q",
};
/** The names of types in IDL, as `echo --no-arr` prints them. @type {Record<string, string>} */
const IDL = { float32: "float", float64: "double", bool: "boolean", byte: "octet", char: "uint8" };

/** repr() of a text. @param {string} text */
export function quoted(text) {
  const quote = text.includes("'") && !text.includes('"') ? '"' : "'";
  const inner = text.replace(/[\\\n\r\t]/g, (letter) => SHORT[/** @type {"\n"} */ (letter)])
    .replace(/[\0-\x1f\x7f-\xa0\xad]/g, (letter) => `\\x${letter.charCodeAt(0).toString(16).padStart(2, "0")}`)
    .replaceAll(quote, (letter) => (letter === "'" ? "\\'" : letter));
  return `${quote}${inner}${quote}`;
}

/** repr() of a float. @param {number} value */
export function float(value) {
  if (Number.isNaN(value)) return "nan";
  return Number.isFinite(value) ? floatText(value) : value < 0 ? "-inf" : "inf";
}

/** repr() of a message. @param {any} message @param {string} type @param {Types} types @returns {string} */
export function repr(message, type, types) {
  const [packageName = "", kind = "", name = ""] = type.split("/");
  const fields = (types[type]?.fields ?? []).map((field) => `${field.name}=${fieldRepr(message[field.name], field.type, types)}`);
  return `${packageName}.${kind}.${name}(${fields.join(", ")})`;
}

/** @param {any} value @param {string} type @param {Types} types @returns {string} */
function fieldRepr(value, type, types) {
  const { base, array } = parseFieldType(type);
  if (!array) return itemRepr(value, base, types);
  const items = Array.from(value, (item) => itemRepr(item, base, types)).join(", ");
  // Arrays of a fixed size are those of NumPy.
  if (array === "fixed" && CODES[base]) return numpy(value, base);
  return `[${items}]`;
}

/** @param {any} value @param {string} base @param {Types} types */
function itemRepr(value, base, types) {
  if (isMessage(base)) return repr(value, base, types);
  if (isFloat(base)) return float(value);
  if (typeof value === "string") return quoted(value);
  if (typeof value === "boolean") return value ? "True" : "False";
  if (base === "byte") return `b'${escaped(Number(value))}'`;
  return String(value);
}

/** repr() of an array of NumPy, as far as one line goes. @param {ArrayLike<any>} value @param {string} base */
function numpy(value, base) {
  const type = base === "float64" || base === "int64" ? "" : `, dtype=${base === "char" ? "uint8" : base}`;
  return `array([${numpyItems(value, base).join(", ")}]${type})`;
}

/** @param {ArrayLike<any>} value @param {string} base */
function numpyItems(value, base) {
  const texts = Array.from(value, (item) => (isFloat(base) ? float(item).replace(/\.0$/, ".") : String(item)));
  const width = Math.max(0, ...texts.map(({ length }) => length));
  const decimals = (/** @type {string} */ text) => (text.split(".")[1] ?? "").length;
  const most = Math.max(0, ...texts.map(decimals));
  return texts.map((text) => (isFloat(base) ? text + " ".repeat(most - decimals(text)) : text.padStart(width)));
}

/** str() of a value that `echo --field` prints. @param {any} value @param {string} type @param {Types} types */
export function text(value, type, types) {
  const { base, array } = parseFieldType(type);
  if (!array) return typeof value === "string" ? value : itemRepr(value, base, types);
  const code = CODES[base];
  if (!code) return fieldRepr(value, type, types);
  if (array === "fixed") return `[${numpyItems(value, base).join(" ")}]`;
  return value.length ? `array('${code}', ${fieldRepr(value, type, types)})` : `array('${code}')`;
}

/**
 * What `echo --no-arr` prints instead of an array. @param {string} type @param {number} length
 */
export function arraySummary(type, length) {
  const { base, array, size } = parseFieldType(type);
  const name = IDL[base] ?? base;
  if (array === "fixed") return `<array type: ${name}[${size}]>`;
  return array === "bounded" ? `<sequence type: ${name}[${size}], length: ${length}>` : `<sequence type: ${name}, length: ${length}>`;
}

/** The bytes of a message, as Python prints them. @param {Uint8Array} bytes */
export function bytesRepr(bytes) {
  const inner = Array.from(bytes, (byte) => (byte === 0x27 ? "'" : escaped(byte))).join("");
  return inner.includes("'") && !inner.includes('"') ? `b"${inner}"` : `b'${inner.replaceAll("'", "\\'")}'`;
}

/** @param {number} byte */
function escaped(byte) {
  const letter = String.fromCharCode(byte);
  if (letter in SHORT) return SHORT[/** @type {"\n"} */ (letter)];
  return byte < 0x20 || byte > 0x7e ? `\\x${byte.toString(16).padStart(2, "0")}` : letter;
}
