// @ts-check
// ros2 param: the parameters of nodes, by their services.

import { toFile } from "../../messages/parameters/file.js";
import { fromFile } from "../../messages/parameters/fileReader.js";
import { list as readAll, nodesOf } from "../../messages/parameters/node.js";
import { guess, NOT_SET, plainOf } from "../../messages/parameters/value.js";
import { Failure } from "../shell/shell.js";
import { float, quoted } from "./python.js";
import { absolute, DISCOVERY, flag, isHidden, option } from "./verb.js";

/** @import { Ros } from "../../protocol.js" */
/** @import { Io } from "../shell/shell.js" */
/** @import { Group, Verb } from "./verb.js" */

const SRV = "rcl_interfaces/srv";
const TYPES = ["not set", "boolean", "integer", "double", "string", "byte array", "boolean array", "integer array", "double array", "string array"];
const LABELS = ["", "Boolean value is:", "Integer value is:", "Double value is:", "String value is:", "Byte values are:", "Boolean values are:", "Integer values are:", "Double values are:", "String values are:"];
const NODE = /** @type {const} */ ({ name: "node_name", help: "Name of the ROS node", complete: "node" });
const NAME = /** @type {const} */ ({ name: "parameter_name", help: "Name of the parameter", complete: "parameter" });
const HIDDEN = flag("hidden", ["--include-hidden-nodes"], "Consider hidden nodes as well");
const TIMEOUT = option("timeout", ["--timeout"], "Wait for N seconds until node becomes available (default 1 sec)", { metavar: "N" });

/** Return the full name of a node that runs. @param {Ros} ros @param {string} given */
function nodeOf(ros, given) {
  const name = absolute(given);
  if (!ros.graph.nodes().includes(name)) throw new Failure("Node not found");
  return name;
}

/** @param {Io} io @param {string} node @param {string} service @param {any} request */
async function ask({ ros, signal }, node, service, request) {
  const type = `${SRV}/${service.replace(/(?:^|_)(\w)/g, (_, letter) => letter.toUpperCase())}`;
  if (!ros.graph.services().some(({ name, servers }) => name === `${node}/${service}` && servers.length)) {
    throw new Failure(`Wait for service timed out waiting for parameter services for node ${node}`);
  }
  return ros.call(`${node}/${service}`, type, request, 5000, signal);
}

/** A value as Python prints it. @param {any} value a ParameterValue */
function printed(value) {
  const plain = plainOf(value);
  if (value.type === 5) return `[${Array.from(plain, (byte) => `b'\\x${byte.toString(16).padStart(2, "0")}'`).join(", ")}]`;
  if (value.type > 4) return `[${Array.from(plain, (item) => scalar(item, true)).join(", ")}]`;
  return scalar(plain, false);
}

/** @param {any} item @param {boolean} inList */
function scalar(item, inList) {
  if (typeof item === "boolean") return item ? "True" : "False";
  if (typeof item === "number") return float(item);
  return typeof item === "string" && inList ? quoted(item) : String(item);
}

/** @type {Verb} */
const list = {
  name: "list",
  about: "Output a list of available parameters",
  args: [
    ...DISCOVERY,
    { ...NODE, count: "?" },
    HIDDEN,
    option("prefixes", ["--param-prefixes"], "Only list parameters with the provided prefixes", { count: "*", initial: [] }),
    flag("typed", ["--param-type"], "Print parameter types with parameter names"),
    option("filter", ["--filter"], "Only list parameters matching the provided regex"),
    TIMEOUT,
  ],
  async run(io, args) {
    const { ros, out } = io;
    const nodes = args.node_name ? [nodeOf(ros, args.node_name)] : nodesOf(ros).filter((name) => args.hidden || !isHidden(name)).sort();
    const pattern = args.filter && new RegExp(args.filter);
    for (const node of nodes) {
      if (!args.node_name) await out(`${node}:\n`);
      const { result } = await ask(io, node, "list_parameters", { prefixes: args.prefixes, depth: 0n });
      const names = [...result.names].sort().filter((name) => !pattern || pattern.test(name));
      const types = args.typed ? (await ask(io, node, "describe_parameters", { names })).descriptors : [];
      for (const [index, name] of names.entries()) {
        await out(args.typed ? `  ${name} (type: ${TYPES[types[index]?.type ?? 0]})\n` : `  ${name}\n`);
      }
    }
  },
};

/** @type {Verb} */
const get = {
  name: "get",
  about: "Get parameter",
  args: [...DISCOVERY, NODE, NAME, HIDDEN, flag("hide_type", ["--hide-type"], "Hide the type information"), TIMEOUT],
  async run(io, { node_name: given, parameter_name: name, hide_type: bare }) {
    const node = nodeOf(io.ros, given);
    const { values: [value] } = await ask(io, node, "get_parameters", { names: [name] });
    if (!value || value.type === NOT_SET) return void await io.out("Parameter not set.\n");
    await io.out(bare ? `${printed(value)}\n` : `${LABELS[value.type]} ${printed(value)}\n`);
  },
};

/** @type {Verb} */
const set = {
  name: "set",
  about: "Set parameter",
  args: [...DISCOVERY, NODE, NAME, { name: "value", help: "Value of the parameter" }, HIDDEN, TIMEOUT],
  async run(io, { node_name: given, parameter_name: name, value }) {
    const node = nodeOf(io.ros, given);
    const { results: [result] } = await ask(io, node, "set_parameters", { parameters: [{ name, value: guess(value) }] });
    await tell(io, result, "Set parameter successful", "Setting parameter failed");
  },
};

/** @param {Io} io @param {{successful: boolean, reason: string} | undefined} result @param {string} good @param {string} bad */
async function tell({ out, err }, result, good, bad) {
  const reason = result?.reason ? `: ${result.reason}` : "";
  if (result?.successful) await out(`${good}${reason}\n`);
  else await err(`${bad}${reason}\n`);
}

/** @type {Verb} */
const remove = {
  name: "delete",
  about: "Delete parameter",
  args: [...DISCOVERY, NODE, NAME, HIDDEN, TIMEOUT],
  async run(io, { node_name: given, parameter_name: name }) {
    const node = nodeOf(io.ros, given);
    const { results: [result] } = await ask(io, node, "set_parameters", { parameters: [{ name, value: { type: NOT_SET } }] });
    await tell(io, result, "Deleted parameter successfully", "Deleting parameter failed");
  },
};

/** @type {Verb} */
const describe = {
  name: "describe",
  about: "Show descriptive information about declared parameters",
  args: [...DISCOVERY, NODE, { name: "parameter_names", count: "*", help: "Names of the parameters", complete: "parameter" }, HIDDEN, TIMEOUT],
  async run(io, { node_name: given, parameter_names: names }) {
    const node = nodeOf(io.ros, given);
    const { descriptors } = await ask(io, node, "describe_parameters", { names });
    for (const one of descriptors) {
      const lines = [`Parameter name: ${one.name}`, `  Type: ${TYPES[one.type]}`];
      if (one.description) lines.push(`  Description: ${one.description}`);
      lines.push("  Constraints:");
      if (one.read_only) lines.push("    Read only: true");
      for (const { from_value: low, to_value: high, step } of [...one.floating_point_range, ...one.integer_range]) {
        const text = (/** @type {any} */ value) => (typeof value === "bigint" ? String(value) : float(value));
        lines.push(`    Min value: ${text(low)}`, `    Max value: ${text(high)}`);
        if (Number(step)) lines.push(`    Step: ${text(step)}`);
      }
      if (one.additional_constraints) lines.push(`    ${one.additional_constraints}`);
      await io.out(`${lines.join("\n")}\n`);
    }
  },
};

/** @type {Verb} */
const dump = {
  name: "dump",
  about: "Show all of the parameters of a node in a YAML file format",
  args: [...DISCOVERY, { ...NODE, help: "Name of the ROS node" }, HIDDEN],
  async run(io, { node_name: given }) {
    const node = nodeOf(io.ros, given);
    await io.out(toFile(node, await readAll(io.ros, node)));
  },
};

/** @type {Verb} */
const load = {
  name: "load",
  about: "Load parameter file for a node",
  args: [
    ...DISCOVERY, NODE,
    { name: "parameter_file", help: "Parameter file", complete: "file" },
    HIDDEN, flag("no_wildcard", ["--no-use-wildcard"], "Do not load parameters in the '/**' namespace into the node"),
  ],
  async run(io, { node_name: given, parameter_file: file }) {
    const node = nodeOf(io.ros, given);
    const found = [...fromFile(io.shell.readFile(file), node)];
    const parameters = found.map(([name, text]) => ({ name, value: guess(text) }));
    const { results } = await ask(io, node, "set_parameters", { parameters });
    for (const [index, { name }] of parameters.entries()) {
      await tell(io, results[index], `Set parameter ${name} successful`, `Set parameter ${name} failed`);
    }
  },
};

/** @type {Group} */
export const PARAM = { name: "param", about: "Various param related sub-commands", verbs: [remove, describe, dump, get, list, load, set] };
