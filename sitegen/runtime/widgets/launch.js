// @ts-check
// The launch file of the page: buttons to launch and to stop it, and what it does.

import { LaunchRun } from "../launch/launchRun.js";
import { button, create, enable } from "../ui/elements.js";
import { showLines } from "../ui/lines.js";
import { NodeStateView } from "../ui/nodeState.js";
import { say, together } from "../ui/words.js";

/** @import { LaunchHandler, NodeHandle, NodeState, Ros, Severity } from "../protocol.js" */

const LINES = 1000;
/** @type {Record<string, Severity>} */
const SEVERITIES = { debug: "debug", warning: "warn", error: "error" };

/**
 * Run what the launch file does, and show it.
 * @param {HTMLElement} element
 * @param {Ros} ros
 * @returns {() => void} unmount
 */
export function mount(element, ros) {
  const { launch } = ros;
  if (!launch) throw new Error("launch: this page has no launch file");
  const panel = new LaunchPanel(launch, ros);
  element.replaceChildren(panel.element);
  panel.begin();
  return () => {
    panel.close();
    element.replaceChildren();
  };
}

/** What it does is shown as the lines of a node. */
class LaunchPanel extends EventTarget {
  #launch;
  #ros;
  #run;
  #start = button(say("Launch"), "ros-start", () => this.#begin());
  #stop = button(say("Stop"), "ros-stop", () => this.#run.shutdown());
  #clear = button(say("Clear"), "ros-clear", () => this.dispatchEvent(new Event("clear")));
  #lines;
  #listening = new AbortController();
  /** @type {NodeState} */
  state = "stopped";
  element = create("div", "ros-console");

  /** @param {NonNullable<Ros["launch"]>} launch @param {Ros} ros */
  constructor(launch, ros) {
    super();
    this.#launch = launch;
    this.#ros = ros;
    this.name = launch.file;
    this.#run = new LaunchRun(launch, {
      start: (name) => ros.nodes.get(name)?.start(),
      stop: (name) => ros.nodes.get(name)?.stop(),
      log: (level, text) => this.#print(text, SEVERITIES[level] ?? "info"),
      ends: (node, reason) => this.#print(reason ? say("All nodes are stopped: {}", reason) :
        node ? say("All nodes are stopped, because {} has ended", node) : say("All nodes are stopped")),
    }, ros);
    const node = /** @type {NodeHandle} */ (/** @type {unknown} */ (this));
    const { label } = new NodeStateView(node, this.#listening.signal);
    const title = create("div", "ros-node", create("span", "ros-name", launch.file), label);
    const controls = create("div", "ros-controls", this.#start, this.#stop, this.#clear);
    controls.setAttribute("role", "group");
    controls.setAttribute("aria-label", launch.file);
    this.element.append(create("div", "ros-bar", title, controls));
    this.#lines = showLines(this.element, node, LINES, { stopped: say("Press Launch to start all nodes"), running: say("Running, no output yet") });
    this.#run.addEventListener("change", () => this.#show());
  }

  /** Follow the nodes, and do what the launch file does with those that start with the page. */
  begin() {
    for (const name of this.#launch.nodes) {
      const node = this.#ros.nodes.get(name);
      if (!node) continue;
      // In this order: first what has happened, then what the launch file does about it.
      this.#tell(name, node);
      this.#run.watch(name, node);
    }
    const { asked = [] } = this.#launch;
    // A link may have been shared when all had ended.
    if (this.#run.first.some((name) => this.#ros.nodes.get(name)?.state === "starting")) {
      this.#explain();
      this.#run.launch((name) => !asked.includes(name));
    }
    this.#show();
  }

  close() {
    this.#listening.abort();
    this.#run.close();
    this.#lines.close();
  }

  /** Launch all. */
  #begin() {
    for (const name of this.#run.first) this.#ros.nodes.get(name)?.start();
    this.#explain();
    this.#run.launch();
  }

  /** Say which nodes start later, and why they wait. */
  #explain() {
    for (const { on, effects } of this.#launch.handlers ?? []) {
      const names = effects.filter(({ kind }) => kind === "start").flatMap(({ nodes = [] }) => nodes);
      if (names.length && on.kind !== "ended" && on.kind !== "launched") this.#print(`${together(names)}: ${waitsFor(on)}`);
    }
  }

  /** Print when a node starts and ends. @param {string} name @param {NodeHandle} node */
  #tell(name, node) {
    let before = node.state;
    node.addEventListener("state", () => {
      const was = before;
      before = node.state;
      if (before === "running" && was !== "running") this.#print(say("{} has started", name));
      else if (before === "stopped" && was !== "starting") this.#print(say("{} has ended", name));
      else if (before === "failed") this.#print(node.code ? say("{} has ended with exit code {}", name, node.code) : say("{} has failed", name), "error");
    }, { signal: this.#listening.signal });
  }

  /** @param {string} text @param {Severity} [severity] */
  #print(text, severity = "stdout") {
    this.dispatchEvent(new CustomEvent("lines", { detail: [{ severity, text }] }));
  }

  #show() {
    this.state = this.#run.active ? "running" : "stopped";
    enable([[this.#start, !this.#run.active], [this.#stop, this.#run.active]]);
    this.dispatchEvent(new Event("state"));
  }
}

/** Say what a node waits for. @param {LaunchHandler["on"]} on */
function waitsFor({ kind, nodes = [], after = 0, goal_state: goal }) {
  const names = nodes.length ? together(nodes) : say("any node");
  if (kind === "time") return say("starts after {} s", after);
  if (kind === "started") return say("starts after {} has started", names);
  if (kind === "exited") return say("starts after {} has ended", names);
  return goal ? say("starts after {} has become {}", names, goal) : say("starts after {} has changed its state", names);
}
