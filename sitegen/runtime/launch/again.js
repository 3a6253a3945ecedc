// @ts-check
// Read the launch file of the page once more, with the arguments of a visitor.

import { startWorker } from "../worker.js";

/** @import { Launch } from "../protocol.js" */

/**
 * @typedef {{name: string, package: string, executable: string, arguments: string[],
 *   environment?: Record<string, string>}} LaunchedNode
 * @typedef {{nodes: LaunchedNode[], launch: Launch, problems: string[], notes: string[]}} Read see launch/again.py
 */

/** It has loaded Python, and stays for the next launch. @type {Worker | undefined} */
let reader;
/** The launches that wait for the one before. @type {Promise<unknown>} */
let last = Promise.resolve();

/** Whether Python has yet to be loaded. */
export function isCold() {
  return !reader;
}

/**
 * Rejects with the reason of the signal, or with an Error if the launch file cannot be read.
 * @param {NonNullable<Launch["again"]>} again @param {Record<string, string>} given @param {AbortSignal} signal
 * @returns {Promise<Read>}
 */
export function readAgain({ reader: modules, files, path, given: own, environment }, given, signal) {
  const [readerAddress, filesAddress] = [modules, files].map((address) => new URL(address, document.baseURI).href);
  const order = { reader: readerAddress, files: filesAddress, path, given: { ...own, ...given }, environment };
  const read = last.then(() => ask(order, signal));
  last = read.catch(() => {});
  return read;
}

/** @param {object} order @param {AbortSignal} signal @returns {Promise<Read>} */
function ask(order, signal) {
  signal.throwIfAborted();
  const worker = reader ??= startWorker("launch/launchReader", "launch file");
  return new Promise((resolve, reject) => {
    const end = () => {
      // What it still reads, nobody waits for.
      worker.terminate();
      reader = undefined;
    };
    const stop = () => {
      end();
      reject(signal.reason);
    };
    signal.addEventListener("abort", stop, { once: true });
    worker.onmessage = ({ data }) => {
      signal.removeEventListener("abort", stop);
      if (!("error" in data)) {
        resolve(data);
        return;
      }
      end();
      reject(new Error(data.error));
    };
    worker.onerror = (event) => {
      event.preventDefault();
      signal.removeEventListener("abort", stop);
      end();
      reject(new Error(event.message || "the reader of launch files could not be loaded"));
    };
    worker.postMessage(order);
  });
}
