// @ts-check
// ros2 launch: start the nodes that the launch file of the page starts, as new processes.

import { LaunchRun, isOver } from "../../launch/launchRun.js";
import { Output } from "./output.js";
import { quoted } from "./python.js";
import { Failure } from "../shell/shell.js";
import { flag, option } from "./verb.js";

/** @import { Launch, NodeHandle } from "../../protocol.js" */
/** @import { Io } from "../shell/shell.js" */
/** @import { Style } from "../shell/style.js" */
/** @import { Group } from "./verb.js" */

/** @type {Record<string, Style>} */
const STYLES = { WARNING: "yellow", ERROR: "red", DEBUG: "green" };

/** @type {Group} */
export const LAUNCH = {
  name: "launch",
  about: "Run a launch file",
  verb: {
    args: [
      flag("noninteractive", ["-n", "--noninteractive"], "Run the launch system non-interactively, with no terminal associated"),
      flag("debug", ["-d", "--debug"], "Put the launch system in debug mode, provides more verbose output."),
      flag("print", ["-p", "--print", "--print-description"], "Print the launch description to the console without launching it.", { group: "print" }),
      flag("show_args", ["-s", "--show-args", "--show-arguments"], "Show arguments that may be given to the launch file.", { group: "print" }),
      flag("all_output", ["-a", "--show-all-subprocesses-output"], "Show all launched subprocesses' output by overriding their output configuration using the OVERRIDE_LAUNCH_PROCESS_OUTPUT envvar."),
      option("launch_prefix", ["--launch-prefix"], "Prefix command, which should go before all executables. Command must be wrapped in quotes if it contains spaces (e.g. --launch-prefix 'xterm -e gdb -ex run --args')."),
      option("launch_prefix_filter", ["--launch-prefix-filter"], "Regex pattern for filtering which executables the --launch-prefix is applied to by matching the executable name."),
      { name: "package_name", help: "Name of the ROS package which contains the launch file", complete: "launchPackage" },
      { name: "launch_file_name", count: "?", help: "Name of the launch file", complete: "launchFile" },
      { name: "launch_arguments", count: "*", help: "Arguments to the launch file; '<name>:=<value>' (for duplicates, last one wins)" },
    ],
    async run(io, args) {
      const { package_name: name, launch_file_name: file, launch_arguments: given } = args;
      const { launch } = io.ros;
      if (!launch || launch.package !== name) return `Package '${name}' not found: the page has ${known(io)}`;
      if (launch.file !== file) return `file '${file ?? ""}' was not found in the share directory of package '${name}': the page has ${known(io)}`;
      if (args.launch_prefix === undefined && args.launch_prefix_filter !== undefined) {
        return "--launch-prefix must be specified if --launch-prefix-filter is provided";
      }
      if (args.launch_prefix !== undefined) return "ros2 launch: --launch-prefix needs another program, and a page has none";
      if (args.print) return "ros2 launch --print is not available in a page: its launch file was read when the site was built";
      if (args.show_args) {
        await io.out(shown(launch));
        return 0;
      }
      for (const word of given) checkArgument(word);
      if (given.length) return "the launch file was read when the page was built, so it takes no arguments here";
      return attend(io, launch);
    },
  },
};

/** The arguments of a launch file, as upstream lists them. @param {Launch} launch */
function shown({ arguments: declared = [] }) {
  const lines = declared.map(({ name, default: value, description }) => [
    `\n    '${name}':`, `        ${description || "no description given"}`,
    ...(value === undefined ? [] : [`        (default: ${quoted(value)})`]), "",
  ].join("\n"));
  return `Arguments (pass arguments as '<name>:=<value>'):\n${lines.join("") || "\n  No arguments.\n"}`;
}

/** @param {string} word */
function checkArgument(word) {
  const [, name, value] = /^([^]*?):=([^]*)$/.exec(word) ?? [];
  if (!name || value === "") throw new Failure(`malformed launch argument '${word}', expected format '<name>:=<value>'`);
}

/** @param {Io} io */
function known({ ros: { launch } }) {
  return launch ? `${launch.package} ${launch.file}` : "no launch file";
}

/** Run what a launch file starts until it has ended, or until Ctrl-C. @param {Io} io @param {Launch} launch */
async function attend(io, launch) {
  const processes = new Processes(io, launch);
  const stop = () => processes.run.shutdown();
  io.signal.addEventListener("abort", stop, { once: true });
  await processes.ended();
  io.signal.removeEventListener("abort", stop);
  return processes.failed && !io.signal.aborted ? 1 : 0;
}

/** The processes of a launch file: nodes of the page that run once more. */
class Processes {
  #io;
  #count = 0;
  /** By the name of the node. @type {Map<string, {title: string, node: NodeHandle}>} */
  #running = new Map();
  /** What is to be written, in its order. @type {Promise<void>} */
  #written = Promise.resolve();
  /** Why nothing can be written. @type {unknown} */
  #error;
  /** Whether a process ended with an error. */
  failed = false;

  /** @param {Io} io @param {Launch} launch */
  constructor(io, launch) {
    this.#io = io;
    this.run = new LaunchRun(launch, {
      start: (name) => this.#start(name),
      stop: (name) => this.#running.get(name)?.node.stop(),
      log: (level, text) => this.#write(level.toUpperCase(), "launch.user", text),
      ends: (node) => node && this.#write("INFO", "launch", `process[${this.#running.get(node)?.title ?? node}] was required: shutting down launched system`),
    }, io.ros);
    for (const name of this.run.first) this.#start(name);
    this.run.launch();
  }

  /** Resolve when no process runs, and nothing waits. */
  async ended() {
    await new Promise((/** @type {(value?: void) => void} */ resolve) => {
      const look = () => {
        if (!this.run.active) resolve();
      };
      this.run.addEventListener("change", look);
      look();
    });
    this.run.close();
    await this.#written;
    if (this.#error) throw this.#error;
  }

  /** @param {string} name */
  #start(name) {
    const { ros } = this.#io;
    const own = ros.nodes.get(name);
    if (!own) return;
    // A process that is started again keeps its number.
    const title = this.#running.get(name)?.title ?? `${own.executable.replace(/-[0-9a-f]{8}$/, "")}-${++this.#count}`;
    const node = ros.run(name, { arguments: own.arguments });
    this.#running.set(name, { title, node });
    this.#write("INFO", title, "process started");
    const output = new Output(this.#io, node, `[${title}] `);
    node.addEventListener("state", () => {
      if (!isOver(node)) return;
      const code = node.code;
      this.failed ||= Boolean(code);
      this.#written = this.#written.then(() => output.end());
      this.#write(code ? "ERROR" : "INFO", title, `process has ${code ? `died [exit code ${code}]` : "finished cleanly"}`);
    });
    this.run.watch(name, node);
  }

  /** @param {string} level @param {string} from @param {string} text */
  #write(level, from, text) {
    this.#written = this.#written.then(() => this.#io.out(`[${level}] [${from}]: ${text}\n`, STYLES[level] ?? "")).catch((error) => {
      // Nobody reads it, as with `| head`.
      this.#error ??= error;
      this.run.shutdown();
    });
  }
}
