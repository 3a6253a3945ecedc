// @ts-check
// Filters at the end of a pipe: grep, head, tail, wc and what is like them.

import { HelpAsked, parse, UsageError } from "../args/parse.js";
import { INT } from "../args/types.js";
import { Pipe } from "./pipe.js";
import { Failure } from "./shell.js";
import { less, sort, tee, uniq } from "./texts.js";

/** @import { Argument } from "../args/parse.js" */
/** @import { Io, Program } from "./shell.js" */

// The largest number of lines that tail keeps.
const MOST = 100_000;

/** @type {(name: string, flags: string[], help: string, more?: Partial<Argument>) => Argument} */
const option = (name, flags, help, more) => ({ name, flags, help, count: "flag", ...more });
const FILES = /** @type {Argument} */ ({ name: "file", count: "*", help: "files; without them, the pipe", complete: "file" });
const COUNT = { count: undefined, type: INT, initial: 10, metavar: "N" };

/** @type {Program[]} */
export const FILTERS = [
  filter("less", "show a text page by page: Space, Enter, q", [FILES], less),
  filter("sort", "sort lines", [
    option("reverse", ["-r", "--reverse"], "in reverse"),
    option("numeric", ["-n", "--numeric-sort"], "by the numbers that they begin with"),
    option("unique", ["-u", "--unique"], "without repetitions"),
    FILES,
  ], sort),
  filter("tee", "write what comes through a pipe to files, too", [
    option("append", ["-a", "--append"], "append to the files"), { ...FILES, help: "files" },
  ], tee),
  filter("uniq", "leave out lines that repeat the one before", [
    option("counted", ["-c", "--count"], "print how often each occurs"),
    option("repeated", ["-d", "--repeated"], "print repeated lines only"),
    option("single", ["-u", "--unique"], "print the others only"),
    FILES,
  ], uniq),
  filter("grep", "print the lines that match a pattern", [
    option("ignore", ["-i", "--ignore-case"], "ignore case"),
    option("invert", ["-v", "--invert-match"], "the lines that do not match"),
    option("counted", ["-c", "--count"], "print their number"),
    option("numbered", ["-n", "--line-number"], "print line numbers"),
    option("quiet", ["-q", "--quiet"], "print nothing; the status tells"),
    option("fixed", ["-F", "--fixed-strings"], "the pattern is a text"),
    option("extended", ["-E", "--extended-regexp"], "the pattern is a regular expression (always)"),
    option("after", ["-A", "--after-context"], "print so many lines after each", { count: undefined, type: INT, initial: 0, metavar: "N" }),
    option("most", ["-m", "--max-count"], "stop after so many lines", { count: undefined, type: INT, initial: Infinity, metavar: "N" }),
    { name: "pattern", help: "regular expression" },
    FILES,
  ], grep),
  filter("head", "print the first lines", [option("lines", ["-n", "--lines"], "their number", COUNT), FILES], head),
  filter("tail", "print the last lines", [option("lines", ["-n", "--lines"], "their number", COUNT), FILES], tail),
  filter("wc", "count lines, words and bytes", [
    option("l", ["-l", "--lines"], "lines"), option("w", ["-w", "--words"], "words"), option("c", ["-c", "--bytes"], "bytes"), FILES,
  ], count),
  { name: "time", about: "tell how long a command takes", run: time },
];

/**
 * @param {string} name @param {string} about @param {Argument[]} args
 * @param {(io: Io, args: any, lines: AsyncIterable<string>) => Promise<number | void>} run @returns {Program}
 */
function filter(name, about, args, run) {
  return {
    name,
    about,
    async run(io) {
      // head -5 is short for head -n 5.
      const words = io.words.map((word) => (/^-\d+$/.test(word) && ["head", "tail"].includes(name) ? `-n${word.slice(1)}` : word));
      let found;
      try {
        found = parse({ prog: name, about, args }, words, io.columns);
      } catch (error) {
        if (error instanceof HelpAsked) return void await io.out(`${error.message}\n`);
        if (error instanceof UsageError) throw new Failure(error.message, 2);
        throw error;
      }
      // The files of tee are written.
      return run(io, found, linesOf(io, name, name === "tee" ? [] : found.file));
    },
  };
}

/** @param {Io} io @param {string} name @param {string[]} files */
async function* linesOf({ shell, input, signal }, name, files) {
  if (!files.length && !input) throw new Failure(`${name}: nothing to read: name a file, or put it behind a pipe`);
  for (const file of files) {
    const text = shell.files.get(file);
    if (text === undefined) throw new Failure(`${name}: ${file}: No such file or directory`, 2);
    yield* text.replace(/\n$/, "").split("\n");
  }
  if (!files.length) yield* /** @type {Pipe} */ (input).lines(signal);
}

/** @param {Io} io @param {any} args @param {AsyncIterable<string>} lines */
async function grep({ out, toScreen }, args, lines) {
  let pattern;
  try {
    const source = args.fixed ? args.pattern.replace(/[.*+?^${}()|[\]\\]/g, "\\$&") : args.pattern;
    pattern = new RegExp(source, args.ignore ? "i" : "");
  } catch {
    throw new Failure(`grep: invalid pattern: ${args.pattern}`, 2);
  }
  let [number, found, after] = [0, 0, 0];
  for await (const line of lines) {
    number++;
    const match = pattern.exec(line);
    const wanted = Boolean(match) !== args.invert;
    if (wanted) [found, after] = [found + 1, args.after + 1];
    if (after > 0 && !args.counted && !args.quiet) {
      await out(args.numbered ? `${number}${wanted ? ":" : "-"}` : "");
      if (match && wanted && match[0] && toScreen) {
        await out(line.slice(0, match.index));
        await out(match[0], "red");
        await out(`${line.slice(match.index + match[0].length)}\n`);
      } else {
        await out(`${line}\n`);
      }
    }
    after--;
    if ((args.quiet && found) || found >= args.most) break;
  }
  if (args.counted) await out(`${found}\n`);
  return found ? 0 : 1;
}

/** @param {Io} io @param {any} args @param {AsyncIterable<string>} lines */
async function head({ out }, { lines: most }, lines) {
  let number = 0;
  if (most <= 0) return;
  for await (const line of lines) {
    await out(`${line}\n`);
    if (++number >= most) break;
  }
}

/** @param {Io} io @param {any} args @param {AsyncIterable<string>} lines */
async function tail({ out }, { lines: wanted }, lines) {
  const most = Math.min(wanted, MOST);
  /** @type {string[]} */
  let last = [];
  for await (const line of lines) {
    last.push(line);
    if (last.length > 2 * most) last = last.slice(-most);
  }
  for (const line of most > 0 ? last.slice(-most) : []) await out(`${line}\n`);
}

/** @param {Io} io @param {any} args @param {AsyncIterable<string>} lines */
async function count({ out }, { l, w, c }, lines) {
  let [rows, words, bytes] = [0, 0, 0];
  for await (const line of lines) {
    rows++;
    words += line.split(/\s+/).filter(Boolean).length;
    bytes += new TextEncoder().encode(line).length + 1;
  }
  const all = !l && !w && !c;
  const shown = [[l, rows], [w, words], [c, bytes]].filter(([on]) => all || on).map(([, number]) => number);
  await out(`${shown.length === 1 ? shown[0] : shown.map((number) => String(number).padStart(7)).join(" ")}\n`);
}

/** @param {Io} io */
async function time(io) {
  const [name = "", ...words] = io.words;
  const program = io.shell.programs.get(name);
  if (!program) throw new Failure(`${name}: command not found`, 127);
  const start = performance.now();
  try {
    return await program.run({ ...io, words });
  } finally {
    const seconds = (performance.now() - start) / 1000;
    await io.err(`\nreal\t${Math.floor(seconds / 60)}m${(seconds % 60).toFixed(3)}s\n`);
  }
}
