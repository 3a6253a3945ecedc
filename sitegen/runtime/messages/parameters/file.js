// @ts-check
// Write files of parameters, as `ros2 param dump` does.

import { quoted, yamlOf } from "./value.js";

/** @import { Parameter } from "./node.js" */

export const ROOT = "ros__parameters";

/** Return the parameters of a node as YAML. @param {string} node @param {Parameter[]} parameters */
export function toFile(node, parameters) {
  /** @type {Map<string, any>} */
  const tree = new Map();
  const names = new Set(parameters.map(({ name }) => name));
  for (const { name, value } of parameters) {
    let inner = tree;
    let rest = name;
    for (let dot = rest.indexOf("."); dot > 0; dot = rest.indexOf(".")) {
      // Beside a parameter 'a', 'a.b' is written as one name.
      if (names.has(name.slice(0, name.length - rest.length + dot))) break;
      const part = rest.slice(0, dot);
      if (!inner.has(part)) inner.set(part, new Map());
      inner = inner.get(part);
      rest = rest.slice(dot + 1);
    }
    inner.set(rest, yamlOf(value));
  }
  return [`${node}:`, `  ${ROOT}:`, ...lines(tree, "    "), ""].join("\n");
}

/** @param {Map<string, any>} tree @param {string} indent @returns {string[]} */
function lines(tree, indent) {
  return [...tree].flatMap(([name, value]) => (value instanceof Map
    ? [`${indent}${quoted(name)}:`, ...lines(value, `${indent}  `)] : [`${indent}${quoted(name)}: ${value}`]));
}
