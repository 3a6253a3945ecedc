// @ts-check
// The worker of Python nodes: load Python and the files of their packages, call their entry points, report
// how each ended. A node that has the worker for itself talks through it, those that share it through ports.

import { Participant } from "../participant/participant.js";
import { Download } from "./download.js";
import { Printer } from "./printer.js";
import { pythonHost } from "./pythonHost.js";

/** @import { FromWorker, Interpret, ToWorker, Typed } from "../protocol.js" */
/** @typedef {{postMessage(message: FromWorker): void, onmessage: ((event: MessageEvent) => any) | null}} Way */

// As rclpy_backend/program.py has it.
const PREFIX = "/ros";

// Python comes while the page is still busy with its widgets.
const download = new Download();
const loading = load(new URL("../vendor/pyodide/", import.meta.url));
loading.catch(() => {}); // told when a node starts
/** What was unpacked, by its address. @type {Set<string>} */
const unpacked = new Set();

serve(/** @type {Way} */ (/** @type {unknown} */ (self)));

/** @param {URL} folder */
async function load(folder) {
  const browsers = globalThis.fetch;
  // Python's own loader says nothing when a file is missing.
  globalThis.fetch = download.fetch;
  try {
    const loader = new URL("pyodide.mjs", folder);
    const { loadPyodide } = await import(loader.href).catch(() => download.lack(loader));
    const python = await Promise.race([loadPyodide({ indexURL: folder.href }), download.failed]);
    const sys = python.pyimport("sys");
    sys.path.insert(0, `${PREFIX}/python`);
    sys.dont_write_bytecode = true; // the next visitor has another interpreter
    return python;
  } finally {
    globalThis.fetch = browsers;
  }
}

/** Run the node that asks for it. @param {Way} way to the page */
function serve(way) {
  const post = (/** @type {FromWorker} */ message) => way.postMessage(message);
  const printer = new Printer(post);
  /** @type {Participant | undefined} */
  let participant;
  /** @type {Typed[]} */
  const typed = [];

  /** @param {MessageEvent<ToWorker>} event */
  way.onmessage = ({ data, ports }) => {
    if (data.op === "join" && ports[0]) {
      serve(ports[0]);
    } else if (data.op === "interpret") {
      participant = new Participant(data.id, post);
      run(data, participant).catch((error) => end(1, describe(error)));
    } else if (data.op === "line" || data.op === "complete") {
      typed.push(data);
      participant?.wake();
    } else {
      participant?.receive(data);
    }
  };

  /** @param {Interpret} node @param {Participant} graph */
  async function run({ name, program, arguments: args, edits }, graph) {
    download.expect(program.size, post);
    const files = program.bundles.map(fetched);
    const python = await loading;
    for (const [index, url] of program.bundles.entries()) await unpack(python, url, files[index]);
    download.forget(post);
    for (const [place, text] of Object.entries(edits)) {
      python.FS.writeFile(`${PREFIX}/${place}`, text);
      unpacked.delete(program.bundles.at(-1) ?? ""); // the next node has its files as they were
    }
    const failed = (/** @type {unknown} */ error) => end(1, describe(error));
    // What the interpreter writes by itself; programs have streams of their own.
    for (const set of [python.setStdout, python.setStderr]) {
      set.call(python, { batched: (/** @type {string} */ line) => printer.print("stderr", line) });
    }
    const host = pythonHost(graph, printer, typed, post, failed);
    post({ op: "memory", bytes: python._module.HEAPU8.length });
    post({ op: "running" });
    const words = python.toPy([`${PREFIX}/lib/${name}`, ...args]);
    const { module, attribute, own } = program;
    end(await interpreter(python).callPromising(host, python.toPy(own), module, attribute, words), "");
  }

  /** @param {number} code @param {string} error */
  function end(code, error) {
    printer.flush();
    participant?.flush();
    post({ op: "exit", code, error });
  }
}

/** @type {any} */
let runs;

/** The function of Python that runs programs. @param {any} python */
function interpreter(python) {
  return (runs ??= python.pyimport("rclpy_backend.interpreter").run);
}

/** @param {string} url @returns {Promise<ArrayBuffer> | undefined} undefined if it is there already */
function fetched(url) {
  return unpacked.has(url) ? undefined : download.fetch(url).then((response) => response.arrayBuffer());
}

/** @param {any} python @param {string} url @param {Promise<ArrayBuffer> | undefined} file */
async function unpack(python, url, file) {
  const content = await file;
  if (unpacked.has(url) || !content) return;
  python.unpackArchive(content, "zip", { extractDir: PREFIX });
  unpacked.add(url);
}

/** @param {unknown} error */
function describe(error) {
  if (!(error instanceof Error)) return String(error);
  return error.name === "Error" ? error.message : `${error.name}: ${error.message}`;
}
