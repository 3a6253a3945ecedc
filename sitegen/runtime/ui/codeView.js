// @ts-check
// CodeMirror, with the colours of the theme.

import {
  bracketMatching, Decoration, defaultKeymap, drawSelection, EditorState, EditorView, highlightActiveLine,
  HighlightStyle, history, historyKeymap, indentOnInput, indentWithTab, keymap, lineNumbers,
  StateEffect, StateField, syntaxHighlighting, tags,
} from "../vendor/codemirror.js";

// In the same bundle, since those who show code need both.
export { PYTHON } from "./pythonSyntax.js";
export * from "../vendor/codemirror.js";

/**
 * @typedef {{name: string, from: number, to: number, type: {isError: boolean}, parent: SyntaxNode | null}} SyntaxNode
 * @typedef {{parser: import("@lezer/common").Parser, extensions: import("@codemirror/state").Extension[],
 *   isMistake(node: SyntaxNode, text: string): boolean}} Language `isMistake` says of each node of the syntax tree of a
 *   text whether it is a syntax error
 */

const LOOK = EditorView.theme({
  "&": { color: "var(--text)", backgroundColor: "var(--surface)", height: "100%", fontSize: "0.875rem" },
  // Above the line numbers, which would cover an outline.
  "&.cm-focused": { outline: "none" },
  "&.cm-focused::after": {
    content: '""', position: "absolute", inset: "0", zIndex: "300", border: "2px solid var(--accent)",
    pointerEvents: "none",
  },
  ".cm-scroller": { fontFamily: "var(--font-code)", lineHeight: "1.55" },
  ".cm-gutters": { color: "var(--muted)", backgroundColor: "var(--surface)", border: "none" },
  ".cm-activeLine, .cm-activeLineGutter": {
    backgroundColor: "color-mix(in srgb, var(--accent) 8%, transparent)",
  },
  ".cm-cursor": { borderLeftColor: "var(--text)" },
  "&.cm-focused > .cm-scroller > .cm-selectionLayer .cm-selectionBackground, .cm-selectionBackground": {
    background: "color-mix(in srgb, var(--accent) 28%, transparent)",
  },
  // All lines, whole.
  "@media print": {
    "&": { height: "auto" },
    ".cm-scroller": { overflow: "visible" },
    ".cm-content": { whiteSpace: "pre-wrap", overflowWrap: "anywhere", minWidth: "0", flexShrink: "1" },
  },
  ".cm-wrong": { backgroundColor: "color-mix(in srgb, var(--danger) 22%, transparent)" },
});

const COLOURS = HighlightStyle.define([
  { tag: tags.comment, color: "var(--code-comment)", fontStyle: "italic" },
  { tag: [tags.keyword, tags.operatorKeyword, tags.self], color: "var(--code-keyword)" },
  { tag: [tags.className, tags.typeName], color: "var(--code-type)" },
  { tag: [tags.function(tags.variableName), tags.function(tags.definition(tags.variableName))], color: "var(--code-function)" },
  { tag: [tags.string, tags.special(tags.string)], color: "var(--code-string)" },
  { tag: [tags.number, tags.bool, tags.null], color: "var(--code-number)" },
  { tag: tags.meta, color: "var(--code-meta)" },
]);

/** Marks a line as wrong; 0 removes the mark. @type {import("@codemirror/state").StateEffectType<number>} */
const mark = StateEffect.define();
const marked = StateField.define({
  create: () => Decoration.none,
  update(marks, change) {
    marks = marks.map(change.changes);
    for (const effect of change.effects) {
      if (!effect.is(mark)) continue;
      const line = effect.value;
      const known = line > 0 && line <= change.state.doc.lines;
      marks = known
        ? Decoration.set([Decoration.line({ class: "cm-wrong" }).range(change.state.doc.line(line).from)])
        : Decoration.none;
    }
    return marks;
  },
  provide: (field) => EditorView.decorations.from(field),
});

/**
 * Show an editor in a shadow root of `element`. There CodeMirror uses constructed style sheets, which the page's
 * Content-Security-Policy allows; inline styles are blocked.
 * @param {HTMLElement} element
 * @param {{text: string, language: Language, label: string, changed(text: string): void, run(): void,
 *   complete?: () => void}} options `run` is called for Ctrl-Enter, and `complete` for Tab after a word; without it, Tab
 *   always indents
 */
export function codeView(element, { text, language, label, changed, run, complete }) {
  const root = element.attachShadow({ mode: "open" });
  const view = new EditorView({
    root,
    parent: root,
    state: EditorState.create({
      doc: text,
      extensions: [
        lineNumbers(), history(), drawSelection(), indentOnInput(), bracketMatching(), highlightActiveLine(),
        ...language.extensions, syntaxHighlighting(COLOURS), LOOK, marked,
        keymap.of([...runKeys(run), ...completeKeys(complete), ...defaultKeymap, ...historyKeymap, indentWithTab]),
        EditorView.contentAttributes.of({ "aria-label": label, tabindex: "0" }),
        EditorView.updateListener.of((update) => {
          if (update.docChanged) changed(update.state.doc.toString());
        }),
      ],
    }),
  });
  return {
    /** @param {string} other */
    set(other) {
      view.dispatch({ changes: { from: 0, to: view.state.doc.length, insert: other } });
    },
    /** Replace a part of the text, and put the cursor behind. @param {number} from @param {number} to @param {string} other */
    replace(from, to, other) {
      const at = from + other.length;
      view.dispatch({ changes: { from, to, insert: other }, selection: { anchor: at } });
    },
    cursor: () => ({ text: view.state.doc.toString(), at: view.state.selection.main.head }),
    /** @param {number} line */
    mark(line) {
      view.dispatch({ effects: mark.of(line) });
    },
    focus: () => view.focus(),
    destroy: () => view.destroy(),
  };
}

/** The keys that run the code; Cmd-Enter is what people on a Mac press. @param {() => void} run */
function runKeys(run) {
  return ["Ctrl-Enter", "Cmd-Enter"].map((key) => ({
    key,
    run() {
      run();
      return true;
    },
  }));
}

/** Tab completes a word; at the start of a line, or with a selection, it indents. @param {(() => void) | undefined} complete */
function completeKeys(complete) {
  if (!complete) return [];
  return [{
    key: "Tab",
    run(/** @type {EditorView} */ { state }) {
      const { empty, head } = state.selection.main;
      if (!empty || !/[\w.]$/.test(state.doc.lineAt(head).text.slice(0, head - state.doc.lineAt(head).from))) return false;
      complete();
      return true;
    },
  }];
}

/**
 * Return the number of the first line with a syntax error, or 0. Not all errors are found.
 * @param {string} text @param {Language} language
 */
export function wrongLine(text, { parser, isMistake }) {
  let at = -1;
  parser.parse(text).iterate({
    enter({ node }) {
      if (at < 0 && isMistake(node, text)) at = node.from;
      return at < 0;
    },
  });
  if (at < 0) return 0;
  // Where something is missing, the error begins at the next word, which may be lines away.
  return text.slice(0, at).trimEnd().split("\n").length;
}
