// @ts-check
// What a parameter of a script's node may be: its rcl_interfaces/msg/ParameterDescriptor.

import { BOOL, DOUBLE, INTEGER, NAMES } from "../messages/parameters/value.js";
import { say } from "../ui/words.js";
import { LARGEST, parameterOf, SMALLEST } from "./parameters.js";

/**
 * @typedef {{type?: string, description?: string, constraints?: string, readOnly?: boolean, dynamic?: boolean,
 *   min?: number | bigint, max?: number | bigint, step?: number | bigint,
 *   accept?: (value: any) => boolean | string}} Options `type` as ROS names it, such as "double" or "string_array";
 *   `constraints` in words; `dynamic` if the type may change; `accept` may refuse a value, with a reason
 */

// As error messages of rclcpp have them.
const TYPES = NAMES.map((name) => name.replace(" array", "_array"));
const OPTIONS = ["type", "description", "constraints", "readOnly", "dynamic", "min", "max", "step", "accept"];
// How far a double may be off a step, relative to its size.
const TOLERANCE = 1e-9;

/**
 * Return the value of a parameter, as rcl_interfaces/msg/ParameterValue, and its descriptor.
 * @param {string} name @param {any} given the value, undefined if it is set later @param {Options} options
 * @returns {{value: any, descriptor: any}}
 */
export function described(name, given, options) {
  const odd = Object.keys(options).find((one) => !OPTIONS.includes(one));
  if (odd) throw new Error(say("{}: unknown option '{}'; known are {}", name, odd, OPTIONS.join(", ")));
  const { min, max, step, dynamic = false } = options;
  const limits = [min, max, step].filter((one) => one !== undefined);
  const wanted = typeOf(name, options.type);
  // A range from 0 to 0.5 is none of integers.
  const value = parameterOf(given, wanted ?? (limits.some((one) => !isWhole(one)) ? DOUBLE : 0));
  const type = wanted ?? value.type;
  if (!type && !dynamic) throw new Error(say("{}: a parameter needs a value or a type", name));
  if (limits.length && type !== INTEGER && type !== DOUBLE) {
    throw new Error(say("{}: only integers and doubles can have a range", name));
  }
  const descriptor = {
    name, type, description: options.description ?? "", additional_constraints: options.constraints ?? "",
    read_only: options.readOnly ?? false, dynamic_typing: dynamic,
    integer_range: limits.length && type === INTEGER
      ? [{ from_value: BigInt(min ?? SMALLEST), to_value: BigInt(max ?? LARGEST), step: BigInt(step ?? 0) }] : [],
    floating_point_range: limits.length && type === DOUBLE
      ? [{ from_value: Number(min ?? -Infinity), to_value: Number(max ?? Infinity), step: Number(step ?? 0) }] : [],
  };
  return { value, descriptor };
}

/**
 * Return why a value does not fit a descriptor, in words of ROS, or "".
 * @param {any} value rcl_interfaces/msg/ParameterValue @param {any} descriptor
 */
export function misfit({ type, integer_value: integer, double_value: double }, descriptor) {
  const { name, integer_range: [integers], floating_point_range: [doubles] } = descriptor;
  if (!descriptor.dynamic_typing && type !== descriptor.type) {
    return `Wrong parameter type, parameter {${name}} is of type {${TYPES[descriptor.type]}}, ` +
      `setting it to {${TYPES[type] ?? type}} is not allowed.`;
  }
  if (type === INTEGER && integers && !isIn(integers, BigInt(integer))) {
    return `Parameter {${name}} doesn't comply with integer range.`;
  }
  if (type === DOUBLE && doubles && !isNear(doubles, double)) {
    return `Parameter {${name}} doesn't comply with floating point range.`;
  }
  return "";
}

/** @param {string} name of the parameter @param {string | undefined} given the name of its type */
function typeOf(name, given) {
  if (given === undefined) return undefined;
  const type = TYPES.indexOf(given);
  if (type >= BOOL) return type;
  throw new Error(say("{}: unknown type '{}'; known are {}", name, String(given), TYPES.slice(BOOL).join(", ")));
}

/** @param {number | bigint | undefined} value */
function isWhole(value) {
  return typeof value === "bigint" || Number.isInteger(value);
}

/** @param {{from_value: bigint, to_value: bigint, step: bigint}} range @param {bigint} value */
function isIn({ from_value: from, to_value: to, step }, value) {
  if (value === from || value === to) return true;
  return value > from && value < to && (step === 0n || (value - from) % step === 0n);
}

/** @param {{from_value: number, to_value: number, step: number}} range @param {number} value */
function isNear({ from_value: from, to_value: to, step }, value) {
  if (value === from || value === to) return true;
  if (!(value > from && value < to)) return false;
  const nearest = from + Math.round((value - from) / step) * step;
  return step === 0 || Math.abs(value - nearest) <= TOLERANCE * Math.max(1, Math.abs(value));
}
