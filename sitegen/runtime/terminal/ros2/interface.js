// @ts-check
// ros2 interface: the message, service and action types of the page.

import { quoted } from "../../bag/definition.js";
import { isInteger, parseFieldType } from "../../messages/fieldType.js";
import { usage } from "../args/help.js";
import { argumentsOf, UsageError } from "../args/parse.js";
import { typesOf, unique } from "../args/words.js";
import { Failure } from "../shell/shell.js";
import { filled } from "./filled.js";
import { float } from "./python.js";
import { toYaml } from "../../messages/yaml.js";
import { flag, isType } from "./verb.js";

/** @import { Ros } from "../../protocol.js" */
/** @import { Io } from "../shell/shell.js" */
/** @import { Group, Verb } from "./verb.js" */

const KINDS = /** @type {const} */ ([["msg", "Messages"], ["srv", "Services"], ["action", "Actions"]]);
const ONLY = [
  flag("msg", ["-m", "--only-msgs"], "Print out only the message types"),
  flag("srv", ["-s", "--only-srvs"], "Print out only the service types"),
  flag("action", ["-a", "--only-actions"], "Print out only the action types"),
];

/** @param {any} args @param {"msg" | "srv" | "action"} kind */
function wanted(args, kind) {
  return args[kind] || (!args.msg && !args.srv && !args.action);
}

/** @type {Verb} */
const list = {
  name: "list",
  about: "List all interface types available",
  args: ONLY,
  async run({ ros, out }, args) {
    for (const [kind, title] of KINDS) {
      if (!wanted(args, kind)) continue;
      await out(`${title}:\n`);
      for (const name of typesOf(ros, kind)) await out(`    ${name}\n`);
    }
  },
};

/** @type {Verb} */
const packages = {
  name: "packages",
  about: "Output a list of packages that provide interfaces",
  args: [
    flag("msg", ["-m", "--only-msgs"], "Only list packages that generate messages"),
    flag("srv", ["-s", "--only-srvs"], "Only list packages that generate services"),
    flag("action", ["-a", "--only-actions"], "Only list packages that generate actions"),
  ],
  async run({ ros, out }, args) {
    // Of several options, the first counts.
    const only = KINDS.find(([kind]) => args[kind]);
    const kinds = only ? [only] : KINDS;
    const names = kinds.flatMap(([kind]) => typesOf(ros, kind)).map((name) => name.split("/")[0] ?? "");
    for (const name of unique(names)) await out(`${name}\n`);
  },
};

/** @type {Verb} */
const packageVerb = {
  name: "package",
  about: "Output a list of available interface types within one package",
  args: [...ONLY, { name: "package_name", help: "Name of the ROS package (e.g. 'example_interfaces')", complete: "interfacePackage" }],
  async run({ ros, out }, args) {
    const own = (/** @type {(typeof KINDS)[number]} */ [kind]) => typesOf(ros, kind).filter((one) => one.startsWith(`${args.package_name}/`));
    if (!KINDS.some((kind) => own(kind).length)) return `Unknown package '${args.package_name}'`;
    for (const one of KINDS.filter(([kind]) => wanted(args, kind)).flatMap(own)) await out(`${one}\n`);
    return 0;
  },
};

/** @type {Verb} */
const show = {
  name: "show",
  about: "Output the interface definition",
  args: [
    flag("all_comments", ["--all-comments"], "Show all comments, including for nested interface definitions", { group: "comments" }),
    flag("no_comments", ["--no-comments"], "Show no comments or whitespace", { group: "comments" }),
    { name: "type", help: "Show an interface definition (e.g. 'example_interfaces/msg/String'). Passing '-' reads the argument from stdin (e.g. 'ros2 topic type /chatter | ros2 interface show -').", complete: "interface" },
  ],
  async run(io, { type: given, all_comments: all, no_comments: none }) {
    const { ros, out, input, signal, columns } = io;
    let name = given;
    if (given === "-" && !input) misused("expected stdin pipe", columns);
    if (given === "-") {
      name = "";
      for await (const line of input?.lines(signal) ?? []) {
        name = line.trim();
        break;
      }
    }
    if (!name) misused("the passed value is empty", columns);
    const parts = partsOf(ros, name);
    const lines = await written(io, name, { comments: !none, inner: all }, "");
    if (lines) {
      await out(lines.map((line) => `${line}\n`).join(""));
      return;
    }
    // There is no file, as of interfaces that only nodes of the page know.
    const texts = parts.map((part) => definition(ros, part, ""));
    await out(texts.map((each) => each.map((line) => `${line}\n`).join("")).join("---\n"));
  },
};

const FIELD = /^([A-Za-z]\w*(?:\/\w+)?)(?:<=\d+)?(?:\[[^\]]*\])?\s+\w+(?!\s*=)(?:\s|$)/;
const PLAIN = /^(?:bool|byte|char|float(?:32|64)|u?int(?:8|16|32|64)|w?string)$/;

/**
 * Return the lines of the file of an interface, with those of its fields; undefined if there is none.
 * @param {Io} io @param {string} name @param {{comments: boolean, inner: boolean}} shown whether comments are, and those
 *   of the types of fields @param {string} indent @returns {Promise<string[] | undefined>}
 */
async function written(io, name, shown, indent) {
  const text = await io.shell.interfaces.text(name);
  if (text === undefined) return undefined;
  const [owner] = name.split("/");
  /** @type {string[]} */
  const found = [];
  for (const line of text.replace(/\n$/, "").split("\n")) {
    const whole = line.trimEnd();
    const bare = whole.replace(/^([^"'#]*(?:"[^"]*"|'[^']*')?[^"'#]*)#.*$/, "$1").trim();
    if (shown.comments) found.push(whole && indent + whole);
    else if (bare) found.push(indent + bare);
    const [, type = ""] = FIELD.exec(bare) ?? [];
    if (!type || PLAIN.test(type)) continue;
    const [first = "", second] = type.split("/");
    const inner = second ? `${first}/msg/${second}` : `${owner}/msg/${first}`;
    found.push(...(await written(io, inner, { ...shown, comments: shown.inner }, `${indent}\t`)
      ?? definition(io.ros, inner, `${indent}\t`)));
  }
  return found;
}

/** @param {string} what @param {number} columns @returns {never} */
function misused(what, columns) {
  const spec = { prog: "ros2 interface show", about: show.about, args: show.args };
  throw new UsageError(`${usage(spec, argumentsOf(spec), columns)}\n${spec.prog}: error: ${what}`);
}

/** @type {Verb} */
const proto = {
  name: "proto",
  about: "Output an interface prototype",
  args: [
    { name: "type", help: "Show an interface definition (e.g. 'example_interfaces/msg/String')", complete: "interface" },
    flag("no_quotes", ["--no-quotes"], "if true output has no outer quotes."),
  ],
  async run({ ros, out }, { type: given, no_quotes: plain }) {
    const [part = ""] = partsOf(ros, given);
    const text = toYaml(filled({}, part, ros.types), part, ros.types, Infinity);
    await out(plain ? `${text}\n\n` : `"${text}\n"\n`);
  },
};

/** The parts of an interface: a message has one, a service two, an action three. @param {Ros} ros @param {string} name */
function partsOf(ros, name) {
  const [owner, ...inner] = name.split("/");
  if (inner.length !== 2) throw new Failure(`Invalid name '${name}'. Expected three parts separated by '/'`);
  if (!owner || inner.includes("")) throw new Failure(`Invalid name '${name}'. Must not contain empty parts`);
  if (!Object.keys(ros.types).some((one) => one.startsWith(`${owner}/`))) throw new Failure(`Unknown package '${owner}'`);
  if (!known(ros, name)) throw new Failure(`Could not find the interface '${name}.idl'`);
  // Services and actions may be known as a whole, too, which no file writes.
  if (isType(ros, `${name}_Goal`)) return [`${name}_Goal`, `${name}_Result`, `${name}_Feedback`];
  return isType(ros, `${name}_Request`) ? [`${name}_Request`, `${name}_Response`] : [name];
}

/** @param {Ros} ros @param {string} type */
function known(ros, type) {
  return [type, `${type}_Request`, `${type}_Goal`].some((name) => isType(ros, name));
}

/** @param {Ros} ros @param {string} name @param {string} indent @returns {string[]} */
function definition(ros, name, indent) {
  const type = ros.types[name];
  if (!type) return [];
  const [home] = name.split("/");
  const constants = type.constants.map((one) => `${indent}${one.type} ${one.name}=${constant(one.value, one.type)}`);
  return [...constants, ...type.fields.flatMap((field) => {
    const { base } = parseFieldType(field.type);
    const [owner, , short] = base.split("/");
    // As in the files: types of the same package have no prefix.
    const written = short ? field.type.replace(base, owner === home ? short : `${owner}/${short}`) : field.type;
    const value = field.default === undefined ? "" : ` ${constant(field.default, field.type)}`;
    return [`${indent}${written} ${field.name}${value}`, ...(short ? definition(ros, base, `${indent}\t`) : [])];
  })];
}

/** @param {any} value @param {string} type @returns {string} */
function constant(value, type) {
  if (Array.isArray(value)) return `[${value.map((one) => constant(one, type.replace(/\[.*$/, ""))).join(", ")}]`;
  if (typeof value === "string" && !isInteger(type)) return quoted(value);
  return /^float/.test(type) ? float(value) : String(value);
}

/** @type {Group} */
export const INTERFACE = { name: "interface", about: "Show information about ROS interfaces", verbs: [list, packageVerb, packages, proto, show] };
