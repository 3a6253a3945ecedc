// @ts-check
// The bags that a terminal knows by name: those of the site that the page plays, and recordings of this browser.

import { sourceAt } from "../bag/address.js";
import { folderOfPage, mended, removed, stored, storedNames } from "../bag/store.js";
import { Failure } from "./shell/shell.js";

/** @import { Source } from "../bag/orders.js" */
/** @import { Ros } from "../protocol.js" */

export class Bags {
  #ros;
  #site;
  /** Recordings that are only in memory. @type {Map<string, Blob>} */
  #loose = new Map();
  #mended = false;

  /** @param {Ros} ros @param {Record<string, string>} site addresses by the path that the author wrote */
  constructor(ros, site) {
    this.#ros = ros;
    this.#site = new Map(Object.entries(site));
  }

  /** The names of all bags. */
  async names() {
    return [...this.#site.keys(), ...(await this.recordings())];
  }

  /** The names of the recordings, with `.mcap`. */
  async recordings() {
    return [...this.#loose.keys(), ...(await storedNames())];
  }

  /**
   * Return a bag by its path, its file name, or either without `.mcap`; undefined if there is none.
   * @param {string} given @returns {Promise<{name: string, source: Source} | undefined>}
   */
  async find(given) {
    const wanted = given.replace(/^\.\//, "").replace(/\/+$/, "");
    const fits = (/** @type {string} */ name) => name === wanted || name === `${wanted}.mcap`;
    for (const fitting of [fits, (/** @type {string} */ path) => fits(path.split("/").at(-1) ?? "")]) {
      const path = [...this.#site.keys()].find(fitting);
      if (path !== undefined) return { name: path, source: await sourceAt(this.#site.get(path) ?? "") };
    }
    const name = (await this.recordings()).find(fits);
    if (name === undefined) return undefined;
    const blob = this.#loose.get(name);
    if (blob) return { name, source: { blob } };
    await this.#mend();
    return { name, source: { stored: name, folder: folderOfPage() } };
  }

  /** Return the file of a recording; undefined if there is none of this name. @param {string} name */
  async file(name) {
    const loose = this.#loose.get(name);
    if (loose || !(await storedNames()).includes(name)) return loose;
    await this.#mend();
    return stored(name);
  }

  /** Keep a recording that the browser has no storage for. @param {string} name @param {Blob} blob */
  add(name, blob) {
    this.#loose.set(name, blob);
  }

  /** Delete a recording, and return whether there was one of this name. @param {string} name */
  async remove(name) {
    if (this.#loose.delete(name)) return true;
    if (!(await storedNames()).includes(name)) return false;
    await removed(name).catch(() => {
      throw new Failure(`rm: cannot remove '${name}': It is being recorded or played`);
    });
    return true;
  }

  /** Complete recordings that an earlier visit did not end. */
  async #mend() {
    if (this.#mended) return;
    this.#mended = true;
    await mended(this.#ros);
  }
}
