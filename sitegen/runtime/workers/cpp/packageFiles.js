// @ts-check
// The files that packages install to share/, for programs that open files. A program has their names and sizes from the
// start, and their contents when it opens them.

import { place } from "../../place.js";

/** @import { Printer } from "../printer.js" */
/** @typedef {Record<string, [size: number, hash: string]>} Listing by path below ROOT; see nodes/share.py */
/**
 * A file in the file system of Emscripten, whose content is missing as long as it has an `address`.
 * @typedef {{usedBytes: number, contents: Uint8Array | null, path?: string, address?: string}} File
 */

const ROOT = "/ros";
/** As the C library numbers it. */
const EIO = 29;
const INSIDE = "sitegen:"; // a page that is a single file

export class PackageFiles {
  #listing;
  #address;
  #wake;
  #printer;
  /** What is being loaded, and why files could not be loaded. @type {Map<File, string>} */
  #loading = new Map();

  /**
   * @param {Listing} listing
   * @param {string} address of the listing, beside which the files are
   * @param {() => void} wake ends the waits of the program
   * @param {Printer} printer
   */
  constructor(listing, address, wake, printer) {
    this.#listing = listing;
    this.#address = address;
    this.#wake = wake;
    this.#printer = printer;
  }

  /**
   * Load the listing at an address.
   * @param {string} address @param {() => void} wake @param {Printer} printer
   */
  static async listedAt(address, wake, printer) {
    try {
      return new PackageFiles(await (await loaded(place(address))).json(), address, wake, printer);
    } catch (error) {
      throw new Error(`the list of the files of packages could not be loaded: ${textOf(error)}`);
    }
  }

  /** Put the files into the file system of a program that has not begun. @param {any} fileSystem */
  mount(fileSystem) {
    for (const [path, [size, hash]] of Object.entries(this.#listing)) {
      const name = `${ROOT}/${path}`;
      if (fileSystem.analyzePath(name).exists) continue; // made by the build of the package
      fileSystem.mkdirTree(name.slice(0, name.lastIndexOf("/")));
      /** @type {File} */
      const file = fileSystem.create(name, 0o644);
      if (size) Object.assign(file, { usedBytes: size, path: name, address: this.#addressOf(path, hash) });
    }
  }

  /** @param {string} path @param {string} hash */
  #addressOf(path, hash) {
    const folder = this.#address.slice(0, this.#address.lastIndexOf("/") + 1);
    if (folder.startsWith(INSIDE)) return place(`${folder}${path}.bin`);
    return `${folder}${path.split("/").map(encodeURIComponent).join("/")}.bin?v=${hash}`;
  }

  /**
   * Return what ros_open of host.h says of a file: 0 if it can be opened, 1 while it is loaded, or an error.
   * @param {File} file @param {number} truncated
   */
  open(file, truncated) {
    if (!file.address) return 0;
    if (truncated) {
      delete file.address;
      return 0;
    }
    const error = this.#loading.get(file);
    if (error === undefined) this.#load(file, file.address);
    if (!error) return 1;
    this.#loading.delete(file); // the next time, it may be reached
    return -EIO;
  }

  /** @param {File} file @param {string} address */
  async #load(file, address) {
    this.#loading.set(file, "");
    try {
      const content = new Uint8Array(await (await loaded(address)).arrayBuffer());
      Object.assign(file, { contents: content, usedBytes: content.length });
      delete file.address;
      this.#loading.delete(file);
    } catch (error) {
      const why = textOf(error);
      this.#loading.set(file, why);
      this.#printer.print("stderr", `${file.path}: ${why}`);
    }
    this.#wake();
  }
}

/** @param {unknown} error */
const textOf = (error) => (error instanceof Error ? error.message : String(error));

/** @param {string} address */
async function loaded(address) {
  const response = await fetch(address);
  if (!response.ok) throw new Error(`the server answered ${response.status}`);
  return response;
}
