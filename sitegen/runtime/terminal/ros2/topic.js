// @ts-check
// ros2 topic: its verbs, and what they know of a topic.

import { bw } from "./topic/bw.js";
import { delay } from "./topic/delay.js";
import { echo } from "./topic/echo.js";
import { hz } from "./topic/hz.js";
import { find, info, list, type } from "./topic/list.js";
import { pub } from "./topic/pub.js";
import { flag } from "./verb.js";

/** @import { Group } from "./verb.js" */

/** @type {Group} */
export const TOPIC = {
  name: "topic",
  about: "Various topic related sub-commands",
  shared: [flag("hidden", ["--include-hidden-topics"], "Consider hidden topics as well")],
  verbs: [bw, delay, echo, find, hz, info, list, pub, type],
};
