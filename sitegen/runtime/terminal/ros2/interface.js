// @ts-check
// ros2 interface: the message, service and action types of the page.

import { quoted } from "../../bag/definition.js";
import { isInteger, parseFieldType } from "../../messages/fieldType.js";
import { typesOf, unique } from "../args/words.js";
import { Failure } from "../shell/shell.js";
import { filled } from "./filled.js";
import { float } from "./python.js";
import { toYaml } from "../../messages/yaml.js";
import { flag, fullType } from "./verb.js";

/** @import { Ros } from "../../protocol.js" */
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
  args: ONLY,
  async run({ ros, out }, args) {
    const kinds = KINDS.filter(([kind]) => wanted(args, kind));
    const names = kinds.flatMap(([kind]) => typesOf(ros, kind)).map((name) => name.split("/")[0] ?? "");
    for (const name of unique(names)) await out(`${name}\n`);
  },
};

/** @type {Verb} */
const packageVerb = {
  name: "package",
  about: "Output a list of available interface types within one package",
  args: [{ name: "package_name", help: "Name of the ROS package (e.g. 'example_interfaces')", complete: "interfacePackage" }],
  async run({ ros, out }, { package_name: name }) {
    const found = KINDS.flatMap(([kind]) => typesOf(ros, kind)).filter((one) => one.startsWith(`${name}/`));
    if (!found.length) return `Unknown package '${name}'`;
    for (const one of found.sort()) await out(`${one}\n`);
    return 0;
  },
};

/** @type {Verb} */
const show = {
  name: "show",
  about: "Output the interface definition",
  args: [
    { name: "type", help: "Show an interface definition (e.g. \"example_interfaces/msg/String\"). Passing \"-\" reads the argument from stdin (e.g. \"ros2 topic type /chatter | ros2 interface show -\").", complete: "interface" },
    flag("all_comments", ["--all-comments"], "Show all comments, including for built-in interfaces"),
    flag("no_comments", ["--no-comments"], "Show no comments or whitespace"),
  ],
  async run({ ros, out, input, signal }, { type: given }) {
    let name = given;
    if (given === "-") {
      for await (const line of input?.lines(signal) ?? []) {
        name = line.trim();
        break;
      }
    }
    const parts = partsOf(ros, name);
    const texts = parts.map((part) => definition(ros, part, ""));
    await out(`${texts.map((lines) => lines.map((line) => `${line}\n`).join("")).join("---\n")}`);
  },
};

/** @type {Verb} */
const proto = {
  name: "proto",
  about: "Output an interface prototype",
  args: [
    { name: "type", help: "Show an interface definition (e.g. \"example_interfaces/msg/String\")", complete: "interface" },
    flag("no_quotes", ["--no-quotes"], "if true output has no outer quotes."),
  ],
  async run({ ros, out }, { type: given, no_quotes: plain }) {
    const [part = ""] = partsOf(ros, given);
    const text = toYaml(filled({}, part, ros.types), part, ros.types, Infinity);
    await out(plain ? `${text}\n` : `"${text}\n"\n`);
  },
};

/** The parts of an interface: a message has one, a service two, an action three. @param {Ros} ros @param {string} name */
function partsOf(ros, name) {
  const type = name.split("/").length === 2 ? KINDS.map(([kind]) => fullType(name, kind)).find((one) => known(ros, one)) ?? name : name;
  if (!/^\w+\/\w+(\/\w+)?$/.test(name)) throw new Failure(`Invalid name '${name}'. Expected three parts separated by '/'`);
  if (!known(ros, type)) throw new Failure(`Unknown interface '${name}': no node of this page uses it`);
  // Services and actions may be known as a whole, too, which no file writes.
  if (ros.types[`${type}_Goal`]) return [`${type}_Goal`, `${type}_Result`, `${type}_Feedback`];
  return ros.types[`${type}_Request`] ? [`${type}_Request`, `${type}_Response`] : [type];
}

/** @param {Ros} ros @param {string} type */
function known(ros, type) {
  return [type, `${type}_Request`, `${type}_Goal`].some((name) => ros.types[name]);
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
