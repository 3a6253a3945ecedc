// @ts-check
// The definitions of all interfaces of ROS and of the workspace: a page has those that its nodes use, and a terminal
// loads the others when a command first needs them.

import { place } from "../place.js";

/** @import { MessageType } from "../protocol.js" */

export class Interfaces {
  #types;
  #file;
  #textsFile;
  /** @type {Promise<void> | undefined} */
  #loading;
  /** @type {Promise<Record<string, string>> | undefined} */
  #texts;
  /** The hashes of types, by name. @type {Record<string, string>} */
  hashes = {};

  /** @param {Record<string, MessageType>} types of the page, which get the others @param {string} file @param {string} texts */
  constructor(types, file, texts) {
    this.#types = types;
    this.#file = file;
    this.#textsFile = texts;
  }

  /** Load the definitions, unless they are there. Without a connection, those of the nodes remain. */
  load() {
    this.#loading ??= this.#read().catch((error) => {
      this.#loading = undefined;
      console.warn(error);
    });
    return this.#loading;
  }

  async #read() {
    const found = await fetched(this.#file);
    for (const [name, { hash, ...type }] of Object.entries(found)) {
      if (hash) this.hashes[name.replace(/_Request$/, "")] = hash;
      this.#types[name] ??= type;
    }
  }

  /** Return the text of the file of an interface, if it has one. @param {string} name */
  async text(name) {
    this.#texts ??= fetched(this.#textsFile).catch((error) => {
      this.#texts = undefined;
      console.warn(error);
      return {};
    });
    const texts = await this.#texts;
    return Object.hasOwn(texts, name) ? texts[name] : undefined;
  }
}

/** @param {string} file as page.json names it @returns {Promise<any>} */
async function fetched(file) {
  const page = /** @type {HTMLLinkElement | null} */ (document.getElementById("ros-page"));
  const response = await fetch(file.startsWith("sitegen:") ? place(file) : new URL(file, page?.href ?? location.href));
  if (!response.ok) throw new Error(`${file}: ${response.status}`);
  return response.json();
}
