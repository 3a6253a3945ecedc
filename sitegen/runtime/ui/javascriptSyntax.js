// @ts-check
// JavaScript for the editor, which of its syntax errors are none, and what a text imports. Its grammar is large, so that
// only cells of JavaScript load it.

import { javascriptLanguage } from "../vendor/javascript.js";
import { indentUnit } from "./codeView.js";

/** @import { Language, SyntaxNode } from "./codeView.js" */

const MODULE = ["ImportDeclaration", "ExportDeclaration", "DynamicImport"];

/** @type {Language} */
export const JAVASCRIPT = {
  parser: javascriptLanguage.parser,
  extensions: [indentUnit.of("  "), javascriptLanguage],
  isMistake: (node, text) => node.type.isError && !isPattern(node, text),
};

/**
 * Return the names of the modules that a text imports, and where they are, quotes included.
 * @param {string} text @returns {{from: number, to: number, name: string}[]}
 */
export function imports(text) {
  /** @type {{from: number, to: number, name: string}[]} */
  const found = [];
  JAVASCRIPT.parser.parse(text).iterate({
    enter({ name, from, to, node }) {
      if (name !== "String" || !MODULE.includes(node.parent?.name ?? "")) return;
      found.push({ from, to, name: text.slice(from + 1, to - 1) });
    },
  });
  return found;
}

/** Whether an error is in `[a.b, c] = …`, which the parser does not know. @param {SyntaxNode} node @param {string} text */
function isPattern(node, text) {
  for (let above = node.parent; above; above = above.parent) {
    if (above.name === "ExpressionStatement") return text[above.from] === "[";
  }
  return false;
}
