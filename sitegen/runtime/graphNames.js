// @ts-check
// Names in the graph: which are hidden, and which are the infrastructure of every node.

/** The node of the page itself. */
export const PAGE_NODE = "/_page";
export const ROSOUT = "/rosout";

const TOPICS = new Set([ROSOUT, "/parameter_events"]);
const SERVICES = new RegExp(
  "^(/.+)?/(?:describe_parameters|get_parameter_types|get_parameters|list_parameters|set_parameters" +
    "|set_parameters_atomically|get_type_description)$",
);

/** Whether a name is hidden as in ROS: a part of it begins with an underscore. @param {string} name */
export function isHidden(name) {
  return name.includes("/_");
}

/**
 * Return whether a topic or service is for the log or the parameters of a node, with the node's name if it has one.
 * @param {string} name @returns {{node: string} | null}
 */
export function infrastructureOf(name) {
  if (TOPICS.has(name)) return { node: "" };
  const found = SERVICES.exec(name);
  return found && { node: found[1] ?? "" };
}

/** Whether panels show a topic or service by default. @param {string} name */
export function isShown(name) {
  return !isHidden(name) && !infrastructureOf(name);
}
