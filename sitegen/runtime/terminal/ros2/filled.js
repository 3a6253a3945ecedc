// @ts-check
// Messages with all their fields: what YAML left out has the default of its definition, or is zero.

import { isMessage, parseFieldType, toArray } from "../../messages/fieldType.js";

/** @import { Types } from "./python.js" */

/** @param {any} given @param {string} type @param {Types} types @returns {any} */
export function filled(given, type, types) {
  /** @type {Record<string, any>} */
  const message = {};
  for (const field of types[type]?.fields ?? []) {
    const { base, array, size } = parseFieldType(field.type);
    const value = given?.[field.name] ?? field.default;
    if (isMessage(base)) {
      const fill = (/** @type {any} */ one) => filled(one, base, types);
      if (!array) message[field.name] = fill(value);
      else message[field.name] = Array.from(value ?? { length: array === "fixed" ? size : 0 }, fill);
    } else if (array) {
      const zeros = array === "fixed" ? Array.from({ length: size }, () => zero(base)) : [];
      message[field.name] = toArray(Array.from(value ?? zeros, (one) => typed(one, base)), parseFieldType(field.type));
    } else {
      message[field.name] = value === undefined ? zero(base) : typed(value, base);
    }
  }
  return message;
}

/** Defaults come as JSON, where 64-bit integers are texts. @param {any} value @param {string} base */
function typed(value, base) {
  return base.endsWith("int64") && typeof value !== "bigint" ? BigInt(value) : value;
}

/** @param {string} base */
function zero(base) {
  if (/^w?string$/.test(base)) return "";
  if (base === "bool") return false;
  return base.endsWith("int64") ? 0n : 0;
}
