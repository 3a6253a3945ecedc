// @ts-check
// Bags of the site, by the address that page.json has.

import { place } from "../place.js";

/** @import { Source } from "./orders.js" */

/** @param {string} file @returns {Promise<Source>} */
export async function sourceAt(file) {
  // In a page that is a single file, the bag is in it, too, where no worker reaches it.
  if (file.startsWith("sitegen:")) return { blob: await (await fetch(place(file))).blob() };
  const page = /** @type {HTMLLinkElement | null} */ (document.getElementById("ros-page"));
  return { url: new URL(file, page?.href ?? location.href).href };
}
