// @ts-check
// ros2 component: what runs in the containers of the page.

import { filled } from "./filled.js";
import { guess } from "../../messages/parameters/value.js";
import { Failure } from "../shell/shell.js";
import { absolute, DISCOVERY, flag, option } from "./verb.js";

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

/** @param {Ros} ros @param {string} given */
function containerOf(ros, given) {
  const name = absolute(given);
  if (!containers(ros).includes(name)) throw new Failure(`Unable to find container node '${given}'`);
  return name;
}

/** @param {Io} io @param {string} container @param {string} service @param {string} type @param {any} request */
function ask({ ros, signal }, container, service, type, request) {
  const whole = filled(request, `${SRV}/${type}_Request`, ros.types);
  return ros.call(`${container}/_container/${service}`, `${SRV}/${type}`, whole, Infinity, signal);
}

/** @type {Verb} */
const list = {
  name: "list",
  about: "Output a list of running containers and components",
  args: [
    ...DISCOVERY,
    { ...NODE, count: "?", help: "Container node name to list components from" },
    flag("bare", ["--containers-only"], "List found containers nodes only"),
  ],
  async run(io, { container_node_name: given, bare }) {
    for (const name of given ? [containerOf(io.ros, given)] : containers(io.ros)) {
      if (!given) await io.out(`${name}\n`);
      if (bare) continue;
      const { unique_ids: ids, full_node_names: names } = await ask(io, name, "list_nodes", "ListNodes", {});
      for (const [index, id] of ids.entries()) await io.out(`   ${id}  ${names[index]}\n`);
    }
  },
};

/** @type {Verb} */
const load = {
  name: "load",
  about: "Load a component into a container node",
  args: [
    ...DISCOVERY,
    { ...NODE, help: "Container node name to load component into" },
    { name: "package_name", help: "Package name where the component can be found", complete: "package" },
    { name: "plugin_name", help: "Type name of the component to be loaded" },
    option("node_name", ["-n", "--node-name"], "Component node name"),
    option("node_namespace", ["--node-namespace"], "Component node namespace"),
    option("remaps", ["-r", "--remap-rule"], "Component node remapping rules, in the 'from:=to' form", { count: "*", initial: [] }),
    option("parameters", ["-p", "--parameter"], "Component node parameters, in the 'name:=value' form", { count: "*", initial: [] }),
    option("extra", ["-e", "--extra-argument"], "Extra arguments for the container, in the 'name:=value' form", { count: "*", initial: [] }),
  ],
  async run(io, args) {
    const container = containerOf(io.ros, args.container_node_name);
    const pairs = (/** @type {string[]} */ words) => words.map((word) => {
      const at = word.indexOf(":=");
      if (at < 0) throw new Failure(`'${word}' is not of the form 'name:=value'`);
      return { name: word.slice(0, at), value: guess(word.slice(at + 2)) };
    });
    const response = await ask(io, container, "load_node", "LoadNode", {
      package_name: args.package_name, plugin_name: args.plugin_name, node_name: args.node_name ?? "",
      node_namespace: args.node_namespace ?? "", remap_rules: args.remaps, parameters: pairs(args.parameters),
      extra_arguments: pairs(args.extra),
    });
    if (!response.success) return `Failed to load component: ${response.error_message.trim()}`;
    await io.out(`Loaded component ${response.unique_id} into '${container}' container node as '${response.full_node_name}'\n`);
    return 0;
  },
};

/** @type {Verb} */
const unload = {
  name: "unload",
  about: "Unload a component from a container node",
  args: [
    ...DISCOVERY,
    { ...NODE, help: "Container node name to unload component from" },
    { name: "component_uid", help: "Unique ID of the component to be unloaded" },
  ],
  async run(io, { container_node_name: given, component_uid: id }) {
    const container = containerOf(io.ros, given);
    if (!/^\d{1,18}$/.test(id)) return `'${id}' is not the unique ID of a component`;
    const { success, error_message: error } = await ask(io, container, "unload_node", "UnloadNode", { unique_id: BigInt(id) });
    if (!success) return `Failed to unload component ${id} from '${container}' container node\n    ${error.trim()}`;
    await io.out(`Unloaded component ${id} from '${container}' container node\n`);
    return 0;
  },
};

/** @type {Group} */
export const COMPONENT = { name: "component", about: "Various component related sub-commands", verbs: [list, load, unload] };
