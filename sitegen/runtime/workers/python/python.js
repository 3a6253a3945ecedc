// @ts-check
// The Python interpreter of a worker. It is loaded once, and the files of all programs are unpacked in it.

import { interruptBuffer } from "../../interrupt.js";
import { place } from "../../place.js";
import { Download } from "./download.js";
import { loadPython, PREFIX, unpack } from "./loading.js";
import { setAside } from "./stacks.js";

/** @import { Checked, FromWorker, Interpret } from "../../protocol.js" */
/** @import { Printer } from "../printer.js" */

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
    if (byte) python.setInterruptBuffer(interruptBuffer(byte));
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
    const python = await loadPython(this.#download);
    setAside(python);
    return python;
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
    unpack(python, content);
    this.#unpacked.add(url);
  }
}

/** @param {unknown} error */
export function describe(error) {
  if (!(error instanceof Error)) return String(error);
  return error.name === "Error" ? error.message : `${error.name}: ${error.message}`;
}
