// @ts-check
// ros2 pkg, doctor and daemon, as far as a page has what they tell about.

import { executableOf, programsOf, unique } from "../args/words.js";
import { infrastructureOf } from "../../graphNames.js";
import { flag, isHidden } from "./verb.js";

/** @import { Ros } from "../../protocol.js" */
/** @import { Group, Verb } from "./verb.js" */

const NAME = /** @type {const} */ ({ name: "package_name", help: "The package name", complete: "package" });

/** @type {Verb} */
const list = {
  name: "list",
  about: "Output a list of available packages",
  args: [],
  async run({ ros, out }) {
    for (const name of unique(programsOf(ros).map((node) => node.package))) await out(`${name}\n`);
  },
};

/** @type {Verb} */
const executables = {
  name: "executables",
  about: "Output a list of package specific executables",
  args: [{ ...NAME, count: "?" }, flag("full", ["--full-path"], "Show the full path of the executables")],
  async run({ ros, out }, { package_name: name }) {
    const found = programsOf(ros, name);
    if (name && !found.length) return `Package '${name}' not found`;
    for (const one of unique(found.map((node) => (name ? executableOf(node) : `${node.package} ${executableOf(node)}`)))) await out(`${one}\n`);
    return 0;
  },
};

/** @type {Group} */
export const PKG = { name: "pkg", about: "Various package related sub-commands", verbs: [executables, list] };

/** The checks of `ros2 doctor` that a page can make: what each finds, a line per fault. @type {Record<string, (ros: Ros) => string[]>} */
const CHECKS = {
  nodes: (ros) => [...ros.nodes.values()].filter(({ state }) => state === "failed").map(({ name }) => `${name} failed; its console says why`),
  network: (ros) => ros.graph.topics().flatMap(({ name, types, mismatches }) => [
    ...(types.length > 1 ? [`${name} has several types: ${types.join(", ")}`] : []),
    ...mismatches.map(({ publisher, subscription, policy }) => `${name}: ${subscription} does not receive from ${publisher}: ${policy}`),
  ]),
  names: (ros) => {
    const names = ros.graph.nodes();
    return unique(names.filter((name, index) => names.indexOf(name) < index)).map((name) => `several nodes have the name ${name}`);
  },
};

/** Topics that only one side uses, as upstream warns of. @param {Ros} ros */
function warnings(ros) {
  return ros.graph.topics().filter(({ name }) => !isHidden(name) && !infrastructureOf(name)).flatMap(({ name, publishers, subscriptions }) => [
    ...(!subscriptions.length ? [`Publisher without subscriber detected on ${name}.`] : []),
    ...(!publishers.length ? [`Subscriber without publisher detected on ${name}.`] : []),
  ]);
}

/** @type {Group["verb"]} */
const doctor = {
  args: [
    flag("report", ["--report", "-r"], "Print all reports."),
    flag("failed", ["--report-failed", "-rf"], "Print reports of failed checks only."),
    flag("exclude", ["--exclude-packages", "-ep"], "Exclude package checks or report."),
    flag("warnings", ["--include-warnings", "-iw"], "Include warnings as failed checks. Warnings are ignored by default."),
  ],
  async run({ ros, out, err }, { report, warnings: strict }) {
    const warned = warnings(ros);
    for (const warning of warned) await err(`UserWarning: ${warning}\n`, "yellow");
    const failed = Object.entries(CHECKS).map(([name, check]) => ({ name, faults: check(ros) })).filter(({ faults }) => faults.length);
    if (strict && warned.length) failed.push({ name: "topic", faults: [] });
    for (const { faults } of failed) for (const fault of faults) await err(`UserWarning: ERROR: ${fault}\n`, "red");
    const count = Object.keys(CHECKS).length + 1;
    if (report) {
      await out("\n   PLATFORM INFORMATION\n");
      await out(`browser          : ${navigator.userAgent}\n`);
      await out("\n   NODE LIST\n");
      for (const { name, state, package: owner, executable } of ros.nodes.values()) {
        await out(`${name.padEnd(16)} : ${owner}/${executable}, ${state}\n`);
      }
      await out("\n   TOPIC LIST\n");
      for (const { name, publishers, subscriptions } of ros.graph.topics()) {
        await out(`topic            : ${name}\npublisher count  : ${publishers.length}\nsubscriber count : ${subscriptions.length}\n`);
      }
    } else if (failed.length) {
      await out(`\n${failed.length}/${count} check(s) failed\n\nFailed modules: ${failed.map(({ name }) => name).join(", ")}\n`);
    } else {
      await out(`\nAll ${count} checks passed\n`);
    }
  },
};

/** @type {Group[]} */
export const DOCTORS = [
  { name: "doctor", about: "Check ROS setup and other potential issues", verb: doctor },
  { name: "wtf", about: "Use `wtf` as alias to `doctor`", verb: doctor },
];

const SAYS = "There is no daemon: the page knows its graph at once\n";

/** @type {Group} */
export const DAEMON = {
  name: "daemon",
  about: "Various daemon related sub-commands",
  verbs: ["start", "status", "stop"].map((name) => ({
    name,
    about: { start: "Start the daemon if it isn't running", status: "Output the status of the daemon", stop: "Stop the daemon if it is running" }[name] ?? "",
    args: [],
    run: async ({ out }) => out(name === "stop" ? "The daemon is not running\n" : SAYS),
  })),
};
