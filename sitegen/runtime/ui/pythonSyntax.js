// @ts-check
// Python for the editor, and which of its syntax errors are none.

import { indentUnit, pythonLanguage } from "../vendor/codemirror.js";

/** @import { Language } from "./codeView.js" */

// What the parser reports in these nodes may be valid: a bare `yield`, `1.`, `x[*y]`, `with (a as b):`, `case A(x=B()):`.
const DOUBTFUL = new Set([
  "YieldStatement", "YieldExpression", "MemberExpression", "WithStatement", "ParenthesizedExpression", "Decorator",
  "DecoratedStatement", "LiteralPattern", "TypeDef",
]);
const STRING = /^[a-z]{0,2}("""|'''|"|')/i;

/** @type {Language} */
export const PYTHON = {
  parser: pythonLanguage.parser,
  extensions: [indentUnit.of("    "), pythonLanguage],
  isMistake(node, text) {
    if (node.type.isError) return !DOUBTFUL.has(node.parent?.name ?? "");
    const isString = node.name === "String" || node.name === "FormatString";
    return isString && !isClosed(text.slice(node.from, node.to));
  },
};

/** Whether a string ends with its quotes; the parser ends one at the end of its line. @param {string} string */
function isClosed(string) {
  const [begin = "", quotes = ""] = STRING.exec(string) ?? [];
  return string.slice(begin.length).endsWith(quotes);
}
