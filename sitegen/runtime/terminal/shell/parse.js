// @ts-check
// The language of the terminal: a part of that of sh. Words with quotes and variables, pipes, redirections to files,
// and lists with ; & && and ||.

/**
 * @typedef {string | {variable: string}} Piece a text, or a variable that is replaced when the command runs
 * @typedef {Piece[]} Word
 * @typedef {{words: Word[], to: {file: Word, append: boolean} | undefined, from: Word | undefined,
 *   merged: boolean}} Command `merged` if its errors go where its output goes
 * @typedef {{commands: Command[], text: string}} Pipeline
 * @typedef {{pipeline: Pipeline, when: "always" | "success" | "failure"}} Step when it runs, by the status before it
 * @typedef {{steps: Step[], background: boolean, text: string}} List
 * @typedef {{kind: "word", word: Word, start: number, end: number}
 *   | {kind: "operator", text: string, start: number, end: number}} Token
 */

/** The line is not finished: a quote is open, or a line ends with an operator. */
export class Unfinished extends Error {}

const OPERATOR = /(?:2>&1|&&|\|\||>>|[;&|<>()\n])/y;
const VARIABLE = /\$(?:\{(\w+)\}|([A-Za-z_]\w*|[?$!#\d]))/y;
// The longest line, in characters.
const LONGEST = 100_000;

/** Parse a line. Throws Unfinished, or an Error that says what is wrong. @param {string} text @returns {List[]} */
export function parse(text) {
  if (text.length > LONGEST) throw new Error("line too long");
  return new Parser(text).lists();
}

/**
 * Split a text into tokens. Of an unfinished one, `lenient` takes what is there.
 * @param {string} text @param {boolean} [lenient] @returns {Token[]}
 */
export function tokens(text, lenient = false) {
  /** @type {Token[]} */
  const found = [];
  let at = 0;
  while (at < text.length) {
    const letter = text.charAt(at);
    if (letter === " " || letter === "\t" || text.startsWith("\\\n", at)) {
      at += letter === "\\" ? 2 : 1;
    } else if (letter === "#") {
      while (at < text.length && text[at] !== "\n") at++;
    } else {
      OPERATOR.lastIndex = at;
      const operator = OPERATOR.exec(text)?.[0];
      if (operator) {
        found.push({ kind: "operator", text: operator, start: at, end: at + operator.length });
        at += operator.length;
      } else {
        const { word, end } = readWord(text, at, lenient);
        found.push({ kind: "word", word, start: at, end });
        at = end;
      }
    }
  }
  return found;
}

/** @param {string} text @param {number} start @param {boolean} lenient */
function readWord(text, start, lenient) {
  /** @type {Word} */
  const word = [""];
  const add = (/** @type {string} */ more) => {
    if (typeof word.at(-1) === "string") word[word.length - 1] += more;
    else word.push(more);
  };
  let at = start;
  let quote = "";
  for (; at < text.length; at++) {
    const letter = text.charAt(at);
    if (!quote && /[\s;&|<>()]/.test(letter)) break;
    if (letter === quote) {
      quote = "";
    } else if (quote === "'") {
      add(letter);
    } else if (!quote && (letter === "'" || letter === '"')) {
      quote = letter;
    } else if (letter === "\\") {
      at = readEscape(text, at, quote, lenient, add);
    } else if (letter === "$" || letter === "`") {
      at = readVariable(text, at, word, add);
    } else {
      add(letter);
    }
  }
  if (quote && !lenient) throw new Unfinished(`unclosed ${quote}`);
  return { word, end: at };
}

/**
 * @param {string} text @param {number} at @param {string} quote @param {boolean} lenient
 * @param {(more: string) => void} add @returns {number} the place of its last character
 */
function readEscape(text, at, quote, lenient, add) {
  const next = text[at + 1];
  if (next === undefined) {
    if (!lenient) throw new Unfinished("unfinished escape");
    return at;
  }
  // Between double quotes, a backslash stays before anything that has no meaning there.
  if (quote && !'"\\$`\n'.includes(next)) add("\\");
  if (next !== "\n") add(next);
  return at + 1;
}

/**
 * @param {string} text @param {number} at @param {Word} word @param {(more: string) => void} add
 * @returns {number} the place of its last character
 */
function readVariable(text, at, word, add) {
  if (text[at] === "`" || text.startsWith("$(", at)) throw new Error("command substitution is not supported here");
  VARIABLE.lastIndex = at;
  const found = VARIABLE.exec(text);
  if (!found) {
    add("$");
    return at;
  }
  word.push({ variable: found[1] ?? found[2] ?? "" });
  return at + found[0].length - 1;
}

class Parser {
  #text;
  #tokens;
  #at = 0;

  /** @param {string} text */
  constructor(text) {
    this.#text = text;
    this.#tokens = tokens(text);
  }

  lists() {
    /** @type {List[]} */
    const found = [];
    this.#skipLines();
    while (this.#at < this.#tokens.length) {
      const list = this.#list();
      const end = this.#operator(";", "&", "\n");
      list.background = end === "&";
      found.push(list);
      this.#skipLines();
      if (!end && this.#at < this.#tokens.length) this.#fail();
    }
    return found;
  }

  /** @returns {List} */
  #list() {
    const start = this.#tokens[this.#at]?.start ?? 0;
    /** @type {Step[]} */
    const steps = [{ pipeline: this.#pipeline(), when: "always" }];
    for (;;) {
      const operator = this.#operator("&&", "||");
      if (!operator) break;
      this.#skipLines();
      steps.push({ pipeline: this.#pipeline(), when: operator === "&&" ? "success" : "failure" });
    }
    return { steps, background: false, text: this.#text.slice(start, this.#tokens[this.#at - 1]?.end) };
  }

  /** @returns {Pipeline} */
  #pipeline() {
    const start = this.#tokens[this.#at]?.start ?? 0;
    const commands = [this.#command()];
    while (this.#operator("|")) {
      this.#skipLines();
      commands.push(this.#command());
    }
    return { commands, text: this.#text.slice(start, this.#tokens[this.#at - 1]?.end) };
  }

  /** @returns {Command} */
  #command() {
    /** @type {Command} */
    const command = { words: [], to: undefined, from: undefined, merged: false };
    for (let token; (token = this.#tokens[this.#at]); this.#at++) {
      if (token.kind === "word") command.words.push(token.word);
      else if (token.text === "2>&1") command.merged = true;
      else if (token.text === ">" || token.text === ">>") command.to = { file: this.#file(), append: token.text === ">>" };
      else if (token.text === "<") command.from = this.#file();
      else break;
    }
    if (command.words.length === 0) this.#fail();
    return command;
  }

  #file() {
    const token = this.#tokens[++this.#at];
    if (token?.kind !== "word") this.#fail();
    return /** @type {Word} */ (/** @type {any} */ (token).word);
  }

  /** Take one of these operators, if it is next. @param {string[]} texts */
  #operator(...texts) {
    const token = this.#tokens[this.#at];
    if (token?.kind !== "operator" || !texts.includes(token.text)) return "";
    this.#at++;
    return token.text;
  }

  #skipLines() {
    while (this.#operator("\n"));
  }

  /** @returns {never} */
  #fail() {
    const token = this.#tokens[this.#at];
    if (!token) throw new Unfinished("unexpected end");
    const near = token.kind === "operator" ? token.text : this.#text.slice(token.start, token.end);
    throw new Error(`syntax error near unexpected token \`${near === "\n" ? "newline" : near}'`);
  }
}
