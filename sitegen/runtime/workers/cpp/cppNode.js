// @ts-check
// The worker of a compiled node: load the program, run it, report its end.

import { cppHost } from "./cppHost.js";
import { keyboardHost } from "./keyboardHost.js";
import { confine } from "../confine.js";
import { Participant } from "../../participant/participant.js";
import { place, siteFolder } from "../../place.js";
import { Printer } from "../printer.js";

/** @import { FromWorker, ToWorker } from "../../protocol.js" */

// The number of stack frames to keep; the default of browsers is ten.
const DEPTH = 100;
// For programs without a line table.
const ADVICE = "    (run 'sitegen build --debug' to see where)";
const STACK_OVERFLOW = "stack overflow: too many nested calls, or too large local variables";

confine(siteFolder);

/** @param {FromWorker} message */
const post = (message) => postMessage(message);
const printer = new Printer(post);
/** @type {Participant | undefined} */
let participant;
/** Input that was typed and not read yet; an empty item is the end of input. @type {Uint8Array[]} */
const typed = [];
/** @type {Promise<any> | undefined} */
let script;
/** The address of the line table of a program built with --debug. @type {string | undefined} */
let lines;

/** @param {MessageEvent<ToWorker>} event */
onmessage = (event) => {
  if (event.data.op === "load") {
    // The WebAssembly is still being compiled. A script that cannot be loaded is reported at the start.
    script = import(place(event.data.script));
    script.catch(() => {});
  } else if (event.data.op === "start") {
    participant = new Participant(event.data.id, post);
    run(event.data, participant).catch((error) => end(1, describe(error)));
  } else if (event.data.op === "keys") {
    typed.push(new TextEncoder().encode(event.data.text));
    participant?.wake();
  } else {
    participant?.receive(event.data);
  }
};

/**
 * @param {Extract<ToWorker, {op: "start"}>} node
 * @param {Participant} graph
 */
async function run(node, graph) {
  let failure = "";
  let whence = "";
  /** @type {any} */
  let program;
  lines = node.lines;
  const [{ default: load }, files, own] = await Promise.all([
    /** @type {Promise<any>} */ (script),
    packageFiles(node, graph),
    node.environment && import(place("workers/environment.js")),
  ]);
  printer.format = own?.logFormat(node.environment);
  if (lines) Object.assign(Error, { stackTraceLimit: DEPTH });
  /** @param {unknown} error */
  const ended = (error) => {
    // With Asyncify, exit() in a fiber throws its status instead of calling onExit.
    const status = /** @type {{name?: string, status?: number}} */ (error);
    if (status?.name === "ExitStatus") {
      end(status.status ?? 0, failure, whence);
    } else {
      end(1, failure || describe(error, program), error instanceof Error ? error.stack : "");
    }
  };
  /** @param {string} text @param {string} stack */
  const fail = (text, stack) => {
    failure = text;
    whence = stack;
  };
  const grown = (/** @type {number} */ bytes) => post({ op: "memory", bytes });
  const args = [node.name, ...node.arguments];
  program = await load({
    ros: {
      ...cppHost(graph, printer, args, fail, ended, grown),
      ...keyboardHost(typed, printer, post),
      /** @param {any} file @param {number} truncated */
      open: (file, truncated) => files?.open(file, truncated) ?? 0,
    },
    noInitialRun: true,
    // The page has loaded the WebAssembly. A script in a single-file page could not resolve its name.
    locateFile: (/** @type {string} */ name) => name,
    /** @param {string} line */
    print: (line) => printer.print("stdout", line),
    /** @param {string} line */
    printErr: (line) => printer.print("stderr", line),
    /** @param {number} code */
    onExit: (code) => end(code, failure, whence),
    instantiateWasm: instantiator(node, own, ended),
  });
  files?.mount(program.rosFiles());
  post({ op: "running" });
  try {
    if (node.engine === "jspi") {
      await WebAssembly.promising(program.rosFunction(program._ros_main_pointer()))();
    } else {
      program._ros_main(); // returns at the first wait; later, `ended` or onExit is called
    }
  } catch (error) {
    ended(error);
  }
}

/**
 * Return the files of packages, for a program that opens files.
 * @param {Extract<ToWorker, {op: "start"}>} node @param {Participant} graph
 */
async function packageFiles({ share }, graph) {
  if (!share) return undefined;
  const { PackageFiles } = await import(place("workers/cpp/packageFiles.js"));
  return PackageFiles.listedAt(share, () => graph.wake(), printer);
}

/**
 * Return the function by which Emscripten's script gets an instance of the program.
 * @param {Extract<ToWorker, {op: "start"}>} node
 * @param {any} own workers/environment.js, if the node has variables of its own
 * @param {(error: unknown) => void} ended called if there is none
 */
function instantiator({ module, environment }, own, ended) {
  /**
   * @param {WebAssembly.Imports} imports
   * @param {(instance: WebAssembly.Instance, module: WebAssembly.Module) => void} loaded
   */
  return (imports, loaded) => {
    /** @type {any} */
    let exports;
    const wasi = /** @type {WebAssembly.ModuleImports} */ (imports["wasi_snapshot_preview1"]);
    Object.assign(wasi, own?.imports(environment, () => exports.memory.buffer));
    WebAssembly.instantiate(module, imports).then((instance) => {
      exports = instance.exports;
      loaded(instance, module);
    }, ended);
    return {}; // "loaded" comes later
  };
}

let over = false;

/**
 * Report the end of the program, once: exit() calls onExit and then throws.
 * @param {number} code @param {string} error @param {string} [stack] of the error
 */
async function end(code, error, stack = "") {
  if (over) return;
  over = true;
  participant?.finish();
  printer.flush();
  const told = error && `${error.trimEnd()}\n${lines ? await where(stack, lines) : ADVICE}`;
  post({ op: "exit", code, error: told });
}

/** @param {string} stack @param {string} address of the line table */
async function where(stack, address) {
  try {
    const { traceOf } = await import(place("workers/cpp/stackTrace.js"));
    return traceOf(stack, await (await fetch(address)).json());
  } catch {
    return `    (${address}, which maps it to source lines, could not be loaded)`;
  }
}

/** @param {unknown} error @param {any} [program] in which it happened */
function describe(error, program) {
  if (!(error instanceof Error)) return String(error);
  // Either the browser's stack is full, for which each has another message, or the program's own,
  // which ends at address 0 (engine.cmake): it depends on how far the browser has optimized it.
  if (/call stack|recursion/.test(error.message) || program?.stackSave?.() < 0) return STACK_OVERFLOW;
  // Emscripten adds advice that does not apply here.
  if (error.name === "RuntimeError") return error.message.replace(/ Build with .*$/, "");
  return `${error.name}: ${error.message}`;
}
