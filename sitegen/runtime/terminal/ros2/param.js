// @ts-check
// ros2 param: the parameters of nodes, by their services.

import { toFile } from "../../messages/parameters/file.js";
import { fromFile } from "../../messages/parameters/fileReader.js";
import { list as readAll, nodesOf } from "../../messages/parameters/node.js";
import { guess, NOT_SET, plainOf } from "../../messages/parameters/value.js";
import { Failure } from "../shell/shell.js";
import { float, quoted } from "./python.js";
import { INT } from "../args/types.js";
import { absolute, DISCOVERY, flag, isHidden, option, until } from "./verb.js";

/** @import { Io } from "../shell/shell.js" */
/** @import { Group, Verb } from "./verb.js" */

const SRV = "rcl_interfaces/srv";
const TYPES = ["not set", "boolean", "integer", "double", "string", "byte array", "boolean array", "integer array", "double array", "string array"];
const LABELS = ["", "Boolean value is:", "Integer value is:", "Double value is:", "String value is:", "Byte values are:", "Boolean values are:", "Integer values are:", "Double values are:", "String values are:"];
const NODE = /** @type {const} */ ({ name: "node_name", help: "Name of the ROS node", complete: "node" });
const NAME = /** @type {const} */ ({ name: "parameter_name", help: "Name of the parameter", complete: "parameter" });
const HIDDEN = flag("hidden", ["--include-hidden-nodes"], "Consider hidden nodes as well");
const TIMEOUT = option("timeout", ["--timeout"], "Wait for N seconds until node becomes available (default 1 sec)", { metavar: "N", type: INT, initial: 1 });

/** Return the full name of a node, for which `--timeout` waits. @param {Io} io @param {any} args */
async function nodeOf(io, { node_name: given, hidden, timeout = 0 }) {
  const name = absolute(given);
  const known = () => io.ros.graph.nodes().includes(name) && (hidden || !isHidden(name));
  // As upstream: less than none is forever.
  const found = await until(io, known, timeout < 0 ? Infinity : timeout * 1000);
  if (!found) throw new Failure("Node not found");
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
    option("filter", ["--filter"], "Only parameters matching the regex expression will be showed. Supports `re` regex syntax.", { count: "1" }),
    HIDDEN,
    option("prefixes", ["--param-prefixes"], "Only list parameters with the provided prefixes", { count: "+", metavar: "PARAM_PREFIXES" }),
    flag("typed", ["--param-type"], "Print parameter types with parameter names"),
  ],
  async run(io, args) {
    const { ros, out } = io;
    const nodes = args.node_name ? [await nodeOf(io, args)] : nodesOf(ros).filter((name) => args.hidden || !isHidden(name)).sort();
    const pattern = args.filter && patternOf(args.filter[0]);
    for (const node of nodes) {
      const { result } = await ask(io, node, "list_parameters", { prefixes: args.prefixes, depth: 0n });
      const names = [...result.names].sort().filter((name) => !pattern || pattern.test(name));
      if (!args.node_name && names.length) await out(`${node}:\n`);
      const types = args.typed ? (await ask(io, node, "describe_parameters", { names })).descriptors : [];
      for (const [index, name] of names.entries()) {
        await out(args.typed ? `  ${name} (type: ${TYPES[types[index]?.type ?? 0]})\n` : `  ${name}\n`);
      }
    }
  },
};

/** A pattern that matches from the start, as Python's re.match(). @param {string} text */
function patternOf(text) {
  try {
    return new RegExp(`^(?:${text})`);
  } catch {
    throw new Failure(`--filter: '${text}' is not a regular expression`);
  }
}

/** @type {Verb} */
const get = {
  name: "get",
  about: "Get parameter",
  args: [...DISCOVERY, NODE, HIDDEN, NAME, flag("hide_type", ["--hide-type"], "Hide the type information"), TIMEOUT],
  async run(io, args) {
    const node = await nodeOf(io, args);
    const { values: [value] } = await ask(io, node, "get_parameters", { names: [args.parameter_name] });
    // The node does not know it.
    if (!value) return "Parameter not set";
    const bare = args.hide_type;
    if (value.type === NOT_SET) await io.out(bare ? "None\n" : "Parameter not set.\n");
    else await io.out(bare ? `${printed(value)}\n` : `${LABELS[value.type]} ${printed(value)}\n`);
    return 0;
  },
};

/** @type {Verb} */
const set = {
  name: "set",
  about: "Set parameter",
  args: [...DISCOVERY, NODE, HIDDEN, NAME, { name: "value", help: "Value of the parameter" }, TIMEOUT],
  async run(io, args) {
    const { parameter_name: name, value } = args;
    const node = await nodeOf(io, args);
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
  args: [...DISCOVERY, NODE, HIDDEN, NAME, TIMEOUT],
  async run(io, args) {
    const node = await nodeOf(io, args);
    const name = args.parameter_name;
    const { results: [result] } = await ask(io, node, "set_parameters", { parameters: [{ name, value: { type: NOT_SET } }] });
    await tell(io, result, "Deleted parameter successfully", "Deleting parameter failed");
  },
};

/** @type {Verb} */
const describe = {
  name: "describe",
  about: "Show descriptive information about declared parameters",
  args: [...DISCOVERY, NODE, HIDDEN, { name: "parameter_names", count: "+", help: "Names of the parameters", complete: "parameter" }, TIMEOUT],
  async run(io, args) {
    const node = await nodeOf(io, args);
    const { descriptors } = await ask(io, node, "describe_parameters", { names: args.parameter_names });
    for (const one of descriptors) {
      const lines = [`Parameter name: ${one.name}`, `  Type: ${TYPES[one.type]}`];
      if (one.description) lines.push(`  Description: ${one.description}`);
      lines.push("  Constraints:");
      if (one.read_only) lines.push("    Read only: true");
      for (const { from_value: low, to_value: high, step } of [...one.floating_point_range, ...one.integer_range].slice(0, 1)) {
        const text = (/** @type {any} */ value) => (typeof value === "bigint" ? String(value) : float(value));
        lines.push(`    Min value: ${text(low)}`, `    Max value: ${text(high)}`);
        if (Number(step)) lines.push(`    Step: ${text(step)}`);
      }
      if (one.additional_constraints) lines.push(`    Additional constraints: ${one.additional_constraints}`);
      await io.out(`${lines.join("\n")}\n`);
    }
  },
};

/** @type {Verb} */
const dump = {
  name: "dump",
  about: "Show all of the parameters of a node in a YAML file format",
  args: [...DISCOVERY, NODE, HIDDEN, TIMEOUT],
  async run(io, args) {
    const node = await nodeOf(io, args);
    await io.out(`${toFile(node, await readAll(io.ros, node))}\n`);
  },
};

/** @type {Verb} */
const load = {
  name: "load",
  about: "Load parameter file for a node",
  args: [
    ...DISCOVERY, NODE, HIDDEN,
    { name: "parameter_file", help: "Parameter file", complete: "file" },
    flag("no_wildcard", ["--no-use-wildcard"], "Do not load parameters in the '/**' namespace into the node"), TIMEOUT,
  ],
  async run(io, args) {
    const node = await nodeOf(io, args);
    const found = [...fromFile(io.shell.readFile(args.parameter_file), node, !args.no_wildcard)];
    const parameters = found.map(([name, text]) => ({ name, value: guess(text) }));
    const { results } = await ask(io, node, "set_parameters", { parameters });
    for (const [index, { name }] of parameters.entries()) {
      await tell(io, results[index], `Set parameter ${name} successful`, `Set parameter ${name} failed`);
    }
  },
};

/** @type {Group} */
export const PARAM = { name: "param", about: "Various param related sub-commands", verbs: [remove, describe, dump, get, list, load, set] };
