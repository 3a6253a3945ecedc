// @ts-check
// The module "sitegen", which scripts and panels of an author import: the ROS graph of their page.

import { Node } from "./node.js";
import { pageRos } from "./page.js";

export { GoalError } from "./goal.js";

const page = pageRos();

/** The page's own node, which is hidden. */
export const ros = new Node(page, Object.assign(Object.create(page), { read() {}, leave() {} }), "");
