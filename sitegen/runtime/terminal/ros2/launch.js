// @ts-check
// ros2 launch: start the nodes that the launch file of the page starts, as new processes.

import { Output } from "./output.js";
import { flag } from "./verb.js";

/** @import { NodeHandle } from "../../protocol.js" */
/** @import { Io } from "../shell/shell.js" */
/** @import { Group } from "./verb.js" */

/** @type {Group} */
export const LAUNCH = {
  name: "launch",
  about: "Run a launch file",
  verb: {
    args: [
      flag("noninteractive", ["-n", "--noninteractive"], "Run the launch system non-interactively, with no terminal associated"),
      flag("debug", ["-d", "--debug"], "Put the launch system in debug mode, provides more verbose output."),
      { name: "package_name", help: "Name of the ROS package which contains the launch file", complete: "launchPackage" },
      { name: "launch_file_name", count: "?", help: "Name of the launch file", complete: "launchFile" },
      { name: "launch_arguments", count: "*", help: "Arguments to the launch file; '<name>:=<value>' (for duplicates, last one wins)" },
    ],
    async run(io, { package_name: name, launch_file_name: file, launch_arguments: given }) {
      const { launch } = io.ros;
      if (!launch || launch.package !== name) return `Package '${name}' not found: the page has ${known(io)}`;
      if (launch.file !== file) return `file '${file ?? ""}' was not found in the share directory of package '${name}': the page has ${known(io)}`;
      if (given.length) return "the launch file was read when the page was built, so it takes no arguments here";
      return attend(io, launch.nodes);
    },
  },
};

/** @param {Io} io */
function known({ ros: { launch } }) {
  return launch ? `${launch.package} ${launch.file}` : "no launch file";
}

/** Run nodes until they have ended, or until Ctrl-C. @param {Io} io @param {string[]} names */
async function attend(io, names) {
  const { ros, signal, out } = io;
  const processes = names.flatMap((name, index) => {
    const own = ros.nodes.get(name);
    return own ? [{ title: `${own.executable.replace(/-[0-9a-f]{8}$/, "")}-${index + 1}`, node: ros.run(name, { arguments: own.arguments }) }] : [];
  });
  const outputs = processes.map(({ title, node }) => new Output(io, node, `[${title}] `));
  for (const { title } of processes) await out(`[INFO] [${title}]: process started\n`);
  const stop = () => {
    for (const { node } of processes) node.stop();
  };
  signal.addEventListener("abort", stop, { once: true });
  await Promise.all(processes.map(async ({ title, node }, index) => {
    await over(node);
    await outputs[index]?.end();
    const well = !node.code;
    await out(`[${well ? "INFO" : "ERROR"}] [${title}]: process has ${well ? "finished cleanly" : `died [exit code ${node.code}]`}\n`, well ? "" : "red");
  }));
  signal.removeEventListener("abort", stop);
  return processes.some(({ node }) => node.code) && !signal.aborted ? 1 : 0;
}

/** @param {NodeHandle} node @returns {Promise<void>} */
function over(node) {
  return new Promise((resolve) => {
    const look = () => (node.state === "stopped" || node.state === "failed") && resolve();
    node.addEventListener("state", look);
    look();
  });
}
