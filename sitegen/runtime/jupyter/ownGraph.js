// @ts-check
// The graph of notebooks that are opened without a page around them.

import { Graph } from "../page/graph.js";
import { NodeProcess } from "../page/nodeProcess.js";
import { WorkerGroups } from "../page/workerGroup.js";

/** @import { Kernels } from "./kernel.js" */
/** @import { PageEntry } from "../protocol.js" */

/** Return the kernels of a new graph, described by the page that shows these notebooks. @returns {Promise<Kernels>} */
export async function kernels() {
  const config = JSON.parse(document.getElementById("jupyter-config-data")?.textContent ?? "{}");
  const { page, node } = config.litePluginSettings["sitegen-ros:kernel"];
  const base = new URL(page, new URL("../../jupyter/", import.meta.url));
  /** @type {PageEntry} */
  const { nodes } = await (await fetch(base)).json();
  const entry = nodes[node];
  if (!entry) throw new Error(`${base} has no node '${node}'`);
  const graph = new Graph();
  const groups = new WorkerGroups();
  const now = Promise.resolve();
  let count = 0;
  return {
    run() {
      const times = { ready: now, mounted: now };
      const kernel = new NodeProcess(`notebook_${++count}`, entry, base.href, graph, times, groups);
      kernel.start();
      return kernel;
    },
  };
}
