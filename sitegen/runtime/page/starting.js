// @ts-check
// How each kind of program is started: the worker that runs it, and the message that makes it run.

import { engine } from "../engine.js";
import { sharesMemory } from "../interrupt.js";
import { place } from "../place.js";
import { obstacle } from "./isolated.js";

/** @import { NodeEntry, ToWorker } from "../protocol.js" */

/**
 * @typedef {{name: string, entry: NodeEntry, base: string, arguments: string[],
 *   edits(): Promise<Record<string, string>>, compile(url: string): Promise<WebAssembly.Module>}} Program what runs:
 *   `base` is the address that paths of the entry are relative to, and `edits` are the files that a visitor has changed
 * @typedef {(message: ToWorker) => void} Post
 * @typedef {{worker: string, group?: string | false,
 *   prepare(id: number, post: Post, byte?: Uint8Array): ToWorker | Promise<ToWorker>}} Start `worker` is its file below
 *   workers/, and `group` that of nodes that share it; `id` is that of the worker in the graph
 */

const LACK = "this browser does not support JavaScript Promise Integration, which";

/**
 * Return how to start a program; a text says why this browser cannot.
 * @param {Program} program @returns {Start | string}
 */
export function starting({ name, entry, base, arguments: words, edits, compile }) {
  const { builds = {}, python, ros2wasm, javascript, executable, environment, share } = entry;
  const at = (/** @type {string} */ path) => new URL(path, base).href;
  if (javascript) {
    return { worker: "javascript/javascriptNode", prepare: (id) => ({ op: "evaluate", id, name, program: javascript }) };
  }
  if (ros2wasm) {
    const program = { ...ros2wasm, script: at(ros2wasm.script) };
    return { worker: "ros2wasm/ros2wasmNode", prepare: (id) => ({ op: "adopt", id, name, program }) };
  }
  if (python) {
    if (engine !== "jspi" && !sharesMemory) {
      return `${LACK} Python nodes need; Chrome 137, Edge 137, Firefox 153 and newer support it${obstacle()}`;
    }
    const program = { ...python, bundles: python.bundles.map(at) };
    return {
      worker: "python/pythonNode",
      // Programs share an interpreter as stacks of it, which JSPI sets aside.
      group: engine === "jspi" && python.group,
      prepare: async (id, _, byte) => ({
        op: "interpret", id, name: executable, program, arguments: words, environment, edits: await edits(), byte,
      }),
    };
  }
  const built = builds[engine] ? engine : "asyncify";
  const build = builds[built];
  if (!build) return `${LACK} the node needs`;
  return {
    worker: "cpp/cppNode",
    async prepare(id, post) {
      post({ op: "load", script: at(build.script) });
      return {
        op: "start", id, engine: built, module: await compile(place(at(build.wasm))), name: executable, arguments: words,
        environment, lines: build.lines && at(build.lines), share: share && at(share),
      };
    },
  };
}
