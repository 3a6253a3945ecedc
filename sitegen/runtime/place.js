// @ts-check
// Where the site's files are: on its server, or inside of a page that is a single file.

/**
 * The address of a file. One of the runtime is named by its path there; in a page that is a single file,
 * all are named "sitegen:" and their path in the site.
 * @param {string} name @returns {string}
 */
export function place(name) {
  /** @type {Record<string, string>} what the page has unpacked: see single/start.js */
  const inside = /** @type {any} */ (globalThis).sitegenFiles ?? {};
  return inside[name] ?? inside[`sitegen:runtime/${name}`] ?? new URL(name, import.meta.url).href;
}

/** Whether workers are modules; those of a single file load theirs. */
export const moduleWorkers = !("sitegenFiles" in globalThis);
