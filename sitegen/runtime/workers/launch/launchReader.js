// @ts-check
// The worker that reads a launch file with other arguments, by the Python modules that read it when the site was built.

import { siteFolder } from "../../place.js";
import { confine } from "../confine.js";
import { Download } from "../python/download.js";
import { loadPython, unpack } from "../python/loading.js";

/**
 * @typedef {{reader: string, files: string, path: string, given: Record<string, string>,
 *   environment: Record<string, string>}} Order the addresses of the archives with the modules and with the files of
 *   packages, the path of the launch file, its arguments and its environment
 */

const download = new Download();
const loading = loadPython(download);
loading.catch(() => {}); // reported with the first order
confine(siteFolder);
/** The addresses of archives that were unpacked. @type {Set<string>} */
const unpacked = new Set();

/** @param {MessageEvent<Order>} event */
onmessage = async ({ data: { reader, files, path, given, environment } }) => {
  try {
    const python = await loading;
    for (const address of [reader, files]) {
      if (unpacked.has(address)) continue;
      unpack(python, await (await download.fetch(address)).arrayBuffer());
      unpacked.add(address);
    }
    const found = python.pyimport("sitegen.launch.again").read_again(
      path, JSON.stringify(given), JSON.stringify(environment));
    postMessage(JSON.parse(found));
  } catch (error) {
    postMessage({ error: error instanceof Error ? error.message : String(error) });
  }
};
