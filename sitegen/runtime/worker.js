// @ts-check
// Start workers that obey the policy of the page. A worker has the policy of its own script, which a plain file server
// sends without one; a script that is a blob: inherits the policy of whoever made it.

import { moduleWorkers, place } from "./place.js";

/** The addresses of scripts, by their text. @type {Map<string, string>} */
const blobs = new Map();

/**
 * Start a worker of the runtime.
 * @param {string} file of the worker, below workers/ @param {string} name for debuggers
 */
export function startWorker(file, name) {
  const address = place(`workers/${file}.js`);
  // In a single file, all scripts are blobs.
  if (!moduleWorkers) return new Worker(address, { type: "classic", name });
  return new Worker(blobOf(`import ${JSON.stringify(address)};`), { type: "module", name });
}

/** Start a classic worker. @param {string} text its script @param {string} name for debuggers */
export function startScript(text, name) {
  return new Worker(blobOf(text), { type: "classic", name });
}

/** @param {string} text */
function blobOf(text) {
  const address = blobs.get(text) ?? URL.createObjectURL(new Blob([text], { type: "text/javascript" }));
  blobs.set(text, address);
  return address;
}
