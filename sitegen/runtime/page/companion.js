// @ts-check
// A worker that is part of the page and takes part in the graph, such as the player of a bag.

import { say } from "../ui/words.js";
import { startWorker } from "../worker.js";

/** @import { Companion, ToWorker } from "../protocol.js" */
/** @import { Graph } from "./graph.js" */

/**
 * Start a worker and let it join the graph.
 * @param {Graph} graph @param {string} file of the worker, below workers/
 * @param {(message: any) => void} told @param {(error: string) => void} failed @returns {Companion}
 */
export function join(graph, file, told, failed) {
  const worker = startWorker(file, file);
  const post = (/** @type {ToWorker} */ message, /** @type {Transferable[]} */ transfer = []) =>
    worker.postMessage(message, transfer);
  const id = graph.join(post, "", (text) => console.warn(`${file} ${text}`));
  const leave = () => {
    worker.terminate();
    graph.leave(id);
  };
  worker.onmessage = ({ data }) => {
    if (data.op === "tell") told(data.message);
    else graph.receive(id, data);
  };
  worker.onerror = (event) => {
    event.preventDefault();
    leave();
    failed(event.message || say("A part of this page could not be loaded; check the connection to the site."));
  };
  post({ op: "enter", id });
  return { tell: (message, transfer) => post({ op: "tell", message }, transfer), leave };
}
