// @ts-check
// The types of arguments: what Python reads from texts, and its errors.

/** @import { Type } from "./parse.js" */

/** Whether Python's int() takes a text. @param {string} text */
function isInt(text) {
  return /^\s*[-+]?\d+(_\d+)*\s*$/.test(text);
}

/** Whether Python's float() takes a text. @param {string} text */
function isFloat(text) {
  return /^\s*[-+]?((\d+(_\d+)*\.?(\d+(_\d+)*)?|\.\d+(_\d+)*)(e[-+]?\d+)?|inf(inity)?|nan)\s*$/i.test(text);
}

/** @type {Type} */
export const INT = { name: "int", read: (text) => {
  if (!isInt(text)) throw new Error("");
  return Number(text.replaceAll("_", ""));
} };
/** @type {Type} */
export const FLOAT = { name: "float", read: (text) => {
  if (!isFloat(text)) throw new Error("");
  if (/inf/i.test(text)) return text.includes("-") ? -Infinity : Infinity;
  return Number(text.replaceAll("_", ""));
} };

/** @type {Type} */
export const POSITIVE_FLOAT = { name: "positive_float", read: (text) => {
  if (!isFloat(text)) throw new Error("Expects a floating point number");
  const value = FLOAT.read(text);
  if (value <= 0) throw new Error("Value must be positive");
  return value;
} };
/** @type {Type} */
export const POSITIVE_INT = { name: "positive_int", read: (text) => {
  if (!isInt(text) || INT.read(text) <= 0) throw new Error("value must be a positive integer");
  return INT.read(text);
} };
/** @type {Type} */
export const UNSIGNED_INT = { name: "unsigned_int", read: (text) => {
  if (!isInt(text) || INT.read(text) < 0) throw new Error("value must be non-negative integer");
  return INT.read(text);
} };
