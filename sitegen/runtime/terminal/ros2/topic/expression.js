// @ts-check
// The Python expressions of --filter, as far as they compare and compute: `m` is the message. There is no Python here,
// so lambdas, comprehensions and imports are errors.

import { isMessage, parseFieldType } from "../../../messages/fieldType.js";
import { Failure } from "../../shell/shell.js";
import { FUNCTIONS, isTrue, METHODS, OPERATIONS } from "./expressionValues.js";

/** @import { Types } from "../python.js" */
/** @typedef {(m: any) => any} Part evaluates a part of an expression */

const TOKEN =
  /\s*(?:(?<number>(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?(?!\w))|(?<text>'(?:[^'\\]|\\.)*'|"(?:[^"\\]|\\.)*")|(?<name>[A-Za-z_]\w*)|(?<sign>\*\*|\/\/|[<>=!]=|[-+*/%<>()[\],.])|(?<end>$))/iy;
const CONSTANTS = { True: true, False: false, None: null };
const COMPARISONS = ["==", "!=", "<", "<=", ">", ">=", "in", "not in", "is", "is not"];
/** Operators of two values, from the weakest to the strongest. */
const LEVELS = [["+", "-"], ["*", "/", "//", "%"]];
const ESCAPES = { n: "\n", t: "\t", r: "\r", 0: "\0", "\n": "" };

/** A message, whose fields are attributes. */
class Message {
  /** @param {any} fields @param {string} type @param {Types} types */
  constructor(fields, type, types) {
    this.fields = fields;
    this.type = type;
    this.types = types;
  }
}

/** @param {any} value @param {string} type @param {Types} types @returns {any} */
function wrapped(value, type, types) {
  const { base, array } = parseFieldType(type);
  if (array) return Array.from(value, (one) => wrapped(one, base, types));
  if (isMessage(base)) return new Message(value, base, types);
  return typeof value === "bigint" ? Number(value) : value;
}

/**
 * Return whether an expression is true of a value. Throws a Failure if it is not one.
 * @param {string} text @returns {(value: any, type: string, types: Types) => boolean}
 */
export function expression(text) {
  const part = new Parser(text).parse();
  return (value, type, types) => isTrue(part(wrapped(value, type, types)));
}

class Parser {
  #text;
  #at = 0;
  /** The next token. */
  #kind = "";
  #word = "";

  /** @param {string} text */
  constructor(text) {
    this.#text = text;
    this.#advance();
  }

  /** @returns {Part} */
  parse() {
    const part = this.#choice();
    if (this.#kind !== "end") this.#fail();
    return part;
  }

  #advance() {
    TOKEN.lastIndex = this.#at;
    const found = TOKEN.exec(this.#text)?.groups;
    if (!found) this.#fail();
    [this.#kind, this.#word] = Object.entries(found ?? {}).find(([, word]) => word !== undefined) ?? ["", ""];
    this.#at = TOKEN.lastIndex;
  }

  /** @returns {never} */
  #fail() {
    throw new Failure(`--filter: '${this.#text}' is not an expression that this terminal knows (at column ${this.#at + 1})`);
  }

  /** Take the next token if it is one of these. @param {string[]} words */
  #take(...words) {
    if ((this.#kind !== "sign" && this.#kind !== "name") || !words.includes(this.#word)) return "";
    const word = this.#word;
    this.#advance();
    return word;
  }

  /** @param {string} word */
  #expect(word) {
    if (!this.#take(word)) this.#fail();
  }

  /** a if b else c @returns {Part} */
  #choice() {
    const first = this.#any();
    if (!this.#take("if")) return first;
    const test = this.#any();
    this.#expect("else");
    const other = this.#choice();
    return (m) => (isTrue(test(m)) ? first(m) : other(m));
  }

  /** @returns {Part} */
  #any() {
    const parts = [this.#all()];
    while (this.#take("or")) parts.push(this.#all());
    return (m) => parts.reduce((found, part, index) => (index && !isTrue(found) ? part(m) : found), parts[0]?.(m));
  }

  /** @returns {Part} */
  #all() {
    const parts = [this.#not()];
    while (this.#take("and")) parts.push(this.#not());
    return (m) => parts.reduce((found, part, index) => (index && isTrue(found) ? part(m) : found), parts[0]?.(m));
  }

  /** @returns {Part} */
  #not() {
    if (!this.#take("not")) return this.#comparison();
    const inner = this.#not();
    return (m) => !isTrue(inner(m));
  }

  /** Comparisons may be chained: 0 < m.data < 5. @returns {Part} */
  #comparison() {
    const first = this.#binary(0);
    /** @type {{operate: (a: any, b: any) => any, part: Part}[]} */
    const rest = [];
    for (let sign; (sign = this.#take(...COMPARISONS, "not"));) {
      if (sign === "not") {
        this.#expect("in");
        sign = "not in";
      } else if (sign === "is" && this.#take("not")) sign = "is not";
      rest.push({ operate: operation(sign), part: this.#binary(0) });
    }
    return rest.length ? (m) => {
      let left = first(m);
      return rest.every(({ operate, part }) => {
        const right = part(m);
        const fits = operate(left, right);
        left = right;
        return fits;
      });
    } : first;
  }

  /** @param {number} level @returns {Part} */
  #binary(level) {
    const signs = LEVELS[level];
    if (!signs) return this.#unary();
    let left = this.#binary(level + 1);
    for (let sign; (sign = this.#take(...signs));) {
      const [before, operate, after] = [left, operation(sign), this.#binary(level + 1)];
      left = (m) => operate(before(m), after(m));
    }
    return left;
  }

  /** @returns {Part} */
  #unary() {
    const sign = this.#take("-", "+");
    if (!sign) return this.#power();
    const inner = this.#unary();
    return (m) => (sign === "-" ? operation("-")(0, inner(m)) : inner(m));
  }

  /** @returns {Part} */
  #power() {
    const base = this.#postfix();
    if (!this.#take("**")) return base;
    const exponent = this.#unary();
    return (m) => operation("**")(base(m), exponent(m));
  }

  /** Attributes, indices and calls. @returns {Part} */
  #postfix() {
    let part = this.#atom();
    for (let sign; (sign = this.#take(".", "["));) {
      const inner = part;
      if (sign === "[") {
        const index = this.#choice();
        this.#expect("]");
        part = (m) => item(inner(m), index(m));
        continue;
      }
      const name = this.#word;
      if (this.#kind !== "name") this.#fail();
      this.#advance();
      if (this.#take("(")) {
        const values = this.#list(")");
        part = (m) => method(inner(m), name)(inner(m), ...values.map((value) => value(m)));
      } else {
        part = (m) => attribute(inner(m), name);
      }
    }
    return part;
  }

  /** @param {string} end @returns {Part[]} */
  #list(end) {
    /** @type {Part[]} */
    const parts = [];
    while (!this.#take(end)) {
      if (parts.length) this.#expect(",");
      parts.push(this.#choice());
    }
    return parts;
  }

  /** @returns {Part} */
  #atom() {
    const [kind, word] = [this.#kind, this.#word];
    if (this.#take("(")) {
      const inner = this.#choice();
      this.#expect(")");
      return inner;
    }
    if (this.#take("[")) {
      const parts = this.#list("]");
      return (m) => parts.map((part) => part(m));
    }
    if (!["number", "text", "name"].includes(kind)) this.#fail();
    this.#advance();
    if (kind === "number") return () => Number(word);
    if (kind === "text") return () => word.slice(1, -1).replace(/\\([^])/g, (_, letter) => ESCAPES[/** @type {"n"} */ (letter)] ?? letter);
    if (Object.hasOwn(CONSTANTS, word)) return () => CONSTANTS[/** @type {"True"} */ (word)];
    if (word === "m") return (m) => m;
    const called = Object.hasOwn(FUNCTIONS, word) ? FUNCTIONS[word] : undefined;
    if (!called || !this.#take("(")) throw new Failure(`--filter: name '${word}' is not defined`);
    const values = this.#list(")");
    return (m) => called(...values.map((value) => value(m)));
  }
}

/** @param {string} sign @returns {(a: any, b: any) => any} */
function operation(sign) {
  return /** @type {any} */ (OPERATIONS[sign]);
}

/** @param {any} value @param {string} name */
function attribute(value, name) {
  if (value instanceof Message) {
    const field = value.types[value.type]?.fields.find((one) => one.name === name);
    if (field) return wrapped(value.fields[name], field.type, value.types);
  }
  throw new Failure(`'${nameOfType(value)}' object has no attribute '${name}'`);
}

/** @param {any} value @param {string} name @returns {(...values: any[]) => any} */
function method(value, name) {
  const known = typeof value === "string" && Object.hasOwn(METHODS, name) ? METHODS[name] : undefined;
  if (!known) throw new Failure(`'${nameOfType(value)}' object has no attribute '${name}'`);
  return known;
}

/** @param {any} value @param {any} index */
function item(value, index) {
  if (typeof value !== "string" && !Array.isArray(value)) throw new Failure(`'${nameOfType(value)}' object is not subscriptable`);
  const found = value.at(index);
  if (found === undefined) throw new Failure("list index out of range");
  return found;
}

/** @param {any} value */
function nameOfType(value) {
  if (value instanceof Message) return value.type.split("/").at(-1) ?? "";
  if (value === null) return "NoneType";
  if (Array.isArray(value)) return "list";
  if (typeof value === "string") return "str";
  if (typeof value === "boolean") return "bool";
  return Number.isInteger(value) ? "int" : "float";
}
