// @ts-check
// Names of the graph and of types, as authors and clients write them.

import { say } from "../ui/words.js";

const NAME = /^(\/[A-Za-z_]\w*)+$/;
const LONGEST = 255;
const TYPE = /^([a-z]\w*)\/(?:(msg|srv|action)\/)?([A-Za-z]\w*)$/;

/**
 * Return the full name of a topic, service, action or node.
 * @param {string} name relative ones are in the namespace of `node`, and "~" stands for its name @param {string} [node]
 */
export function fullName(name, node = "") {
  const namespace = node.slice(0, Math.max(0, node.lastIndexOf("/")));
  const full = name.startsWith("~") ? `${node}${name.slice(1)}` : name.startsWith("/") ? name : `${namespace}/${name}`;
  if (!NAME.test(full) || full.length > LONGEST) {
    throw new Error(say("'{}' is not a valid name in ROS", String(name).slice(0, 200)));
  }
  return full;
}

/**
 * Return the full name of a type: "std_msgs/String", as ROS 1 has it, is "std_msgs/msg/String".
 * @param {string} type @param {"msg" | "srv" | "action"} kind
 */
export function fullType(type, kind) {
  const [, group, given = kind, name] = TYPE.exec(type) ?? [];
  if (!group || given !== kind || type.length > LONGEST) {
    throw new Error(say("'{}' is not a valid type; write it like '{}'", String(type).slice(0, 200), EXAMPLES[kind]));
  }
  return `${group}/${kind}/${name}`;
}

const EXAMPLES = {
  msg: "std_msgs/msg/String", srv: "std_srvs/srv/SetBool", action: "example_interfaces/action/Fibonacci",
};
