// @ts-check
// ros2 doctor: what is wrong with the nodes and the graph of the page.

import { infrastructureOf } from "../../graphNames.js";
import { unique } from "../args/words.js";
import { flag, isHidden } from "./verb.js";

/** @import { Ros } from "../../protocol.js" */
/** @import { Group } from "./verb.js" */

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
    flag("report", ["--report", "-r"], "Print all reports.", { group: "report" }),
    flag("failed", ["--report-failed", "-rf"], "Print reports of failed checks only.", { group: "report" }),
    flag("exclude", ["--exclude-packages", "-ep"], "Exclude package checks or report."),
    flag("warnings", ["--include-warnings", "-iw"], "Include warnings as failed checks. Warnings are ignored by default."),
  ],
  async run(io, { report, failed: reportFailed, warnings: strict }) {
    if (report) {
      for (const each of Object.values(REPORTS)) await io.out(shown(each(io.ros)));
      return;
    }
    const { ros, out, err } = io;
    const warned = warnings(ros);
    for (const warning of warned) await err(`UserWarning: ${warning}\n`, "yellow");
    const failed = Object.entries(CHECKS).map(([name, check]) => ({ name, faults: check(ros) })).filter(({ faults }) => faults.length);
    if (strict && warned.length) failed.push({ name: "topic", faults: [] });
    for (const { faults } of failed) for (const fault of faults) await err(`UserWarning: ERROR: ${fault}\n`, "red");
    const count = Object.keys(CHECKS).length + 1;
    if (!failed.length) {
      await out(`\nAll ${count} checks passed\n\n`);
      return;
    }
    await out(`\n${failed.length}/${count} check(s) failed\n\nFailed modules: ${failed.map(({ name }) => name).join(" ")}\n`);
    if (reportFailed) for (const { name } of failed) await out(shown(REPORTS[name]?.(ros)));
  },
};

/** @typedef {{title: string, items: [string, string | number][]}} Report */

/** What `ros2 doctor --report` tells, by the names of checks. @type {Record<string, (ros: Ros) => Report>} */
const REPORTS = {
  platform: () => ({ title: "PLATFORM INFORMATION", items: [["browser", navigator.userAgent]] }),
  nodes: (ros) => ({
    title: "NODE LIST",
    items: [...ros.nodes.values()].map(({ name, state, package: owner, executable }) => [name, `${owner}/${executable}, ${state}`]),
  }),
  topic: (ros) => {
    const found = ros.graph.topics().filter(({ name }) => !isHidden(name) && !infrastructureOf(name));
    return {
      title: "TOPIC LIST",
      items: found.length ? found.flatMap(({ name, publishers, subscriptions }) => /** @type {Report["items"]} */ ([
        ["topic", name], ["publisher count", publishers.length], ["subscriber count", subscriptions.length]]))
        : [["topic", "none"], ["publisher count", 0], ["subscriber count", 0]],
    };
  },
  network: (ros) => ({
    title: "QOS COMPATIBILITY LIST",
    items: ros.graph.topics().flatMap(({ name, mismatches }) => mismatches.map(({ publisher, subscription, policy }) =>
      /** @type {[string, string]} */ (["topic [type]", `${name}: ${publisher}, ${subscription}: ${policy}`]))),
  }),
};

/** A report as upstream lays it out. @param {Report | undefined} report */
function shown(report) {
  if (!report) return "";
  const longest = Math.max(0, ...report.items.map(([name]) => name.length));
  const width = longest < 8 ? 8 : longest + 4;
  return `\n   ${report.title}\n${report.items.map(([name, value]) => `${name.padEnd(width)}: ${value}\n`).join("")}`;
}

/** @type {Group[]} */
export const DOCTORS = [
  { name: "doctor", about: "Check ROS setup and other potential issues", verb: doctor },
  { name: "wtf", about: "Use `wtf` as alias to `doctor`", verb: doctor },
];
