// @ts-check
// ros2 run: start a program of the page as a new process, with its output and input in the terminal.

import { sections } from "../../messages/parameters/fileReader.js";
import { executableOf, programsOf } from "../args/words.js";
import { Failure } from "../shell/shell.js";
import { Output } from "./output.js";
import { isInterrupt, option } from "./verb.js";

/** @import { NodeHandle } from "../../protocol.js" */
/** @import { Io, Shell } from "../shell/shell.js" */
/** @import { Group } from "./verb.js" */

// As in nodeProcess.js, which terminates a program that does not end after Ctrl-C.
const OVER = new Set(["stopped", "failed"]);

/** @type {Group} */
export const RUN = {
  name: "run",
  about: "Run a package specific executable",
  verb: {
    args: [
      option("prefix", ["--prefix"], "Prefix command, which should go before the executable. Command must be wrapped in quotes if it contains spaces (e.g. --prefix 'gdb -ex run --args')."),
      { name: "package_name", help: "Name of the ROS package", complete: "package" },
      { name: "executable_name", help: "Name of the executable", complete: "executable" },
      { name: "argv", count: "...", initial: [], help: "Pass arbitrary arguments to the executable" },
    ],
    async run(io, { prefix, package_name: name, executable_name: executable, argv }) {
      const { ros, err } = io;
      if (prefix) throw new Failure("ros2 run: --prefix needs another program, and a page has none");
      const own = programsOf(ros, name);
      const program = own.find((one) => executableOf(one) === executable);
      if (!program) {
        const known = new Set(programsOf(ros).map((one) => `${one.package} ${executableOf(one)}`));
        await err(`The programs of this page: ${[...known].join(", ") || "none"}\n`, "faint");
        return own.length ? "No executable found" : `Package '${name}' not found`;
      }
      const node = ros.run(program.name, { arguments: withFiles(argv, io.shell) });
      return attend(io, node);
    },
  },
};

/**
 * Show what a node prints, and give it what is typed, until it ends. @param {Io} io @param {NodeHandle} node
 * @param {string} [sign] before the message of a failure; without one, there is none
 */
export async function attend(io, node, sign = "[ros2run]: ") {
  const { signal, out } = io;
  const output = new Output(io, node);
  const endKeys = giveKeys(io, node);
  const ended = /** @type {Promise<void>} */ (new Promise((resolve) => {
    const look = () => OVER.has(node.state) && resolve();
    node.addEventListener("state", look);
    look();
  }));
  const stopped = new Promise((_, reject) => {
    if (signal.aborted) reject(signal.reason);
    signal.addEventListener("abort", () => reject(signal.reason), { once: true });
  });
  try {
    await Promise.race([ended, stopped]);
  } catch (error) {
    node.stop();
    await ended;
    if (!isInterrupt(error)) throw error;
  } finally {
    endKeys();
    await output.end();
  }
  const code = node.code;
  if (signal.aborted) return code ?? 0;
  if (code && sign) await out(`${sign}Process exited with failure ${code}\n`);
  return code ?? 1;
}

/** Let keys go to a node while it reads them. @param {Io} io @param {NodeHandle} node */
function giveKeys({ keys, out }, node) {
  let end = () => {};
  let line = "";
  const typed = (/** @type {string} */ data) => {
    const { keyboard } = node;
    if (data === "\x03" && keyboard !== "raw") {
      node.interrupt();
      return;
    }
    if (keyboard === "keys" || keyboard === "raw") {
      node.type({ op: "keys", text: keyboard === "keys" ? data.replaceAll("\r", "\n") : data });
      return;
    }
    for (const letter of data) {
      if (letter === "\r") {
        out("\n");
        node.type({ op: "keys", text: `${line}\n` });
        line = "";
      } else if (letter === "\x7f") {
        line = line.slice(0, -1);
      } else if (letter === "\x04" && !line) {
        node.type({ op: "keys", text: "" });
      } else if (letter >= " ") {
        line += letter;
        if (keyboard === "lines") out(letter);
      }
    }
  };
  const look = () => {
    end();
    end = node.keyboard && keys ? keys(typed) : () => {};
  };
  node.addEventListener("reading", look);
  look();
  return () => {
    node.removeEventListener("reading", look);
    end();
  };
}

/** Replace --params-file of the tab's files by the parameters in it. @param {string[]} words @param {Shell} shell */
function withFiles(words, shell) {
  /** @type {string[]} */
  const found = [];
  for (let index = 0; index < words.length; index++) {
    const word = words[index] ?? "";
    const file = words[index + 1];
    if (word !== "--params-file" || file === undefined || !shell.files.has(file)) {
      found.push(word);
      continue;
    }
    index++;
    for (const { node, parameters } of sections(shell.readFile(file))) {
      const before = node === "/**" ? "" : `${node.replace(/^\//, "")}:`;
      for (const [name, value] of parameters) found.push("-p", `${before}${name}:=${value}`);
    }
  }
  return found;
}
