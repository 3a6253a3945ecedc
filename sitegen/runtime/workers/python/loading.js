// @ts-check
// Load the Python interpreter of a worker.

import { moduleWorkers, place } from "../../place.js";

/** @import { Download } from "./download.js" */

// As in rclpy_backend/program.py.
export const PREFIX = "/ros";

/** Load Python, which imports the modules in PREFIX/python. @param {Download} download */
export async function loadPython(download) {
  const browsers = globalThis.fetch;
  // Pyodide's loader does not report missing files.
  globalThis.fetch = download.fetch;
  try {
    const loader = place("vendor/pyodide/pyodide.mjs");
    const { loadPyodide } = await import(loader).catch(() => download.lackModule(new URL(loader)));
    const python = await Promise.race([loadPyodide(await options()), download.failed]);
    const sys = python.pyimport("sys");
    sys.path.insert(0, `${PREFIX}/python`);
    sys.dont_write_bytecode = true; // no other interpreter would read it
    return python;
  } finally {
    globalThis.fetch = browsers;
  }
}

/** Unpack an archive below PREFIX. @param {any} python @param {ArrayBuffer} archive */
export function unpack(python, archive) {
  python.unpackArchive(archive, "zip", { extractDir: PREFIX });
}

/** Where Python's own loader finds its files. In a page that is a single file, it could not import its module. */
async function options() {
  if (moduleWorkers) return { indexURL: place("vendor/pyodide/") };
  const module = await import(place("vendor/pyodide/pyodide.asm.mjs"));
  return { indexURL: "sitegen:runtime/vendor/pyodide/", createPyodideModule: module.default };
}
