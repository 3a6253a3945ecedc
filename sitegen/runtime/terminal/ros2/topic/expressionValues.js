// @ts-check
// Values in expressions of --filter: operations, functions and methods as Python has them.

import { Failure } from "../../shell/shell.js";

/** Whether a value counts as true in Python. @param {any} value */
export function isTrue(value) {
  return Array.isArray(value) ? value.length > 0 : Boolean(value);
}

/** Throw what Python says of operands that do not fit. @param {string} what @returns {never} */
function unfit(what) {
  throw new Failure(`--filter: unsupported operand type(s) for ${what}`);
}

/** @param {string} sign @param {any} value @returns {number} */
function number(sign, value) {
  if (typeof value === "boolean") return Number(value);
  return typeof value === "number" ? value : unfit(sign);
}

/** @param {any} a @param {any} b @returns {boolean} */
function equal(a, b) {
  if (Array.isArray(a) && Array.isArray(b)) return a.length === b.length && a.every((one, index) => equal(one, b[index]));
  const plain = (/** @type {any} */ one) => (typeof one === "boolean" ? Number(one) : one);
  return plain(a) === plain(b);
}

/** @param {string} sign @param {(a: any, b: any) => boolean} compare */
function ordered(sign, compare) {
  return (/** @type {any} */ a, /** @type {any} */ b) => (typeof a === "string" && typeof b === "string"
    ? compare(a, b) : compare(number(sign, a), number(sign, b)));
}

/** @param {any} one @param {any} all @returns {boolean} */
function contained(one, all) {
  if (typeof all === "string" && typeof one === "string") return all.includes(one);
  return Array.isArray(all) ? all.some((other) => equal(one, other)) : unfit("in");
}

/** @param {string} sign @param {(a: number, b: number) => number} compute */
function computed(sign, compute) {
  return (/** @type {any} */ a, /** @type {any} */ b) => compute(number(sign, a), number(sign, b));
}

/** @param {number} divisor */
function nonzero(divisor) {
  if (divisor === 0) throw new Failure("--filter: division by zero");
  return divisor;
}

/** @type {Record<string, (a: any, b: any) => any>} */
export const OPERATIONS = {
  "==": equal,
  "!=": (a, b) => !equal(a, b),
  "<": ordered("<", (a, b) => a < b),
  "<=": ordered("<=", (a, b) => a <= b),
  ">": ordered(">", (a, b) => a > b),
  ">=": ordered(">=", (a, b) => a >= b),
  in: contained,
  "not in": (a, b) => !contained(a, b),
  is: (a, b) => a === b,
  "is not": (a, b) => a !== b,
  "+": (a, b) => (typeof a === "string" && typeof b === "string" ? a + b : number("+", a) + number("+", b)),
  "-": computed("-", (a, b) => a - b),
  "*": computed("*", (a, b) => a * b),
  "/": computed("/", (a, b) => a / nonzero(b)),
  "//": computed("//", (a, b) => Math.floor(a / nonzero(b))),
  "%": computed("%", (a, b) => a - b * Math.floor(a / nonzero(b))),
  "**": computed("**", (a, b) => a ** b),
};

/** @param {any} value @returns {any[]} */
function items(value) {
  return Array.isArray(value) ? value : typeof value === "string" ? [...value] : unfit("iteration");
}

/** @param {any[]} values of min() or max() @param {">" | "<"} sign */
function extreme(values, sign) {
  const all = values.length === 1 ? items(values[0]) : values;
  if (!all.length) throw new Failure("--filter: min() and max() need a value");
  return all.reduce((best, one) => (OPERATIONS[sign]?.(one, best) ? one : best));
}

/** @type {Record<string, (...values: any[]) => any>} */
export const FUNCTIONS = {
  abs: (value) => Math.abs(number("abs()", value)),
  all: (value) => items(value).every(isTrue),
  any: (value) => items(value).some(isTrue),
  bool: isTrue,
  float: (value) => (typeof value === "string" ? Number(value) : number("float()", value)),
  int: (value) => Math.trunc(typeof value === "string" ? Number(value) : number("int()", value)),
  len: (value) => items(value).length,
  max: (...values) => extreme(values, ">"),
  min: (...values) => extreme(values, "<"),
  round: (value, digits = 0) => Number(number("round()", value).toFixed(Math.min(Math.max(digits, 0), 15))),
  str: (value) => (typeof value === "boolean" ? (value ? "True" : "False") : String(value)),
  sum: (value) => items(value).reduce((sum, one) => sum + number("+", one), 0),
};

/** Methods of texts; the first value is the text. @type {Record<string, (...values: any[]) => any>} */
export const METHODS = {
  count: (text, part) => text.split(part).length - 1,
  endswith: (text, part) => text.endsWith(part),
  find: (text, part) => text.indexOf(part),
  isdigit: (text) => /^\d+$/.test(text),
  lower: (text) => text.toLowerCase(),
  replace: (text, part, other) => text.replaceAll(part, () => other),
  split: (text, part) => (part === undefined ? text.split(/\s+/).filter(Boolean) : text.split(part)),
  startswith: (text, part) => text.startsWith(part),
  strip: (text) => text.trim(),
  upper: (text) => text.toUpperCase(),
};
