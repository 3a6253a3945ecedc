// @ts-check
// Arguments of commands, parsed as Python's argparse does, with its errors.

import { help, invocation, usage } from "./help.js";

/**
 * An argument: an option if it has `flags`, else positional. `count` is that of its values: "?" for an optional one,
 * "*" for any number, "+" for at least one, "..." for all that follow, and "flag" for an option without a value.
 * `alone` is the value of an option that may have one, and is given without.
 * @typedef {{name: string, flags?: string[], metavar?: string, help: string,
 *   count?: "?" | "*" | "+" | "..." | "flag", type?: Type, initial?: any, alone?: any, choices?: readonly string[],
 *   complete?: import("./words.js").Kind}} Argument
 * @typedef {{name: string, read(text: string): any}} Type it throws an Error if a text has no such value
 * @typedef {{prog: string, about: string, args: Argument[], tail?: string, after?: string}} Spec `tail` is the last
 *   part of the usage, and `after` the end of the help
 */

/** Wrong arguments: `text` is what argparse prints. */
export class UsageError extends Error {}
/** The arguments ask for help, which is the message. */
export class HelpAsked extends Error {}

const HELP = /** @type {Argument} */ (
  { name: "help", flags: ["-h", "--help"], count: "flag", help: "show this help message and exit" });

/** @type {Type} */
export const INT = { name: "int", read: (text) => {
  if (!/^\s*[-+]?\d[\d_]*\s*$/.test(text)) throw new Error("");
  return Number(text.replaceAll("_", ""));
} };
/** @type {Type} */
export const FLOAT = { name: "float", read: (text) => {
  if (!/^\s*[-+]?(\d[\d_]*\.?\d*|\.\d+)(e[-+]?\d+)?\s*$/i.test(text) && !/^\s*[-+]?(inf|nan)\w*\s*$/i.test(text)) throw new Error("");
  return /inf/i.test(text) ? Infinity : Number(text.replaceAll("_", ""));
} };

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
  /** @type {Argument[]} */
  #positionals;
  /** @type {Record<string, any>} */
  #found = {};
  /** @type {string[]} */
  #extra = [];
  /** @type {Set<Argument>} */
  #given = new Set();

  /** @param {Spec} spec @param {number} columns */
  constructor(spec, columns) {
    this.#spec = spec;
    this.#columns = columns;
    const all = argumentsOf(spec);
    this.#options = all.filter(({ flags }) => flags);
    this.#positionals = all.filter(({ flags }) => !flags);
    for (const { name, count, initial } of all) this.#found[name] = initial ?? (count === "flag" ? false : count === "*" || count === "+" ? [] : undefined);
  }

  /** @param {string[]} words @param {((words: string[]) => string) | undefined} unknown */
  parse(words, unknown) {
    const left = [...words];
    const waiting = [...this.#positionals];
    let onlyValues = false;
    while (left.length) {
      const word = /** @type {string} */ (left.shift());
      const next = waiting[0];
      if (word === "--" && !onlyValues) {
        onlyValues = true;
      } else if (!onlyValues && this.#isOption(word)) {
        this.#option(word, left);
      } else if (next) {
        if (next.count !== "*") waiting.shift();
        this.#store(next, next.count === "*" ? [...this.#found[next.name], this.#read(next, word)] : this.#read(next, word));
        // All that follows belongs to the program, options too.
        if (waiting[0]?.count === "...") this.#store(/** @type {Argument} */ (waiting.shift()), left.splice(0));
      } else {
        this.#extra.push(word);
      }
    }
    const needed = waiting.some(({ count }) => !count);
    const missing = waiting.filter(({ count }) => needed && (!count || count === "...")).map((one) => one.metavar ?? one.name);
    if (missing.length) this.#fail(`the following arguments are required: ${missing.join(", ")}`);
    if (this.#extra.length) {
      if (unknown) throw new UsageError(unknown(this.#extra));
      this.#fail(`unrecognized arguments: ${this.#extra.join(" ")}`);
    }
    return this.#found;
  }

  /** @param {string} word */
  #isOption(word) {
    if (!word.startsWith("-") || word === "-" || word.includes(" ")) return false;
    // A negative number is a value, unless there is an option like -1.
    const number = /^-\d+$|^-\d*\.\d+$/.test(word);
    return !number || this.#options.some(({ flags }) => flags?.some((flag) => /^-\d/.test(flag)));
  }

  /** @param {string} word @param {string[]} left */
  #option(word, left) {
    const [flag = "", given] = word.startsWith("--") ? cut(word, "=") : [word, undefined];
    const option = this.#find(flag);
    if (option) {
      this.#take(option, given, left);
      return;
    }
    // Several short options in one word, or one with its value: -tv, -n5.
    const short = word.startsWith("--") ? undefined : this.#find(word.slice(0, 2));
    if (!short) {
      this.#extra.push(word);
    } else if (short.count === "flag") {
      this.#take(short, undefined, left);
      this.#option(`-${word.slice(2)}`, left);
    } else {
      this.#take(short, word.slice(2).replace(/^=/, ""), left);
    }
  }

  /** @param {string} flag @returns {Argument | undefined} */
  #find(flag) {
    const exact = this.#options.find(({ flags }) => flags?.includes(flag));
    if (exact || !flag.startsWith("--")) return exact;
    const all = this.#options.flatMap((option) => (option.flags ?? []).map((name) => ({ option, name })));
    const fitting = all.filter(({ name }) => name.startsWith(flag));
    if (fitting.length > 1) {
      this.#fail(`ambiguous option: ${flag} could match ${fitting.map(({ name }) => name).join(", ")}`);
    }
    return fitting[0]?.option;
  }

  /** @param {Argument} option @param {string | undefined} given @param {string[]} left */
  #take(option, given, left) {
    if (option === HELP) throw new HelpAsked(help(this.#spec, argumentsOf(this.#spec), this.#columns));
    this.#given.add(option);
    if (option.count === "flag") {
      if (given !== undefined) this.#fail(`argument ${invocation(option)}: ignored explicit argument '${given}'`);
      this.#store(option, true);
      return;
    }
    if (option.count === "*" || option.count === "+") {
      const values = given === undefined ? [] : [given];
      while (left[0] !== undefined && !this.#isOption(left[0])) values.push(/** @type {string} */ (left.shift()));
      if (!values.length && option.count === "+") this.#fail(`argument ${invocation(option)}: expected at least one argument`);
      this.#store(option, values.map((value) => this.#read(option, value)));
      return;
    }
    const value = given ?? (left[0] === undefined || this.#isOption(left[0]) ? undefined : left.shift());
    if (value === undefined && option.count === "?") {
      this.#store(option, option.alone);
      return;
    }
    if (value === undefined) this.#fail(`argument ${invocation(option)}: expected one argument`);
    this.#store(option, this.#read(option, /** @type {string} */ (value)));
  }

  /** @param {Argument} argument @param {string} text */
  #read(argument, text) {
    const { type, choices } = argument;
    const name = argument.flags ? invocation(argument) : argument.metavar ?? argument.name;
    let value;
    try {
      value = type ? type.read(text) : text;
    } catch (error) {
      const said = error instanceof Error && error.message;
      this.#fail(`argument ${name}: ${said || `invalid ${type?.name} value: ${quoted(text)}`}`);
    }
    if (choices && !choices.includes(value)) {
      this.#fail(`argument ${name}: invalid choice: ${quoted(text)} (choose from ${choices.map(quoted).join(", ")})`);
    }
    return value;
  }

  /** @param {Argument} argument @param {any} value */
  #store({ name }, value) {
    this.#found[name] = value;
  }

  /** @param {string} text @returns {never} */
  #fail(text) {
    throw new UsageError(`${usage(this.#spec, argumentsOf(this.#spec), this.#columns)}\n${this.#spec.prog}: error: ${text}`);
  }
}

/** @param {string} text */
function quoted(text) {
  return text.includes("'") ? `"${text}"` : `'${text}'`;
}

/** @param {string} text @param {string} sign @returns {[string, string | undefined]} */
function cut(text, sign) {
  const at = text.indexOf(sign);
  return at < 0 ? [text, undefined] : [text.slice(0, at), text.slice(at + 1)];
}
