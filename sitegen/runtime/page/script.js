// @ts-check
// The scripts that an author wrote for a page.

import { place } from "../place.js";

/** @typedef {{file: string, module: string}} Script `module` is an address, relative to page.json */

// Nodes that start with the page wait for all scripts together for this long (ms), so that they miss no message.
const PATIENCE = 3000;

/**
 * Run the scripts one after the other, and resolve when nodes can start.
 * @param {Script[]} scripts @param {string} base the address of page.json
 */
export async function runScripts(scripts, base) {
  const late = new Promise((resolve) => setTimeout(resolve, PATIENCE));
  // One that never ends keeps neither the nodes nor the next ones waiting for longer.
  for (const script of scripts) await Promise.race([run(script, base), late]);
}

/** @param {Script} script @param {string} base */
function run({ file, module }, base) {
  const address = module.startsWith("sitegen:") ? place(module) : new URL(module, base).href;
  return import(address).catch((error) => {
    console.error(error);
    // Not waited for: nodes start in any case, also where this module cannot be loaded.
    import(place("page/notice.js")).then(({ notify }) => notify(`${file}: ${error}`));
  });
}
