// @ts-check
// The definitions of all interfaces of ROS and of the workspace: a page has those that its nodes use, and a terminal
// loads the others when a command first needs them.

import { place } from "../place.js";

/** @import { MessageType } from "../protocol.js" */
/**
 * The addresses of files: the definitions of all interfaces, their texts, and the hashes of types.
 * @typedef {{interfaces: string, texts: string, hashes: string}} Files
 */

export class Interfaces {
  #types;
  #files;
  /** @type {Promise<void> | undefined} */
  #loading;
  /** What was read, by address. @type {Map<string, Promise<Record<string, string>>>} */
  #read = new Map();

  /** @param {Record<string, MessageType>} types of the page, which get the others @param {Files} files */
  constructor(types, files) {
    this.#types = types;
    this.#files = files;
  }

  /** Load the definitions, unless they are there. Without a connection, those of the nodes remain. */
  load() {
    this.#loading ??= fetched(this.#files.interfaces).then((found) => {
      for (const [name, type] of Object.entries(found)) this.#types[name] ??= type;
    }).catch((error) => {
      this.#loading = undefined;
      console.warn(error);
    });
    return this.#loading;
  }

  /** Return the text of the file of an interface, if it has one. @param {string} name */
  async text(name) {
    const texts = await this.#once(this.#files.texts);
    return Object.hasOwn(texts, name) ? texts[name] : undefined;
  }

  /** Return the hashes of types, by name. Pages that only use interfaces do not need them. */
  hashes() {
    return this.#once(this.#files.hashes);
  }

  /** Read a file, unless it was read. @param {string} file @returns {Promise<Record<string, string>>} */
  #once(file) {
    const reading = this.#read.get(file) ?? fetched(file).catch((error) => {
      this.#read.delete(file);
      console.warn(error);
      return {};
    });
    this.#read.set(file, reading);
    return reading;
  }
}

/** @param {string} file as page.json names it @returns {Promise<any>} */
async function fetched(file) {
  const page = /** @type {HTMLLinkElement | null} */ (document.getElementById("ros-page"));
  const response = await fetch(file.startsWith("sitegen:") ? place(file) : new URL(file, page?.href ?? location.href));
  if (!response.ok) throw new Error(`${file}: ${response.status}`);
  return response.json();
}
