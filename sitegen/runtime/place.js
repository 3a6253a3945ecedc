// @ts-check
// The addresses of the site's files: on its server, or inside a page that is a single file.

/**
 * Return the address of a file of the runtime, named by its path there. In a page that is a single file, other files
 * are named "sitegen:" and their path in the site.
 * @param {string} name @returns {string}
 */
export function place(name) {
  /** @type {Record<string, string>} the files that single/start.js has unpacked */
  const inside = /** @type {any} */ (globalThis).sitegenFiles ?? {};
  return inside[name] ?? inside[`sitegen:runtime/${name}`] ?? new URL(name, import.meta.url).href;
}

/** Whether workers are module workers. In a single file, classic workers load the modules. */
export const moduleWorkers = !("sitegenFiles" in globalThis);

/** The address of the folder of the site's files; empty in a single file. */
export const siteFolder = moduleWorkers ? new URL("../", place("place.js")).href : "";
