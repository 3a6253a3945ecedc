// @ts-check
// The Python interpreter of a worker. It is loaded once, and the files of all programs are unpacked in it.

import { moduleWorkers, place } from "../../place.js";
import { Download } from "./download.js";
import { setAside } from "./stacks.js";

/** @import { Checked, FromWorker, Interpret } from "../../protocol.js" */
/** @import { Printer } from "../printer.js" */

// As in rclpy_backend/program.py.
const PREFIX = "/ros";

export class Python {
  #download = new Download();
  #loading = this.#load();
  /** The addresses of archives that were unpacked. @type {Set<string>} */
  #unpacked = new Set();
  /** The Python functions that run a program and prepare for it. @type {any} */
  #run;
  /** @type {any} */
  #begin;

  constructor() {
    this.#loading.catch(() => {}); // reported when a node starts
  }

  /**
   * Load a program and its dependencies.
   * @param {Interpret} node @param {Printer} printer @param {(message: FromWorker) => void} post to the page
   */
  async prepare({ program, edits, environment, byte }, printer, post) {
    if (environment) {
      const { logFormat } = await import(place("workers/environment.js"));
      printer.format = logFormat(environment);
    }
    this.#download.expect(program.size, post);
    const files = program.bundles.map((url) => this.#fetched(url));
    const python = await this.#loading;
    for (const [index, url] of program.bundles.entries()) await this.#unpack(python, url, files[index]);
    this.#download.forget(post);
    for (const [place, text] of Object.entries(edits)) {
      python.FS.writeFile(`${PREFIX}/${place}`, text);
      this.#unpacked.delete(program.bundles.at(-1) ?? ""); // so that the next node gets the original files
    }
    // For output of the interpreter itself; programs have their own streams.
    for (const set of [python.setStdout, python.setStderr]) {
      set.call(python, { batched: (/** @type {string} */ line) => printer.print("stderr", line) });
    }
    if (byte) python.setInterruptBuffer(byte);
    post({ op: "memory", bytes: python._module.HEAPU8.length });
    post({ op: "running" });
  }

  /**
   * Run a program that was prepared, and return its exit code; with stacks, a promise for that.
   * @param {Interpret} node @param {{stacks: boolean}} host see pythonHost.js
   */
  async run({ name, program, arguments: args, environment = {} }, host) {
    const python = await this.#loading;
    this.#run ??= python.pyimport("rclpy_backend.system.interpreter").run;
    this.#begin ??= python.pyimport("rclpy_backend.system.collecting").begin;
    this.#begin();
    const { module, attribute, own } = program;
    const line = python.toPy([`${PREFIX}/lib/${name}`, ...args]);
    const words = [host, python.toPy(own), module, attribute, line, python.toPy(environment)];
    return /** @type {number | Promise<number>} */ (
      host.stacks ? this.#run.callPromising(...words) : this.#run(...words)
    );
  }

  /** Find the first syntax error in a source text. @param {string} text */
  async check(text) {
    const python = await this.#loading;
    const [line, error] = python.pyimport("rclpy_backend.system.syntax").check(text);
    return /** @type {{op: "checked"} & Checked} */ ({ op: "checked", text, line, error });
  }

  async #load() {
    const browsers = globalThis.fetch;
    // Pyodide's loader does not report missing files.
    globalThis.fetch = this.#download.fetch;
    try {
      const loader = place("vendor/pyodide/pyodide.mjs");
      const { loadPyodide } = await import(loader).catch(() => this.#download.lackModule(new URL(loader)));
      const python = await Promise.race([loadPyodide(await options()), this.#download.failed]);
      const sys = python.pyimport("sys");
      sys.path.insert(0, `${PREFIX}/python`);
      setAside(python);
      sys.dont_write_bytecode = true; // no other interpreter would read it
      return python;
    } finally {
      globalThis.fetch = browsers;
    }
  }

  /** @param {string} url @returns {Promise<ArrayBuffer> | undefined} undefined if it was unpacked */
  #fetched(url) {
    if (this.#unpacked.has(url)) return undefined;
    return this.#download.fetch(url).then((response) => response.arrayBuffer());
  }

  /** @param {any} python @param {string} url @param {Promise<ArrayBuffer> | undefined} file */
  async #unpack(python, url, file) {
    const content = await file;
    if (this.#unpacked.has(url) || !content) return;
    python.unpackArchive(content, "zip", { extractDir: PREFIX });
    this.#unpacked.add(url);
  }
}

/** Where Python's own loader finds its files. In a page that is a single file, it could not import its module. */
async function options() {
  if (moduleWorkers) return { indexURL: place("vendor/pyodide/") };
  const module = await import(place("vendor/pyodide/pyodide.asm.mjs"));
  return { indexURL: "sitegen:runtime/vendor/pyodide/", createPyodideModule: module.default };
}

/** @param {unknown} error */
export function describe(error) {
  if (!(error instanceof Error)) return String(error);
  return error.name === "Error" ? error.message : `${error.name}: ${error.message}`;
}
