// Print which JavaScript files the given tsconfig files cover, and every function in them: its file, name, first
// line and number of lines. TypeScript is the parser; the output is JSON.

import { relative } from "node:path";
import { API } from "typescript/unstable/sync";
import { isCallExpression, isFunctionLikeDeclaration, isNewExpression } from "typescript/unstable/ast";

const root = process.cwd();
const api = new API({ cwd: root });
const snapshot = api.updateSnapshot({ openProjects: process.argv.slice(2) });
const found = { files: [], functions: [] };
for (const { program } of snapshot.getProjects()) {
  for (const path of program.getSourceFileNames()) {
    const file = relative(root, path);
    if (!file.endsWith(".js") || file.startsWith("..") || found.files.includes(file)) continue;
    const source = program.getSourceFile(path);
    found.files.push(file);
    visit(source, source, file);
  }
}
api.close();
console.log(JSON.stringify(found));

function visit(node, source, file) {
  if (isFunctionLikeDeclaration(node)) {
    const lineAt = (position) => source.getLineAndCharacterOfPosition(position).line + 1;
    const line = lineAt(node.getStart(source));
    found.functions.push({ file, name: nameOf(node), line, lines: lineAt(node.end) - line + 1 });
  }
  node.forEachChild((child) => void visit(child, source, file));
}

/** The name of a function, or of what it is assigned or passed to. */
function nameOf(node) {
  const { parent } = node;
  const name = node.name ?? parent.name;
  // `[Symbol.iterator]() {}` has a name that is computed.
  if (name) return name.text ?? "a computed name";
  if (!isCallExpression(parent) && !isNewExpression(parent)) return "a function";
  const { expression } = parent;
  return `an argument of ${(expression.name ?? expression).text ?? "a call"}`;
}
