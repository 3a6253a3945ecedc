// @ts-check
// Arguments of commands, parsed as Python's argparse does, with its errors.

import { quoted as repr } from "../ros2/python.js";
import { help, invocation, usage } from "./help.js";

/**
 * An argument: an option if it has `flags`, else positional. `count` is that of its values: "?" for an optional one,
 * "*" for any number, "+" for at least one, "..." for all that follow, "1" for a list of one, "append" for one each
 * time that the option is given, and "flag" for an option without a value. `alone` is the value of an option that may
 * have one, and is given without. Of the arguments with the same `group`, only one may be given.
 * @typedef {{name: string, flags?: string[], metavar?: string, help: string,
 *   count?: "?" | "*" | "+" | "..." | "1" | "append" | "flag", type?: Type, initial?: any, alone?: any,
 *   choices?: readonly any[], group?: string, complete?: import("./words.js").Kind}} Argument
 * @typedef {{name: string, read(text: string): any}} Type it throws an Error if a text has no such value
 * @typedef {{prog: string, about: string, args: Argument[], tail?: string, after?: string}} Spec `tail` is the last
 *   part of the usage, and `after` the end of the help
 */

/** Wrong arguments: `text` is what argparse prints. */
export class UsageError extends Error {}
/** The arguments ask for help, which is the message. */
export class HelpAsked extends Error {}

/** The counts of arguments whose value is a list, empty if they are not given. */
const LISTS = new Set(["*", "+", "append"]);

/** An option among the words: what it is, how it is written, and the value that is in the same word. */
/** @typedef {{argument: Argument | undefined, flag: string, value: string | undefined}} Option */

/** The kinds of words that arguments take, by their count. @type {Record<string, string>} */
const POSITIONAL_VALUES = { "": "-*A-*", "?": "-*A?-*", "*": "[A-]*", "+": "-*A[A-]*", "...": "[-AO]*" };
/** @type {Record<string, RegExp>} */
const OPTION_VALUES = { "": /^A/, "1": /^A/, append: /^A/, "?": /^A?/, "*": /^A*/, "+": /^A+/, flag: /^/ };
/** @type {Record<string, string>} */
const EXPECTED = { "1": "1 argument", "+": "at least one argument" };

const HELP = /** @type {Argument} */ (
  { name: "help", flags: ["-h", "--help"], count: "flag", help: "show this help message and exit" });

/** All arguments of a command, with --help. @param {Spec} spec @returns {Argument[]} */
export function argumentsOf({ args }) {
  return [HELP, ...args];
}

/**
 * Parse `words`. Without `rest`, words that nothing takes are errors.
 * @param {Spec} spec @param {string[]} words @param {number} columns the width of help
 * @param {(words: string[]) => string} [unknown] returns the error of words that nothing takes
 * @returns {Record<string, any>} values by name
 */
export function parse(spec, words, columns, unknown) {
  return new Run(spec, columns).parse(words, unknown);
}

class Run {
  #spec;
  #columns;
  /** @type {Argument[]} */
  #options;
  /** The positional arguments that have no value yet. @type {Argument[]} */
  #positionals;
  /** @type {Record<string, any>} */
  #found = {};
  /** @type {string[]} */
  #extra = [];
  /** @type {Set<Argument>} */
  #seen = new Set();
  /** Those that are given, and do not only have their initial value. @type {Set<Argument>} */
  #given = new Set();
  /** @type {string[]} */
  #words = [];
  /** The options among the words. @type {(Option | undefined)[]} */
  #marked = [];
  /** A letter for each word: O for options, A for values, - for "--". */
  #kinds = "";

  /** @param {Spec} spec @param {number} columns */
  constructor(spec, columns) {
    this.#spec = spec;
    this.#columns = columns;
    const all = argumentsOf(spec);
    this.#options = all.filter(({ flags }) => flags);
    this.#positionals = all.filter(({ flags }) => !flags);
    for (const { name, count, initial } of all) this.#found[name] = initial ?? (count === "flag" ? false : LISTS.has(count ?? "") ? [] : undefined);
  }

  /** @param {string[]} words @param {((words: string[]) => string) | undefined} unknown */
  parse(words, unknown) {
    this.#words = words;
    const values = words.indexOf("--");
    this.#marked = words.map((word, index) => (values >= 0 && index >= values ? undefined : this.#optionOf(word)));
    this.#kinds = words.map((_, index) => (this.#marked[index] ? "O" : index === values ? "-" : "A")).join("");
    const required = this.#positionals.filter(({ count }) => count !== "?");
    const last = this.#kinds.lastIndexOf("O");
    let at = 0;
    while (at <= last) {
      const next = this.#kinds.indexOf("O", at);
      const end = at === next ? at : this.#takePositionals(at);
      if (end > at) {
        at = end;
        continue;
      }
      this.#extra.push(...words.slice(at, next));
      at = this.#takeOption(next);
    }
    this.#extra.push(...words.slice(this.#takePositionals(at)));
    const missing = required.filter((one) => !this.#seen.has(one)).map((one) => one.metavar ?? one.name);
    if (missing.length) this.#fail(`the following arguments are required: ${missing.join(", ")}`);
    if (this.#extra.length) {
      if (unknown) throw new UsageError(unknown(this.#extra));
      this.#fail(`unrecognized arguments: ${this.#extra.join(" ")}`);
    }
    return this.#found;
  }

  /** The option that a word is; its `argument` is undefined if there is none. @param {string} word @returns {Option | undefined} */
  #optionOf(word) {
    if (!word.startsWith("-") || word === "-") return undefined;
    const exact = this.#named(word);
    if (exact) return { argument: exact, flag: word, value: undefined };
    const [flag, value] = cut(word, "=");
    const cutOff = value === undefined ? undefined : this.#named(flag);
    if (cutOff) return { argument: cutOff, flag, value };
    const fitting = this.#abbreviated(word, flag, value);
    if (fitting.length > 1) this.#fail(`ambiguous option: ${word} could match ${fitting.map((one) => one.flag).join(", ")}`);
    if (fitting[0]) return fitting[0];
    // A negative number is a value, unless there is an option like -1.
    if (/^-\d+$|^-\d*\.\d+$/.test(word) && !this.#options.some(({ flags }) => flags?.some((one) => /^-\d/.test(one)))) return undefined;
    return word.includes(" ") ? undefined : { argument: undefined, flag: word, value: undefined };
  }

  /** @param {string} flag */
  #named(flag) {
    return this.#options.find(({ flags }) => flags?.includes(flag));
  }

  /** The options that a word may be the beginning of, or that have their value in it, as -n5. @param {string} word @param {string} flag @param {string | undefined} value */
  #abbreviated(word, flag, value) {
    const long = word.startsWith("--");
    return this.#options.flatMap((argument) => (argument.flags ?? []).flatMap((name) => {
      if (!long && name === word.slice(0, 2)) return [{ argument, flag: name, value: word.slice(2) }];
      return name.startsWith(long ? flag : word) ? [{ argument, flag: name, value: long ? value : undefined }] : [];
    }));
  }

  /** Take the option at a place, and return where the next word is. @param {number} at */
  #takeOption(at) {
    let { argument, flag, value } = /** @type {Option} */ (this.#marked[at]);
    if (!argument) {
      this.#extra.push(this.#words[at] ?? "");
      return at + 1;
    }
    // Several flags in one word: -tv.
    const flags = [];
    while (value && argument.count === "flag" && !flag.startsWith("--")) {
      const next = this.#named(`-${value.charAt(0)}`);
      if (!next) break;
      flags.push(argument);
      [argument, flag, value] = [next, `-${value.charAt(0)}`, value.slice(1) || undefined];
    }
    const joined = value !== undefined;
    if (joined && argument.count === "flag") this.#fail(`argument ${invocation(argument)}: ignored explicit argument ${quoted(value ?? "")}`);
    for (const one of flags) this.#store(one, []);
    if (joined) {
      this.#store(argument, [value ?? ""]);
      return at + 1;
    }
    const length = OPTION_VALUES[argument.count ?? ""]?.exec(this.#kinds.slice(at + 1))?.[0].length;
    if (length === undefined) this.#fail(`argument ${invocation(argument)}: expected ${EXPECTED[argument.count ?? ""] ?? "one argument"}`);
    const end = at + 1 + (length ?? 0);
    this.#store(argument, this.#words.slice(at + 1, end));
    return end;
  }

  /** Give the words at a place to as many positional arguments as they suffice for, and return where they end. @param {number} at */
  #takePositionals(at) {
    for (let count = this.#positionals.length; count > 0; count--) {
      const taken = this.#positionals.slice(0, count);
      const pattern = taken.map((one) => `(${POSITIONAL_VALUES[one.count ?? ""]})`).join("");
      const found = new RegExp(`^${pattern}`).exec(this.#kinds.slice(at));
      if (!found) continue;
      this.#positionals = this.#positionals.slice(count);
      for (const [index, argument] of taken.entries()) {
        const end = at + (found[index + 1]?.length ?? 0);
        const words = this.#words.slice(at, end);
        const dashes = argument.count === "..." ? -1 : words.indexOf("--");
        this.#store(argument, dashes < 0 ? words : words.toSpliced(dashes, 1));
        at = end;
      }
      break;
    }
    return at;
  }

  /** Read the words of an argument, and keep its value. @param {Argument} argument @param {string[]} words */
  #store(argument, words) {
    const { name, count, alone, flags } = argument;
    if (argument === HELP) throw new HelpAsked(help(this.#spec, argumentsOf(this.#spec), this.#columns));
    this.#seen.add(argument);
    // What may be left out keeps its initial value.
    if (!flags && !words.length && (count === "?" || count === "*")) return;
    const values = count === "..." ? words : words.map((word) => this.#read(argument, word));
    // As upstream, which compares with the default by identity: that of a number is its value.
    if (typeof values[0] !== "number" || values[0] !== argument.initial) this.#exclude(argument);
    if (count === "flag") this.#found[name] = true;
    else if (count === "append") this.#found[name] = [...this.#found[name], ...values];
    else if (count && count !== "?") this.#found[name] = values;
    else this.#found[name] = words.length ? values[0] : alone;
  }

  /** Note that an argument is given, which another one may exclude. @param {Argument} argument */
  #exclude(argument) {
    if (!argument.group) return;
    const other = [...this.#given].find((one) => one !== argument && one.group === argument.group);
    if (other) this.#fail(`argument ${named(argument)}: not allowed with argument ${named(other)}`);
    this.#given.add(argument);
  }

  /** @param {Argument} argument @param {string} text */
  #read(argument, text) {
    const { type, choices } = argument;
    const name = named(argument);
    let value;
    try {
      value = type ? type.read(text) : text;
    } catch (error) {
      const said = error instanceof Error && error.message;
      this.#fail(`argument ${name}: ${said || `invalid ${type?.name} value: ${quoted(text)}`}`);
    }
    if (choices && !choices.includes(value)) {
      this.#fail(`argument ${name}: invalid choice: ${quoted(value)} (choose from ${choices.map(quoted).join(", ")})`);
    }
    return value;
  }

  /** @param {string} text @returns {never} */
  #fail(text) {
    throw new UsageError(`${usage(this.#spec, argumentsOf(this.#spec), this.#columns)}\n${this.#spec.prog}: error: ${text}`);
  }
}

/** How errors name an argument. @param {Argument} argument */
function named(argument) {
  return argument.flags ? invocation(argument) : argument.metavar ?? argument.name;
}

/** As repr(). @param {string | number} value */
function quoted(value) {
  return typeof value === "number" ? String(value) : repr(value);
}

/** @param {string} text @param {string} sign @returns {[string, string | undefined]} */
function cut(text, sign) {
  const at = text.indexOf(sign);
  return at < 0 ? [text, undefined] : [text.slice(0, at), text.slice(at + 1)];
}
