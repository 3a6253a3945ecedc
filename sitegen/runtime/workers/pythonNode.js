// @ts-check
// The worker of a Python node: load Python and the files of its packages, call its entry point, report how
// it ended.

import { Participant } from "../participant/participant.js";
import { Download } from "./download.js";
import { Printer } from "./printer.js";
import { pythonHost } from "./pythonHost.js";

/** @import { FromWorker, ToWorker, Typed } from "../protocol.js" */

// As rclpy_backend/program.py has it.
const PREFIX = "/ros";

/** @param {FromWorker} message */
const post = (message) => postMessage(message);
const printer = new Printer(post);
/** @type {Participant | undefined} */
let participant;
/** @type {Typed[]} */
const typed = [];

/** @param {MessageEvent<ToWorker>} event */
onmessage = (event) => {
  if (event.data.op === "interpret") {
    participant = new Participant(event.data.id, post);
    run(event.data, participant).catch((error) => end(1, describe(error)));
  } else if (event.data.op === "line" || event.data.op === "complete") {
    typed.push(event.data);
    participant?.wake();
  } else {
    participant?.receive(event.data);
  }
};

// Python comes while the page is still busy with its widgets.
const download = new Download(post);
const loading = load(new URL("../vendor/pyodide/", import.meta.url));
loading.catch(() => {}); // told when the node starts

/** @param {URL} folder */
async function load(folder) {
  const browsers = globalThis.fetch;
  // Python's own loader says nothing when a file is missing.
  globalThis.fetch = download.fetch;
  try {
    const loader = new URL("pyodide.mjs", folder);
    const { loadPyodide } = await import(loader.href).catch(() => download.lack(loader));
    return await Promise.race([loadPyodide({ indexURL: folder.href }), download.failed]);
  } finally {
    globalThis.fetch = browsers;
  }
}

/**
 * @param {Extract<ToWorker, {op: "interpret"}>} node
 * @param {Participant} graph
 */
async function run({ name, program, arguments: args }, graph) {
  download.expect(program.size);
  const files = Promise.all(program.bundles.map(fetched));
  const python = await loading;
  python.setStdout({ batched: (/** @type {string} */ line) => printer.print("stdout", line) });
  python.setStderr({ batched: (/** @type {string} */ line) => printer.print("stderr", line) });
  for (const bundle of await files) python.unpackArchive(bundle, "zip", { extractDir: PREFIX });
  const failed = (/** @type {unknown} */ error) => end(1, describe(error));
  python.registerJsModule("ros_host", pythonHost(graph, printer, typed, post, failed));
  python.pyimport("sys").path.insert(0, `${PREFIX}/python`);
  post({ op: "memory", bytes: python._module.HEAPU8.length });
  const { run: call } = python.pyimport("rclpy_backend.program");
  post({ op: "running" });
  const words = python.toPy([`${PREFIX}/lib/${name}`, ...args]);
  end(await call.callPromising(program.module, program.attribute, words), "");
}

/** @param {string} url */
async function fetched(url) {
  return (await download.fetch(url)).arrayBuffer();
}

/** @param {number} code @param {string} error */
function end(code, error) {
  printer.flush();
  participant?.flush();
  post({ op: "exit", code, error });
}

/** @param {unknown} error */
function describe(error) {
  if (!(error instanceof Error)) return String(error);
  return error.name === "Error" ? error.message : `${error.name}: ${error.message}`;
}
