// @ts-check
// Content filters: DDS expressions that select the messages of a subscription.

import { Fields } from "./fields.js";

/** @import { Sort, Value } from "./fields.js" */

/**
 * @typedef {{sort: Sort, of: (values: Values) => Value | undefined}} Operand a field or a literal
 * @typedef {(Value | undefined)[]} Values
 * @typedef {(values: Values) => boolean} Condition
 */

const TOKEN = /\s*(?:(<=|>=|<>|!=|[=<>()])|('(?:[^'\\]|\\.)*')|%(\d{1,2})(?!\w)|([-+]?(?:0[xX][\da-fA-F]+|(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)(?!\w))|([A-Za-z_][\w.[\]]*))/y;
const RESERVED = /^(AND|OR|NOT|BETWEEN|LIKE|MATCH)$/i;
/** @type {Record<string, (a: any, b: any) => boolean>} */
const COMPARE = {
  "=": (a, b) => a == b, // == because 64-bit integers are BigInt
  "<>": (a, b) => a != b,
  "!=": (a, b) => a != b,
  "<": (a, b) => a < b,
  "<=": (a, b) => a <= b,
  ">": (a, b) => a > b,
  ">=": (a, b) => a >= b,
};

/**
 * Return a function that tells whether a message passes the filter. Throws an Error that says what is wrong with the
 * expression or its parameters.
 * @param {string} definition of the message's type, see Fields
 * @param {string} expression such as "pose.x BETWEEN %0 AND %1 OR NOT name LIKE 'turtle%'"
 * @param {string[]} parameters the literals that replace %0, %1, …
 * @returns {(message: Uint8Array) => boolean}
 */
export function contentFilter(definition, expression, parameters) {
  const fields = new Fields(definition);
  const condition = new Parser(expression, parameters, fields).parse();
  return (message) => {
    try {
      return condition(fields.values(message));
    } catch {
      return true; // the message is of another type, which the program will report
    }
  };
}

class Parser {
  #tokens;
  #parameters;
  #fields;
  #at = 0;

  /** @param {string} expression @param {string[]} parameters @param {Fields} fields */
  constructor(expression, parameters, fields) {
    this.#tokens = tokens(expression);
    this.#parameters = parameters;
    this.#fields = fields;
  }

  parse() {
    const condition = this.#any();
    if (this.#at < this.#tokens.length) throw new Error(`'${this.#peek()}' is not expected here`);
    return condition;
  }

  /** @returns {Condition} */
  #any() {
    const all = [this.#every()];
    while (this.#skip("OR")) all.push(this.#every());
    return (values) => all.some((one) => one(values));
  }

  /** @returns {Condition} */
  #every() {
    const all = [this.#one()];
    while (this.#skip("AND")) all.push(this.#one());
    return (values) => all.every((one) => one(values));
  }

  /** @returns {Condition} */
  #one() {
    if (this.#skip("NOT")) {
      const condition = this.#one();
      return (values) => !condition(values);
    }
    if (this.#skip("(")) {
      const condition = this.#any();
      if (!this.#skip(")")) throw new Error("a ')' is missing");
      return condition;
    }
    return this.#predicate();
  }

  /** @returns {Condition} */
  #predicate() {
    const left = this.#operand();
    const negated = this.#skip("NOT");
    if (this.#skip("BETWEEN")) {
      const low = alike(left, this.#operand());
      if (!this.#skip("AND")) throw new Error("BETWEEN needs two values with AND between them");
      const high = alike(left, this.#operand());
      const between = both(left, low, (a, b) => a >= b);
      const below = both(left, high, (a, b) => a <= b);
      return (values) => (between(values) && below(values)) !== negated;
    }
    if (this.#skip("LIKE") || this.#skip("MATCH")) {
      const wild = /^LIKE$/i.test(this.#tokens[this.#at - 1] ?? "");
      const matches = pattern(left, alike(left, this.#operand()), wild);
      return (values) => matches(values) !== negated;
    }
    const compare = COMPARE[this.#peek()];
    if (!compare || negated) throw unexpected(this.#peek(), "a comparison is missing");
    this.#at += 1;
    return both(left, alike(left, this.#operand()), compare);
  }

  /** @returns {Operand} */
  #operand() {
    const token = this.#peek();
    this.#at += 1;
    if (/^%/.test(token)) {
      const parameter = this.#parameters[Number(token.slice(1))];
      if (parameter === undefined) throw new Error(`there is no parameter ${token}`);
      const [only, ...more] = tokens(parameter);
      const value = more.length || only === undefined ? undefined : literal(only);
      if (!value) throw new Error(`parameter ${token} is not a value: ${parameter} (quote texts: '…')`);
      return value;
    }
    const value = literal(token);
    if (value) return value;
    if (!/^[A-Za-z_]/.test(token) || RESERVED.test(token)) throw unexpected(token, "a value is missing");
    const { slot, sort } = this.#fields.find(token);
    return { sort, of: (values) => values[slot] };
  }

  #peek() {
    return this.#tokens[this.#at] ?? "";
  }

  /** Skip `word` if it is the next token; return whether it was. @param {string} word */
  #skip(word) {
    if (this.#peek().toUpperCase() !== word) return false;
    this.#at += 1;
    return true;
  }
}

/** @param {string} token @param {string} why */
function unexpected(token, why) {
  const what = token ? `'${token}' is not expected here` : "the expression ends too early";
  return new Error(`${what}: ${why}`);
}

/** @param {string} text */
function tokens(text) {
  const found = [];
  const trimmed = text.trimEnd();
  TOKEN.lastIndex = 0;
  while (TOKEN.lastIndex < trimmed.length) {
    const at = TOKEN.lastIndex;
    const match = TOKEN.exec(trimmed);
    if (!match) throw new Error(`'${trimmed.slice(at).trim()}' is not understood`);
    found.push(match[0].trim());
  }
  return found;
}

/** @param {string} token @returns {Operand | undefined} */
function literal(token) {
  if (token.startsWith("'")) {
    const text = token.slice(1, -1).replace(/\\(.)/g, "$1");
    return { sort: "text", of: () => text };
  }
  if (/^(TRUE|FALSE)$/i.test(token)) {
    const value = token.toUpperCase() === "TRUE";
    return { sort: "bool", of: () => value };
  }
  if (/^[-+.\d]/.test(token)) {
    const value = /^[-+]?\d{16,}$/.test(token) ? BigInt(token) : Number(token);
    return { sort: "number", of: () => value };
  }
  return undefined;
}

/** Return `right` if it can be compared with `left`, else throw. @param {Operand} left @param {Operand} right */
function alike(left, right) {
  if (left.sort !== right.sort) throw new Error(`a ${left.sort} cannot be compared with a ${right.sort}`);
  return right;
}

/** @param {Operand} left @param {Operand} right @param {(a: any, b: any) => boolean} compare @returns {Condition} */
function both(left, right, compare) {
  return (values) => {
    const [a, b] = [left.of(values), right.of(values)];
    return a !== undefined && b !== undefined && compare(a, b);
  };
}

/**
 * Return a condition that matches a whole text with a regular expression or, if `wild`, with a pattern: % and * match
 * any number of characters, _ and ? match one.
 * @param {Operand} text @param {Operand} like @param {boolean} wild @returns {Condition}
 */
function pattern(text, like, wild) {
  if (text.sort !== "text") throw new Error(`LIKE and MATCH are for texts, not for a ${text.sort}`);
  const source = String(like.of([]) ?? "");
  const plain = source.replace(/[\\^$.|+()[\]{}]/g, "\\$&").replace(/[%*]/g, ".*").replace(/[_?]/g, ".");
  const regex = new RegExp(`^(?:${wild ? plain : source})$`, "s");
  return (values) => regex.test(String(text.of(values) ?? ""));
}
