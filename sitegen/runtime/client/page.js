// @ts-check
// The ROS API of the page, for modules that are bundles of their own.

import { say } from "../ui/words.js";

/** @import { Ros } from "../protocol.js" */

/** @returns {Ros} */
export function pageRos() {
  const ros = /** @type {any} */ (globalThis)[Symbol.for("sitegen.ros")];
  if (!ros?.subscribe) {
    throw new Error(say("this page has no ROS graph; import 'sitegen' in a script or a panel of a page"));
  }
  return ros;
}
