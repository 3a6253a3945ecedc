// @ts-check
// The parameters of one node, asked for and set by its services.

import { NOT_SET } from "./value.js";

/** @import { Ros } from "../../protocol.js" */
/** @typedef {{name: string, value: any, descriptor: any}} Parameter with its ParameterValue and ParameterDescriptor */

const SRV = "rcl_interfaces/srv";
// As deep as names go.
const ALL = 0n;

/** Return the parameters of a node, by name. @param {Ros} ros @param {string} node @returns {Promise<Parameter[]>} */
export async function list(ros, node) {
  const { result: { names } } = await ros.call(
    `${node}/list_parameters`, `${SRV}/ListParameters`, { prefixes: [], depth: ALL });
  const [{ values }, { descriptors }] = await Promise.all([
    ros.call(`${node}/get_parameters`, `${SRV}/GetParameters`, { names }),
    ros.call(`${node}/describe_parameters`, `${SRV}/DescribeParameters`, { names }),
  ]);
  const found = names.map((/** @type {string} */ name, /** @type {number} */ index) => ({
    name, value: values[index] ?? { type: NOT_SET }, descriptor: descriptors[index] ?? {},
  }));
  return found.sort((/** @type {Parameter} */ one, /** @type {Parameter} */ two) => (one.name < two.name ? -1 : 1));
}

/**
 * Set parameters together, and return the reason if the node refuses; else "".
 * @param {Ros} ros @param {string} node @param {{name: string, value: any}[]} parameters @returns {Promise<string>}
 */
export async function set(ros, node, parameters) {
  const { result: { successful, reason } } = await ros.call(
    `${node}/set_parameters_atomically`, `${SRV}/SetParametersAtomically`, { parameters });
  return successful ? "" : reason || "refused";
}

/** The nodes that have parameters. @param {Ros} ros */
export function nodesOf(ros) {
  const end = "/list_parameters";
  return ros.graph.services()
    .filter(({ name, types, servers }) => name.endsWith(end) && types.includes(`${SRV}/ListParameters`) && servers.length)
    .map(({ name }) => name.slice(0, -end.length));
}
