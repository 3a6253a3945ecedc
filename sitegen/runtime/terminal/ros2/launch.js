// @ts-check
// ros2 launch: start the nodes that the launch file of the page starts, as new processes.

import { isCold, readAgain } from "../../launch/again.js";
import { LaunchRun, isOver } from "../../launch/launchRun.js";
import { Output } from "./output.js";
import { quoted } from "./python.js";
import { Failure } from "../shell/shell.js";
import { flag, option } from "./verb.js";

/** @import { LaunchedNode } from "../../launch/again.js" */
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
      { name: "launch_arguments", count: "*", help: "Arguments to the launch file; '<name>:=<value>' (for duplicates, last one wins)", complete: "launchArgument" },
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
      const values = Object.fromEntries(given.map(argument));
      if (!given.length) return attend(io, launch);
      if (!launch.again) return noArguments(launch);
      return launchAgain(io, launch.again, values);
    },
  },
};

/** The arguments of a launch file, as upstream lists them. @param {Launch} launch */
function shown({ arguments: declared = [] }) {
  const lines = declared.map(({ name, default: value, description, choices }) => [
    `\n    '${name}':`, `        ${described(description, choices)}`,
    ...(value === undefined ? [] : [`        (default: ${quoted(value)})`]), "",
  ].join("\n"));
  return `Arguments (pass arguments as '<name>:=<value>'):\n${lines.join("") || "\n  No arguments.\n"}`;
}

/** @param {string} [description] of an argument @param {string[]} [choices] */
function described(description, choices) {
  if (!choices) return description || "no description given";
  const listed = `[${choices.map(quoted).join(", ")}]`;
  return description ? `${description.replace(/\.?$/, ".")} Valid choices are: ${listed}` : `One of: ${listed}`;
}

/** @param {string} word @returns {[name: string, value: string]} */
function argument(word) {
  const [, name, value] = /^([^]*?):=([^]*)$/.exec(word) ?? [];
  if (!name || !value) throw new Failure(`malformed launch argument '${word}', expected format '<name>:=<value>'`);
  return [name, value];
}

/** Why a launch file cannot be read again. @param {Launch} launch */
function noArguments({ arguments: declared = [] }) {
  if (!declared.length) return "this launch file declares no arguments";
  return "a page that is a single file cannot read its launch file again, so it takes no arguments here";
}

/** @param {Io} io @param {NonNullable<Launch["again"]>} again @param {Record<string, string>} given */
async function launchAgain(io, again, given) {
  const { err, signal, ros } = io;
  if (isCold()) await err("[INFO] [launch]: Loading Python to read the launch file\n", "faint");
  const { launch, nodes, problems, notes } = await readAgain(again, given, signal);
  for (const note of notes) await err(`[WARNING] [launch]: ${note}\n`, STYLES.WARNING);
  const programs = new Set([...ros.nodes.values()].map((one) => `${one.package} ${one.executable}`));
  const missing = nodes.filter((one) => !programs.has(`${one.package} ${one.executable}`));
  const faults = [...problems, ...missing.map(({ package: name, executable }) =>
    `executable '${executable}' of package '${name}' is not on this page`)];
  for (const fault of faults) {
    await err(`[ERROR] [launch]: Caught exception in launch (see debug for traceback): ${fault}\n`, STYLES.ERROR);
  }
  return faults.length ? 1 : attend(io, launch, nodes);
}

/** @param {Io} io */
function known({ ros: { launch } }) {
  return launch ? `${launch.package} ${launch.file}` : "no launch file";
}

/**
 * Run what a launch file starts until it has ended, or until Ctrl-C.
 * @param {Io} io @param {Launch} launch @param {LaunchedNode[]} [nodes] those of the page, if nothing else is given
 */
async function attend(io, launch, nodes) {
  const processes = new Processes(io, launch, nodes);
  const stop = () => processes.run.shutdown();
  io.signal.addEventListener("abort", stop, { once: true });
  await processes.ended();
  io.signal.removeEventListener("abort", stop);
  return processes.failed && !io.signal.aborted ? 1 : 0;
}

/** The processes of a launch file: programs of the page that run once more. */
class Processes {
  #io;
  #nodes;
  #count = 0;
  /** By the name of the node. @type {Map<string, {title: string, node: NodeHandle}>} */
  #running = new Map();
  /** What is to be written, in its order. @type {Promise<void>} */
  #written = Promise.resolve();
  /** Why nothing can be written. @type {unknown} */
  #error;
  /** Whether a process ended with an error. */
  failed = false;

  /** @param {Io} io @param {Launch} launch @param {LaunchedNode[]} [nodes] */
  constructor(io, launch, nodes) {
    this.#io = io;
    this.#nodes = new Map(nodes?.map((node) => [node.name, node]));
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
    const described = this.#nodes.get(name);
    const own = described ?? ros.nodes.get(name);
    if (!own) return;
    // A process that is started again keeps its number.
    const title = this.#running.get(name)?.title ?? `${own.executable.replace(/-[0-9a-f]{8}$/, "")}-${++this.#count}`;
    const node = described ? ros.run(described, described) : ros.run(name, { arguments: own.arguments });
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
