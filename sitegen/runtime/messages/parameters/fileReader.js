// @ts-check
// Read files of parameters, as `--params-file` does.

import { say } from "../../ui/words.js";
import { FAILSAFE_SCHEMA, load } from "../../vendor/yaml.js";
import { ROOT } from "./file.js";

/**
 * Return the values for a node, as texts by name. Throws an Error if the text is no such file.
 * @param {string} text @param {string} node @param {boolean} [wildcard] whether those of all nodes count
 * @returns {Map<string, string>}
 */
export function fromFile(text, node, wildcard = true) {
  const names = [node, node.slice(1), node.split("/").at(-1), ...(wildcard ? ["/**"] : [])];
  const own = sections(text).filter(({ node: name }) => names.includes(name));
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
