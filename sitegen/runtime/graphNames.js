// @ts-check
// Which names of the graph are hidden, and which every node has for its log and its parameters.

/** The node of the page itself. */
export const PAGE_NODE = "/_page";
export const ROSOUT = "/rosout";

const TOPICS = new Set([ROSOUT, "/parameter_events"]);
const SERVICES = new RegExp(
  "^(/.+)?/(?:describe_parameters|get_parameter_types|get_parameters|list_parameters|set_parameters" +
    "|set_parameters_atomically|get_type_description)$",
);

/** Whether a part of a name begins with an underscore, as in ROS those of tools and of actions do. @param {string} name */
export function isHidden(name) {
  return name.includes("/_");
}

/**
 * Whether a topic or service is infrastructure that every node has, and the node's name if it tells.
 * @param {string} name @returns {{node: string} | null}
 */
export function infrastructureOf(name) {
  if (TOPICS.has(name)) return { node: "" };
  const found = SERVICES.exec(name);
  return found && { node: found[1] ?? "" };
}

/** Whether panels show a topic or service without being asked for hidden ones. @param {string} name */
export function isShown(name) {
  return !isHidden(name) && !infrastructureOf(name);
}
