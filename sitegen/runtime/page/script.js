// @ts-check
// The script that an author wrote for a page.

import { place } from "../place.js";

// Nodes that start with the page wait for it for this long (ms), so that it misses no message.
const PATIENCE = 3000;

/**
 * Run the script and resolve when nodes can start.
 * @param {{file: string, module: string}} script `module` is its address, relative to `base` @param {string} base
 */
export function runScript({ file, module }, base) {
  const address = module.startsWith("sitegen:") ? place(module) : new URL(module, base).href;
  const run = import(address).catch((error) => {
    console.error(error);
    // Not waited for: nodes start in any case, also where this module cannot be loaded.
    import(place("page/notice.js")).then(({ notify }) => notify(`${file}: ${error}`));
  });
  return Promise.race([run, new Promise((resolve) => setTimeout(resolve, PATIENCE))]);
}
