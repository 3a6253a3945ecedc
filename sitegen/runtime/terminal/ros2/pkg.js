// @ts-check
// ros2 pkg: the packages whose programs a page has.

import { INT } from "../args/types.js";
import { executableOf, programsOf, unique } from "../args/words.js";
import { Failure } from "../shell/shell.js";
import { absent, flag, option } from "./verb.js";

/** @import { Ros } from "../../protocol.js" */
/** @import { Group, Verb } from "./verb.js" */

const NAME = /** @type {const} */ ({ name: "package_name", help: "The package name", complete: "package" });
const FOLDERS = "a page has no folders of packages";

/** The packages with programs. @param {Ros} ros */
function packagesOf(ros) {
  return unique(programsOf(ros).map((node) => node.package));
}

/** @type {Verb} */
const list = {
  name: "list",
  about: "Output a list of available packages",
  args: [],
  async run({ ros, out }) {
    for (const name of packagesOf(ros)) await out(`${name}\n`);
  },
};

/** @type {Verb} */
const executables = {
  name: "executables",
  about: "Output a list of package specific executables",
  args: [{ ...NAME, count: "?" }, flag("full", ["--full-path"], "Show full path of each executable")],
  async run({ ros, out }, { package_name: name, full }) {
    const found = programsOf(ros, name);
    if (name !== undefined && !found.length) throw new Failure(`Package '${name}' not found`);
    if (full) throw new Failure(`ros2 pkg executables --full-path: ${FOLDERS}`);
    for (const one of unique(found.map((node) => `${node.package} ${executableOf(node)}`))) await out(`${one}\n`);
  },
};

/** A verb about the folder of a package. @param {string} name @param {string} about @param {Verb["args"]} args @returns {Verb} */
function ofFolder(name, about, args) {
  return {
    name, about, args: [NAME, ...args],
    async run({ ros }, { package_name: wanted }) {
      return packagesOf(ros).includes(wanted) ? `ros2 pkg ${name} is not available in a page: ${FOLDERS}` : "Package not found";
    },
  };
}

/** @type {Group} */
export const PKG = {
  name: "pkg",
  about: "Various package related sub-commands",
  verbs: [
    absent("pkg", "create", "Create a new ROS 2 package", "run it on your computer", [
      { name: "package_name", help: "The package name" },
      option("format", ["--package-format", "--package_format"], "The package.xml format.", { type: INT, choices: [2, 3] }),
      option("description", ["--description"], "The description given in the package.xml"),
      option("license", ["--license"], "The license attached to this package; this can be an arbitrary string, but a LICENSE file will only be generated if it is one of the supported licenses (pass '?' to get a list)"),
      option("directory", ["--destination-directory"], "Directory where to create the package directory", { metavar: "DESTINATION_DIRECTORY" }),
      option("build", ["--build-type"], "The build type to process the package with", { choices: ["cmake", "ament_cmake", "ament_python"] }),
      option("dependencies", ["--dependencies"], "list of dependencies", { count: "+" }),
      option("maintainer_email", ["--maintainer-email"], "email address of the maintainer of this package"),
      option("maintainer_name", ["--maintainer-name"], "name of the maintainer of this package"),
      option("node_name", ["--node-name"], "name of the empty executable"),
      option("library_name", ["--library-name"], "name of the empty library"),
    ]),
    executables,
    list,
    ofFolder("prefix", "Output the prefix path of a package", [flag("share", ["--share"], "Show share directory for the package")]),
    ofFolder("xml", "Output the XML of the package manifest or a specific tag", [option("tag", ["-t", "--tag"], "The XML tag to output (e.g. 'version')")]),
  ],
};
