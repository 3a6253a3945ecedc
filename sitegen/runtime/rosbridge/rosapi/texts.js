// @ts-check
// The files that define interfaces, with their comments; a client that asks for them loads them.

import { Interfaces } from "../../terminal/interfaces.js";

/** @import { PageEntry } from "../../protocol.js" */

/** @type {Promise<Interfaces | undefined> | undefined} */
let loading;

/**
 * Return the text of the file of each of these types, if there is one.
 * @param {string[]} types @returns {Promise<Record<string, string | undefined>>}
 */
export async function textsOf(types) {
  loading ??= loaded();
  const files = await loading;
  return Object.fromEntries(await Promise.all(types.map(async (type) => [type, await files?.text(type)])));
}

async function loaded() {
  const page = /** @type {HTMLLinkElement | null} */ (globalThis.document?.getElementById("ros-page"));
  if (!page) return undefined;
  try {
    /** @type {PageEntry} */
    const { texts } = await (await fetch(page.href)).json();
    return texts ? new Interfaces({}, { interfaces: "", texts, hashes: "" }) : undefined;
  } catch (error) {
    // Without a connection, the fields and constants are known all the same.
    console.warn(error);
    loading = undefined;
    return undefined;
  }
}
