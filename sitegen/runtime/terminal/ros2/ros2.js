// @ts-check
// The command `ros2`: finds the verb, parses its arguments and runs it.

import { argumentsOf, HelpAsked, parse, UsageError } from "../args/parse.js";
import { help, usage } from "../args/help.js";
import { Failure } from "../shell/shell.js";
import { ACTION } from "./action.js";
import { BAG } from "./bag.js";
import { COMPONENT } from "./component.js";
import { DAEMON } from "./daemon.js";
import { DOCTORS } from "./doctor.js";
import { INTERFACE } from "./interface.js";
import { LAUNCH } from "./launch.js";
import { LIFECYCLE } from "./lifecycle.js";
import { NODE } from "./node.js";
import { PARAM } from "./param.js";
import { PKG } from "./pkg.js";
import { RUN } from "./run.js";
import { SERVICE } from "./service.js";
import { TOPIC } from "./topic.js";
import { flag, isInterrupt, SIGINT } from "./verb.js";

/** @import { Argument, Spec } from "../args/parse.js" */
/** @import { Io, Program } from "../shell/shell.js" */
/** @import { Group, Verb } from "./verb.js" */

/** All commands of `ros2`, by name. @type {Group[]} */
export const GROUPS = [
  ACTION, BAG, COMPONENT, DAEMON, INTERFACE, LAUNCH, LIFECYCLE, NODE, PARAM, PKG, RUN, SERVICE, TOPIC, ...DOCTORS,
].sort(({ name: one }, { name: other }) => (one < other ? -1 : 1));

const BUFFERING = flag("buffering", ["--use-python-default-buffering"], "Do not force line buffering in stdout and instead use the python default buffering, which might be affected by PYTHONUNBUFFERED/-u and depends on whatever stdout is interactive or not");
/** @type {Spec} */
export const ROOT = chooser("ros2", "ros2 is an extensible command-line tool for ROS 2.", [BUFFERING], GROUPS);

/** @type {Program} */
export const ROS2 = {
  name: "ros2",
  about: "the command-line tool of ROS 2",
  async run(io) {
    try {
      await io.shell.interfaces.load();
      return await dispatch(io);
    } catch (error) {
      if (isInterrupt(error)) return SIGINT;
      if (error instanceof HelpAsked) {
        await io.out(`${error.message}\n`);
        return 0;
      }
      if (!(error instanceof UsageError)) throw error;
      await io.err(`${error.message}\n`);
      return 2;
    }
  },
};

/** @param {Io} io */
async function dispatch(io) {
  const { word: name, rest } = choose(ROOT, io.words, io.columns);
  if (name === undefined) throw new HelpAsked(helpOf(ROOT, io.columns));
  const group = pick(ROOT, GROUPS, name, io.columns);
  if (group.verb) return run(io, specOf(group), group.verb, rest, {});
  const spec = specOf(group);
  const { found, word, rest: words } = choose(spec, rest, io.columns);
  if (word === undefined) throw new HelpAsked(helpOf(spec, io.columns));
  const verb = pick(spec, group.verbs ?? [], word, io.columns);
  return run(io, specOf(group, verb), verb, words, found);
}

/** @param {Io} io @param {Spec} spec @param {Pick<Verb, "run">} verb @param {string[]} words @param {any} shared */
async function run(io, spec, verb, words, shared) {
  // As in argparse, unknown words are errors of the whole command.
  const unknown = (/** @type {string[]} */ extra) => failure(ROOT, io.columns, `unrecognized arguments: ${extra.join(" ")}`);
  const args = parse(spec, words, io.columns, unknown);
  const status = await verb.run(io, { ...shared, ...args });
  if (typeof status !== "string") return status ?? 0;
  throw new Failure(status);
}

/** The Spec of a command, or of one of its verbs. @param {Group} group @param {Verb} [verb] @returns {Spec} */
export function specOf(group, verb) {
  const prog = `ros2 ${group.name}`;
  if (verb) return { prog: `${prog} ${verb.name}`, about: verb.about, args: verb.args };
  if (group.verb) return { prog, about: group.about, args: group.verb.args };
  return chooser(prog, group.about, group.shared ?? [], group.verbs ?? []);
}

/**
 * The Spec of a command that only chooses another one.
 * @param {string} prog @param {string} about @param {Argument[]} args @param {{name: string, about: string}[]} choices
 * @returns {Spec}
 */
function chooser(prog, about, args, choices) {
  const width = Math.max(...choices.map(({ name }) => name.length));
  const lines = choices.map(({ name, about: what }) => `  ${name.padEnd(width)}  ${what}`);
  const more = `Call \`${prog} <command> -h\` for more detailed usage.`;
  return { prog, about, args, tail: `${more} ...`, after: ["Commands:", ...lines, "", `  ${more}`].join("\n") };
}

/**
 * Parse the options before a command, and return the command and what follows.
 * @param {Spec} spec @param {string[]} words @param {number} columns
 */
function choose(spec, words, columns) {
  let at = 0;
  while (at < words.length && words[at]?.startsWith("-")) at++;
  const before = words.slice(0, at);
  const found = parse(spec, before, columns, (extra) => failure(ROOT, columns, `unrecognized arguments: ${extra.join(" ")}`));
  return { found, word: words[at], rest: words.slice(at + 1) };
}

/**
 * @template {{name: string}} T
 * @param {Spec} spec @param {T[]} choices @param {string} name @param {number} columns @returns {T}
 */
function pick(spec, choices, name, columns) {
  const found = choices.find((one) => one.name === name);
  if (found) return found;
  const known = choices.map((one) => `'${one.name}'`).join(", ");
  const what = `Call \`${spec.prog} <command> -h\` for more detailed usage.`;
  throw new UsageError(failure(spec, columns, `argument ${what}: invalid choice: '${name}' (choose from ${known})`));
}

/** @param {Spec} spec @param {number} columns @param {string} text */
function failure(spec, columns, text) {
  return `${usage(spec, argumentsOf(spec), columns)}\n${spec.prog}: error: ${text}`;
}

/** @param {Spec} spec @param {number} columns */
function helpOf(spec, columns) {
  return help(spec, argumentsOf(spec), columns);
}
