// @ts-check
// ros2 bag: its verbs, and those that a page does not have.

import { Failure } from "../shell/shell.js";
import { info } from "./bag/info.js";
import { play } from "./bag/play.js";
import { record } from "./bag/record.js";
import { option } from "./verb.js";

/** @import { Argument } from "../args/parse.js" */
/** @import { Group, Verb } from "./verb.js" */

const PATH = { name: "bag_path", help: "Bag to open", complete: /** @type {const} */ ("bag") };

const SAVED = "save the bag, and run it on your computer";

/** @param {string} name @param {string} about @param {string} instead @param {Argument[]} args @returns {Verb} */
function absent(name, about, instead, args) {
  return {
    name, about, args,
    async run() {
      throw new Failure(`ros2 bag ${name} is not available in a page: ${instead}`);
    },
  };
}

/** @type {Group} */
export const BAG = {
  name: "bag",
  about: "Various rosbag related sub-commands",
  verbs: [
    absent("convert", "Given an input bag, write out a new bag with different settings", SAVED, [
      option("input", ["-i", "--input"], "URI (and optional storage ID) of an input bag", { count: "+" }),
      option("output_options", ["-o", "--output-options"], "YAML file with the settings of the output"),
    ]),
    info,
    absent("list", "Print information about available plugins", "its only storage is mcap", [
      { name: "plugin_type", help: "Lists available plugins of this type", choices: ["storage", "converter", "compressor", "decompressor"] },
    ]),
    play,
    record,
    absent("reindex", "Reconstruct metadata file for a bag", SAVED, [PATH]),
  ],
};
