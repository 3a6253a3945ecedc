// @ts-check
// ros2 component: what runs in the containers of the page.

import { filled } from "./filled.js";
import { hex } from "../../messages/hex.js";
import { guess } from "../../messages/parameters/value.js";
import { INT } from "../args/types.js";
import { pluginsOf, programsOf, unique } from "../args/words.js";
import { Failure, Interrupt } from "../shell/shell.js";
import { attend } from "./run.js";
import { absolute, DISCOVERY, flag, isInterrupt, option, until } from "./verb.js";

/** @import { Ros } from "../../protocol.js" */
/** @import { Io } from "../shell/shell.js" */
/** @import { Group, Verb } from "./verb.js" */

const SRV = "composition_interfaces/srv";
const LIST = "/_container/list_nodes";
const NODE = /** @type {const} */ ({ name: "container_node_name", help: "Container node name", complete: "node" });

/** The full names of the containers. @param {Ros} ros */
function containers(ros) {
  return ros.graph.services().filter(({ name, servers }) => name.endsWith(LIST) && servers.length)
    .map(({ name }) => name.slice(0, -LIST.length)).sort();
}

/** @param {Ros} ros @param {string} given its full name */
function containerOf(ros, given) {
  if (!containers(ros).includes(given)) throw new Failure(`Unable to find container node '${given}'`);
  return given;
}

/** @param {Io} io @param {string} container @param {string} service @param {string} type @param {any} request */
function ask({ ros, signal }, container, service, type, request) {
  const whole = filled(request, `${SRV}/${type}_Request`, ros.types);
  return ros.call(`${container}/_container/${service}`, `${SRV}/${type}`, whole, Infinity, signal);
}

/** As Python's capitalize(). @param {string} text */
function capitalized(text) {
  return text.trim().replace(/^(.)([^]*)$/, (_, first, rest) => first.toUpperCase() + rest.toLowerCase());
}

/** @type {Verb} */
const list = {
  name: "list",
  about: "Output a list of running containers and components",
  args: [
    ...DISCOVERY,
    { ...NODE, count: "?", help: "Name of the container node to list components from" },
    flag("bare", ["--containers-only"], "List found containers nodes only"),
  ],
  async run(io, { container_node_name: given, bare }) {
    for (const name of given ? [containerOf(io.ros, given)] : containers(io.ros)) {
      if (!given) await io.out(`${name}\n`);
      if (bare) continue;
      const { unique_ids: ids, full_node_names: names } = await ask(io, name, "list_nodes", "ListNodes", {});
      for (const [index, id] of ids.entries()) await io.out(`${given ? "" : "  "}${id}  ${names[index]}\n`);
    }
  },
};

/** What a component is, and how its node starts. @type {import("../args/parse.js").Argument[]} */
const COMPONENT_OPTIONS = [
  { name: "package_name", help: "Name of the package where the component is to be found", complete: "package" },
  { name: "plugin_name", help: "Type name of the component to be loaded", complete: "plugin" },
  option("node_name", ["-n", "--node-name"], "Component node name"),
  option("node_namespace", ["--node-namespace"], "Component node namespace"),
  option("log_level", ["--log-level"], "Component node log level"),
  option("remaps", ["-r", "--remap-rule"], "Component node remapping rules, in the 'from:=to' form", { count: "append", metavar: "REMAP_RULES" }),
  option("parameters", ["-p", "--parameter"], "Component node parameters, in the 'name:=value' form", { count: "append", metavar: "PARAMETERS" }),
  option("extra", ["-e", "--extra-argument"], "Extra arguments for the container, in the 'name:=value' form", { count: "append", metavar: "EXTRA_ARGUMENTS" }),
];

/** Load a component, and return what the container says. @param {Io} io @param {string} container @param {any} args */
async function loadInto(io, container, args) {
  const pairs = (/** @type {string[]} */ words) => words.map((word) => {
    const at = word.indexOf(":=");
    return at < 0 ? { name: word, value: guess("") } : { name: word.slice(0, at), value: guess(word.slice(at + 2)) };
  });
  const response = await ask(io, container, "load_node", "LoadNode", {
    package_name: args.package_name, plugin_name: args.plugin_name, node_name: args.node_name ?? "",
    node_namespace: args.node_namespace ?? "", remap_rules: args.remaps, parameters: pairs(args.parameters),
    extra_arguments: pairs(args.extra), ...(args.log_level && { log_level: levelOf(args.log_level) }),
  });
  if (!response.success) throw new Failure(`Failed to load component: ${capitalized(response.error_message)}`);
  return response;
}

/** The number of a log level, of which rcl_interfaces/msg/Log has the names. @param {string} name */
function levelOf(name) {
  const level = { debug: 10, info: 20, warn: 30, error: 40, fatal: 50 }[name.toLowerCase()];
  if (level === undefined) throw new Failure(`'${name}' is not a log level`);
  return level;
}

/** @type {Verb} */
const load = {
  name: "load",
  about: "Load a component into a container node",
  args: [
    ...DISCOVERY,
    { ...NODE, help: "Container node name to load component into" },
    ...COMPONENT_OPTIONS,
    flag("quiet", ["-q", "--quiet"], "Only print component unique IDs and names"),
  ],
  async run(io, args) {
    const container = containerOf(io.ros, args.container_node_name);
    const { unique_id: id, full_node_name: name } = await loadInto(io, container, args);
    await io.out(args.quiet ? `${id}  ${name}\n` : `Loaded component ${id} into '${container}' container node as '${name}'\n`);
  },
};

/** @type {Verb} */
const unload = {
  name: "unload",
  about: "Unload a component from a container node",
  args: [
    ...DISCOVERY,
    { ...NODE, help: "Container node name to unload component from" },
    { name: "component_uid", count: "+", type: INT, help: "Unique ID of the component to be unloaded" },
    flag("quiet", ["-q", "--quiet"], "Only print component unique IDs"),
  ],
  async run(io, { container_node_name: given, component_uid: ids, quiet }) {
    const container = containerOf(io.ros, given);
    for (const id of ids) {
      if (!Number.isSafeInteger(id) || id < 0) return `'${id}' is not the unique ID of a component`;
      const { success, error_message: error } = await ask(io, container, "unload_node", "UnloadNode", { unique_id: BigInt(id) });
      if (!success) return `Failed to unload component ${id} from '${container}' container node\n    ${capitalized(error)}`;
      await io.out(quiet ? `${id}\n` : `Unloaded component ${id} from '${container}' container node\n`);
    }
    return 0;
  },
};

/** @type {Verb} */
const standalone = {
  name: "standalone",
  about: "Run a component into its own standalone container node",
  args: [
    ...DISCOVERY, ...COMPONENT_OPTIONS,
    option("container", ["-c", "--container-node-name"], "Name of the standalone container node to be run", { metavar: "CONTAINER_NODE_NAME" }),
  ],
  async run(io, args) {
    const { ros } = io;
    const all = programsOf(ros, "rclcpp_components");
    const program = all.find((one) => pluginsOf(one).includes(args.plugin_name)) ?? all[0];
    if (!program) throw new Failure("Package 'rclcpp_components' not found");
    const name = args.container ?? `standalone_container_${hex(crypto.getRandomValues(new Uint8Array(6)))}`;
    const node = ros.run(program.name, { arguments: ["--ros-args", "-r", `__node:=${name}`] });
    const ended = new AbortController();
    const signal = AbortSignal.any([io.signal, ended.signal]);
    const loads = until({ ...io, signal }, () => containers(ros).includes(absolute(name)))
      .then(() => loadInto({ ...io, signal }, absolute(name), args))
      .catch(async (error) => {
        if (isInterrupt(error)) return;
        await io.out(`${error.message}, interrupting container node\n`);
        node.interrupt();
      });
    try {
      return await attend(io, node, "");
    } finally {
      ended.abort(new Interrupt());
      await loads;
    }
  },
};

/** @type {Verb} */
const types = {
  name: "types",
  about: "Output a list of components registered in the ament index",
  args: [{ name: "package_name", count: "?", help: "Package name to look for registered components in", complete: "package" }],
  async run({ ros, out }, { package_name: name }) {
    const plugins = unique(programsOf(ros).flatMap(pluginsOf));
    // The first namespace of a class is that of its package.
    const owners = unique(plugins.map(packageOf));
    if (name !== undefined && !owners.includes(name) && !programsOf(ros, name).length) return `Unable to find package '${name}'`;
    for (const owner of name === undefined ? owners : [name]) {
      if (name === undefined) await out(`${owner}\n`);
      for (const plugin of plugins) if (packageOf(plugin) === owner) await out(`${name === undefined ? "  " : ""}${plugin}\n`);
    }
    return 0;
  },
};

/** @param {string} plugin */
function packageOf(plugin) {
  return plugin.split("::")[0] ?? "";
}

/** @type {Group} */
export const COMPONENT = {
  name: "component",
  about: "Various component related sub-commands",
  verbs: [list, load, standalone, types, unload],
};
