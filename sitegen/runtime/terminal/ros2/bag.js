// @ts-check
// ros2 bag: its verbs, and those that a page does not have.

import { info } from "./bag/info.js";
import { play } from "./bag/play.js";
import { record } from "./bag/record.js";
import { absent, option } from "./verb.js";

/** @import { Group } from "./verb.js" */

const PATH = { name: "bag_path", help: "Bag to open", complete: /** @type {const} */ ("bag") };

const SAVED = "save the bag, and run it on your computer";

/** @type {Group} */
export const BAG = {
  name: "bag",
  about: "Various rosbag related sub-commands",
  verbs: [
    absent("bag", "convert", "Given an input bag, write out a new bag with different settings", SAVED, [
      option("input", ["-i", "--input"], "URI (and optional storage ID) of an input bag", { count: "+" }),
      option("output_options", ["-o", "--output-options"], "YAML file with the settings of the output"),
    ]),
    info,
    absent("bag", "list", "Print information about available plugins", "its only storage is mcap", [
      { name: "plugin_type", help: "Lists available plugins of this type", choices: ["storage", "converter", "compressor", "decompressor"] },
    ]),
    play,
    record,
    absent("bag", "reindex", "Reconstruct metadata file for a bag", SAVED, [PATH]),
  ],
};
