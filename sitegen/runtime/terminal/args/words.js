// @ts-check
// What the terminal completes: the names of the graph and the types of the page.

/** @import { NodeHandle, Ros } from "../../protocol.js" */

/**
 * @typedef {"topic" | "service" | "action" | "node" | "message" | "serviceType" | "actionType" | "interface" |
 *   "interfacePackage" | "bag" | "parameter" | "package" | "executable" | "lifecycleNode" | "plugin" | "file" | "field" |
 *   "launchPackage" | "launchFile" | "launchArgument" | "topicMessage" | "serviceRequest" | "actionGoal"} Kind
 */

const ACTION = "/_action/";

/** The types of the page of one kind. @param {Ros} ros @param {"msg" | "srv" | "action"} kind */
export function typesOf(ros, kind) {
  const parts = kind === "msg" ? /^()/ : kind === "srv" ? /_Request$/ : /_SendGoal_Request$/;
  const own = Object.keys(ros.types).filter((name) => name.split("/")[1] === kind);
  if (kind === "msg") return own.sort();
  return [...new Set(own.filter((name) => parts.test(name)).map((name) => name.replace(parts, "")))].sort();
}

/** The names of the page's nodes. @param {Ros} ros */
export function nodeNames(ros) {
  return [...new Set(ros.graph.nodes())].filter((name) => !name.split("/").at(-1)?.startsWith("_"));
}

/** The services that are not part of an action. @param {Ros} ros */
export function serviceNames(ros) {
  return ros.graph.services().filter(({ servers }) => servers.length).map(({ name }) => name)
    .filter((name) => !name.includes(ACTION));
}

/** The names of actions that have a server. @param {Ros} ros */
export function actionNames(ros) {
  const end = `${ACTION}send_goal`;
  return ros.graph.services().map(({ name }) => name).filter((name) => name.endsWith(end)).map((name) => name.slice(0, -end.length));
}

/** The programs of a package, or of all. @param {Ros} ros @param {string} [packageName] */
export function programsOf(ros, packageName) {
  return [...ros.nodes.values()].filter((node) => packageName === undefined || node.package === packageName);
}

/**
 * The name of a program in its package. That of a container names the components that it is linked with, too.
 * @param {NodeHandle} node
 */
export function executableOf({ executable }) {
  return executable.replace(/-[0-9a-f]{8}$/, "");
}

/** The classes of the components that a container is linked with. @param {NodeHandle} node @returns {string[]} */
export function pluginsOf({ arguments: words }) {
  return words.flatMap((word, index) => (words[index - 1] === "--component" ? [word] : []));
}

/** Names without repetitions, sorted. @param {Iterable<string>} names */
export function unique(names) {
  return [...new Set(names)].sort();
}
