// @ts-check
// Completion with Tab: commands, verbs, options, names of the graph, types, and fields of messages.

import { argumentsOf } from "../args/parse.js";
import { actionNames, executableOf, nodeNames, pluginsOf, programsOf, serviceNames, typesOf, unique } from "../args/words.js";
import { actionsOf } from "../../messages/actionClient.js";
import { nodesOf } from "../../messages/parameters/node.js";
import { filled } from "../ros2/filled.js";
import { yaml } from "../ros2/format.js";
import { managedNodes } from "../ros2/lifecycle.js";
import { GROUPS, ROOT, specOf } from "../ros2/ros2.js";
import { tokens } from "../shell/parse.js";

/** @import { Ros } from "../../protocol.js" */
/** @import { Argument, Spec } from "../args/parse.js" */
/** @import { Kind } from "../args/words.js" */
/** @import { Shell } from "../shell/shell.js" */

// A command, a pipe or a list begins anew after one of these.
const BEGIN = /^(?:&&|\|\||[;&|\n])$/;

/**
 * Return how the text before the cursor can go on: words that replace it from `start` on.
 * @param {string} text @param {Ros} ros @param {Shell} shell
 * @returns {Promise<{start: number, words: string[]}>}
 */
export async function complete(text, ros, shell) {
  let found;
  try {
    found = tokens(text, true);
  } catch {
    return { start: text.length, words: [] };
  }
  const last = found.at(-1);
  const open = last?.kind === "word" && last.end === text.length ? last : undefined;
  const start = open?.start ?? text.length;
  let begin = 0;
  for (const [index, token] of found.entries()) if (token.kind === "operator" && BEGIN.test(token.text)) begin = index + 1;
  const before = found.slice(begin).flatMap((token) => (token.kind === "word" && token !== open
    ? [token.word.filter((piece) => typeof piece === "string").join("")] : []));
  const typed = text.slice(start);
  const redirected = found.at(open ? -2 : -1);
  const words = redirected?.kind === "operator" && /[<>]/.test(redirected.text)
    ? [...shell.files.keys()] : await candidates(before, typed, ros, shell);
  return { start, words: unique(words.filter((word) => word.startsWith(typed))) };
}

/** @param {string[]} before @param {string} typed @param {Ros} ros @param {Shell} shell @returns {Promise<string[]>} */
async function candidates(before, typed, ros, shell) {
  const [name, group, verb] = before;
  if (name === undefined) return [...shell.programs.keys()];
  if (name === "time") return candidates(before.slice(1), typed, ros, shell);
  if (["bg", "fg", "kill"].includes(name)) return [...shell.jobs.keys()].map((id) => `%${id}`);
  if (name === "rm" || name === "save") return [...shell.files.keys(), ...(await shell.bags.recordings())];
  if (name !== "ros2") return [...shell.files.keys()];
  await shell.interfaces.load();
  if (group === undefined) return typed.startsWith("-") ? flagsOf(ROOT) : GROUPS.map((one) => one.name);
  const known = GROUPS.find((one) => one.name === group);
  if (!known) return [];
  if (known.verb) return argument(specOf(known), before.slice(2), typed, ros, shell);
  const found = known.verbs?.find((one) => one.name === verb);
  if (verb === undefined) return typed.startsWith("-") ? flagsOf(specOf(known)) : (known.verbs ?? []).map((one) => one.name);
  return found ? argument(specOf(known, found), before.slice(3), typed, ros, shell) : [];
}

/** @param {Spec} spec */
function flagsOf(spec) {
  return argumentsOf(spec).flatMap(({ flags = [] }) => flags);
}

/**
 * @param {Spec} spec @param {string[]} before the words of the verb @param {string} typed @param {Ros} ros
 * @param {Shell} shell @returns {Promise<string[]>}
 */
async function argument(spec, before, typed, ros, shell) {
  const args = argumentsOf(spec);
  /** @type {string[]} */
  const values = [];
  /** @type {Argument | undefined} */
  let pending;
  for (const word of before) {
    if (pending) pending = undefined;
    else if (word.startsWith("-")) pending = args.find(({ flags, count }) => flags?.includes(word) && count !== "flag");
    else values.push(word);
  }
  const positionals = args.filter(({ flags }) => !flags);
  const wanted = pending ?? positionals[Math.min(values.length, positionals.length - 1)];
  if (!pending && typed.startsWith("-")) return flagsOf(spec);
  if (!wanted || (!pending && values.length >= positionals.length && !["*", "..."].includes(wanted.count ?? ""))) return flagsOf(spec);
  if (wanted.choices) return [...wanted.choices];
  return wanted.complete ? words(wanted.complete, values, ros, shell) : [];
}

/** @param {Kind} kind @param {string[]} values before it @param {Ros} ros @param {Shell} shell @returns {Promise<string[]> | string[]} */
function words(kind, values, ros, shell) {
  const [first = "", second = ""] = values;
  switch (kind) {
    case "topic": return ros.graph.topics().map(({ name }) => name).filter((name) => !name.includes("/_"));
    case "service": return serviceNames(ros);
    case "action": return actionNames(ros);
    case "node": return unique([...nodeNames(ros), ...nodesOf(ros)]);
    case "lifecycleNode": return managedNodes(ros);
    case "message": return typesOf(ros, "msg");
    case "topicMessage": return typesOfName(ros.graph.topics(), first) ?? typesOf(ros, "msg");
    case "serviceType": return typesOfName(ros.graph.services(), first) ?? typesOf(ros, "srv");
    case "actionType": return typesOfName(actionsOf(ros), first) ?? typesOf(ros, "action");
    case "interface": return [...typesOf(ros, "msg"), ...typesOf(ros, "srv"), ...typesOf(ros, "action")];
    case "interfacePackage": return Object.keys(ros.types).map((name) => name.split("/")[0] ?? "");
    case "package": return programsOf(ros).map((node) => node.package);
    case "plugin": return programsOf(ros).flatMap(pluginsOf);
    case "executable": return programsOf(ros, first).map(executableOf);
    case "launchPackage": return ros.launch ? [ros.launch.package] : [];
    case "launchFile": return ros.launch ? [ros.launch.file] : [];
    case "launchArgument": return (ros.launch?.arguments ?? []).map(({ name }) => `${name}:=`);
    case "bag": return shell.bags.names();
    case "file": return [...shell.files.keys()];
    case "field": return second ? message(ros, second, "") : fields(ros, ros.graph.topics().find(({ name }) => name === first)?.types[0] ?? "");
    case "serviceRequest": return message(ros, second, "_Request");
    case "actionGoal": return message(ros, second, "_Goal");
    case "parameter": return parameters(ros, first);
  }
}

/** @param {{name: string, types: string[]}[]} all @param {string} name */
function typesOfName(all, name) {
  return all.find((one) => one.name === name)?.types;
}

/** A message of a type with its default values, as a word of the shell. @param {Ros} ros @param {string} type @param {string} part */
function message(ros, type, part) {
  const name = type + part;
  if (!ros.types[name]?.fields.length) return [];
  const text = yaml(filled({}, name, ros.types), name, ros.types, { limit: Infinity, flow: true }).trimEnd();
  return [`"${text.replace(/["\\$`]/g, "\\$&")}"`];
}

/** The paths of the fields of a type. @param {Ros} ros @param {string} type @param {string} [before] @returns {string[]} */
function fields(ros, type, before = "") {
  return (ros.types[type]?.fields ?? []).flatMap(({ name, type: of }) => [
    before + name, ...(before.split(".").length < 6 ? fields(ros, of, `${before}${name}.`) : []),
  ]);
}

/** @param {Ros} ros @param {string} node */
async function parameters(ros, node) {
  try {
    const { result } = await ros.call(`${node}/list_parameters`, "rcl_interfaces/srv/ListParameters", { prefixes: [], depth: 0n }, 1000);
    return result.names;
  } catch {
    return []; // no such node
  }
}
