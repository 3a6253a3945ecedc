// @ts-check
// Find syntax errors in Python source without Python, by the parser that colours it.

import { python } from "../vendor/codemirror.js";

const { parser } = python().language;

// What this parser reports in these nodes may be valid: a bare `yield`, `1.`, `x[*y]`, `with (a as b):`, `case A(x=B()):`.
const DOUBTFUL = new Set([
  "YieldStatement", "YieldExpression", "MemberExpression", "WithStatement", "ParenthesizedExpression", "Decorator",
  "DecoratedStatement", "LiteralPattern", "TypeDef",
]);
const STRING = /^[a-z]{0,2}("""|'''|"|')/i;

/** Return the number of the first line with a syntax error, or 0. Not all errors are found. @param {string} text */
export function wrongLine(text) {
  let at = -1;
  parser.parse(text).iterate({
    enter({ type, from, to, node }) {
      if (at >= 0) return false;
      const wrong = type.isError
        ? !DOUBTFUL.has(node.parent?.name ?? "")
        : (type.name === "String" || type.name === "FormatString") && !isClosed(text.slice(from, to));
      if (wrong) at = from;
      return true;
    },
  });
  if (at < 0) return 0;
  // Where something is missing, the error begins at the next word, which may be lines away.
  return text.slice(0, at).trimEnd().split("\n").length;
}

/** Whether a string ends with its quotes; the parser ends one at the end of its line. @param {string} string */
function isClosed(string) {
  const [begin = "", quotes = ""] = STRING.exec(string) ?? [];
  return string.slice(begin.length).endsWith(quotes);
}
