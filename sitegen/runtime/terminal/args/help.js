// @ts-check
// The usage and the help of commands, laid out as by argparse (Python 3.12, that of Jazzy and Kilted).

/** @import { Argument, Spec } from "./parse.js" */

// The help of arguments begins in this column at most.
const MOST_INDENT = 24;

/** How errors name an option: "-r/--rate". @param {Argument} option */
export function invocation({ flags = [] }) {
  return flags.join("/");
}

/** @param {Spec} spec @param {Argument[]} args @param {number} columns */
export function usage({ prog, tail }, args, columns) {
  const width = Math.max(columns - 2, 11);
  const options = bracketed(args.filter(({ flags }) => flags));
  const positionals = args.filter(({ flags }) => !flags).flatMap(positional);
  if (tail) positionals.push(tail);
  const whole = `usage: ${[prog, ...options, ...positionals].join(" ")}`;
  if (whole.length <= width) return whole;
  const start = `usage: ${prog}`;
  const indent = " ".repeat(start.length + 1);
  if (start.length <= 0.75 * width) {
    if (options.length) {
      return [...wrap([start, ...options], indent, width, start.length - prog.length), ...wrap(positionals, indent, width)].join("\n");
    }
    return wrap([start, ...positionals], indent, width, start.length - prog.length).join("\n");
  }
  const narrow = " ".repeat("usage: ".length);
  const all = wrap([...options, ...positionals], narrow, width);
  return [start, ...(all.length > 1 ? [...wrap(options, narrow, width), ...wrap(positionals, narrow, width)] : all)].join("\n");
}

/** @param {Spec} spec @param {Argument[]} args @param {number} columns */
export function help(spec, args, columns) {
  const width = Math.max(columns - 2, 11);
  const heads = args.map((one) => (one.flags ? header(one) : placeholder(one)));
  const indent = Math.min(Math.max(...heads.map((head) => head.length + 2)) + 2, MOST_INDENT);
  const section = (/** @type {string} */ title, /** @type {boolean} */ options) => {
    const lines = args.flatMap((one, index) => {
      if (Boolean(one.flags) !== options) return [];
      return entry(heads[index] ?? "", one.help, indent, width);
    });
    return lines.length ? [title, ...lines, ""] : [];
  };
  return [
    usage(spec, args, columns), "",
    ...(spec.about ? [spec.about, ""] : []),
    ...section("positional arguments:", false),
    ...section("options:", true),
    ...(spec.after ? [spec.after, ""] : []),
  ].join("\n").replace(/\n$/, "");
}

/** @param {string} head @param {string} text @param {number} indent @param {number} width */
function entry(head, text, indent, width) {
  const room = indent - 4;
  if (!text) return [`  ${head}`];
  const [first = "", ...rest] = paragraph(text, Math.max(width - indent, 11));
  const begin = head.length <= room ? [`  ${head.padEnd(room)}  ${first}`] : [`  ${head}`, " ".repeat(indent) + first];
  return [...begin, ...rest.map((line) => " ".repeat(indent) + line)];
}

// Pieces of a text between which Python's textwrap breaks lines: spaces, and words up to a hyphen between letters.
const PIECES =
  /\s+|(?<=[\w!"'&.,?])-{2,}(?=\w)|\S+?(?:-(?:(?<=[^\d\W]{2}-)|(?<=[^\d\W]-[^\d\W]-))(?=[^\d\W]-?[^\d\W])|(?=\s|$)|(?<=[\w!"'&.,?])(?=-{2,}\w))/g;

/** Break a text into lines. @param {string} text @param {number} width */
function paragraph(text, width) {
  /** @type {string[]} */
  const lines = [];
  let line = "";
  for (const piece of text.replace(/\s+/g, " ").match(PIECES) ?? []) {
    if ((line + piece).length <= width) {
      line += line || piece.trim() ? piece : "";
      continue;
    }
    let rest = piece;
    while (rest.length > width) {
      // As textwrap: after a hyphen if there is one, else where the line is full.
      const room = width - line.length;
      const hyphen = rest.lastIndexOf("-", room - 1);
      const end = hyphen > 0 && /[^-]/.test(rest.slice(0, hyphen)) ? hyphen + 1 : room;
      lines.push(line + rest.slice(0, end));
      rest = rest.slice(end);
      line = "";
    }
    if (line.trim()) lines.push(line.trimEnd());
    line = rest.trimStart();
  }
  return line.trim() ? [...lines, line.trimEnd()] : lines;
}

/** Options that exclude each other share brackets. @param {Argument[]} options @returns {string[]} */
function bracketed(options) {
  /** @type {Argument[][]} */
  const sets = [];
  for (const one of options) {
    const last = sets.at(-1);
    if (last && one.group && last[0]?.group === one.group) last.push(one);
    else sets.push([one]);
  }
  return sets.map((set) => `[${set.map(brief).join(" | ")}]`);
}

/** @param {Argument} option */
function brief(option) {
  const flag = option.flags?.[0] ?? "";
  return option.count === "flag" ? flag : `${flag} ${values(option)}`;
}

/** @param {Argument} option */
function header(option) {
  const flags = option.flags ?? [];
  return option.count === "flag" ? flags.join(", ") : flags.map((flag) => `${flag} ${values(option)}`).join(", ");
}

/** @param {Argument} option */
function values(option) {
  const name = placeholder(option);
  if (option.count === "+") return `${name} [${name} ...]`;
  return option.count === "*" ? `[${name} ...]` : option.count === "?" ? `[${name}]` : name;
}

/** @param {Argument} argument */
function placeholder({ metavar, choices, name, flags }) {
  return metavar ?? (choices ? `{${choices.join(",")}}` : flags ? name.toUpperCase() : name);
}

/** The parts of a positional argument, between which lines break. @param {Argument} argument @returns {string[]} */
function positional(argument) {
  const name = placeholder(argument);
  if (argument.count === "?") return [`[${name}]`];
  if (argument.count === "*") return [`[${name} ...]`];
  if (argument.count === "+") return [name, `[${name} ...]`];
  return [argument.count === "..." ? "..." : name];
}

/** @param {string[]} parts @param {string} indent @param {number} width @param {number} [first] what precedes them */
function wrap(parts, indent, width, first = 0) {
  /** @type {string[]} */
  const lines = [];
  let line = "";
  for (const part of parts) {
    const before = lines.length || !first ? indent.length : 0;
    if (line && before + line.length + 1 + part.length > width) {
      lines.push(line);
      line = part;
    } else {
      line = line ? `${line} ${part}` : part;
    }
  }
  if (line) lines.push(line);
  return lines.map((each, index) => (index || !first ? indent + each : each));
}
