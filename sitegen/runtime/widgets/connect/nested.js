// @ts-check
// The definitions that the worker of a connection asks for.

import { parseFieldType } from "../../messages/fieldType.js";

/** @import { MessageType } from "../../protocol.js" */

/**
 * Return the definitions of types and of those nested in them, as far as they are known.
 * @param {Record<string, MessageType>} types all @param {string[]} wanted @returns {Record<string, MessageType>}
 */
export function withNested(types, wanted) {
  const names = new Set(wanted);
  /** @type {Record<string, MessageType>} */
  const found = {};
  for (const name of names) { // the set grows during the loop
    const type = Object.hasOwn(types, name) ? types[name] : undefined;
    if (!type) continue;
    found[name] = type;
    for (const field of type.fields) names.add(parseFieldType(field.type).base);
  }
  return found;
}
