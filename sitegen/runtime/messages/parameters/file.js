// @ts-check
// Files of parameters, as `ros2 param dump` writes them and `--params-file` reads them.

import { FAILSAFE_SCHEMA, load } from "../../vendor/yaml.js";
import { say } from "../../ui/words.js";
import { quoted, yamlOf } from "./value.js";

/** @import { Parameter } from "./node.js" */

const ROOT = "ros__parameters";

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

/**
 * Return the values for a node, as texts by name. Throws an Error if the text is no such file.
 * @param {string} text @param {string} node @returns {Map<string, string>}
 */
export function fromFile(text, node) {
  const own = sections(text).filter(({ node: name }) => [node, node.slice(1), node.split("/").at(-1), "/**"].includes(name));
  if (!own.length) throw new Error(say("no parameters of {} in this file", node));
  // Patterns come first in importance as in files: what is for the node itself wins.
  own.sort(({ node: one }, { node: two }) => Number(two === "/**") - Number(one === "/**"));
  return new Map(own.flatMap(({ parameters }) => [...parameters]));
}

/**
 * Return the parameters of all nodes of a file, as texts by name. Throws an Error if the text is no such file.
 * @param {string} text @returns {{node: string, parameters: Map<string, string>}[]}
 */
export function sections(text) {
  /** @type {any} */
  let root;
  try {
    root = load(text, { schema: FAILSAFE_SCHEMA });
  } catch (error) {
    throw new Error(error instanceof Error ? error.message.split("\n")[0] : String(error));
  }
  const found = isMapping(root) ? Object.entries(root).filter(([, inner]) => isMapping(inner?.[ROOT])) : [];
  if (!found.length) throw new Error(say("not a file of parameters: no 'ros__parameters' below the name of a node"));
  return found.map(([node, inner]) => {
    const parameters = new Map();
    flatten(inner[ROOT], "", parameters);
    return { node, parameters };
  });
}

/** @param {any} tree @param {string} above @param {Map<string, string>} found */
function flatten(tree, above, found) {
  for (const [name, value] of Object.entries(tree)) {
    if (isMapping(value)) flatten(value, `${above}${name}.`, found);
    else found.set(above + name, Array.isArray(value) ? `[${value.map((one) => JSON.stringify(one)).join(", ")}]` : String(value));
  }
}

/** @param {any} value */
function isMapping(value) {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}

