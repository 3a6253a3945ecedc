// @ts-check
// The files of bags: of the site, of the visitor, and recordings in the origin private file system, each in the folder
// of its page.

import { decompressors } from "../../bag/compression.js";
import { salvaged } from "../../bag/salvage.js";
import { fromBlob, fromUrl } from "../../bag/source.js";

/** @import { Source } from "../../bag/orders.js" */

export const ROOT = "sitegen-bags";
// How long a file may be locked by a tab that is being closed, and how often that is tried (ms).
const CLOSING = 3000;
const AGAIN = 100;
// Without a file, what is written is handed to the browser in pieces of this size (bytes), and does not fill memory.
const PIECE = 32 * 1024 * 1024;
const FOOTER = [0x89, 0x4d, 0x43, 0x41, 0x50, 0x30, 0x0d, 0x0a];

/** @param {string} folder */
export async function folderOf(folder) {
  const root = await navigator.storage.getDirectory();
  const bags = await root.getDirectoryHandle(ROOT, { create: true });
  return bags.getDirectoryHandle(folder, { create: true });
}

/** @param {string} folder @param {string} name */
export async function fileOf(folder, name) {
  return (await (await folderOf(folder)).getFileHandle(name)).getFile();
}

/** @param {Source} source */
export async function readableOf(source) {
  if ("url" in source) return fromUrl(source.url);
  return fromBlob("blob" in source ? source.blob : await fileOf(source.folder, source.stored));
}

/**
 * Complete the recordings that were interrupted, and return their names; those without messages are removed. One that
 * another tab still writes is left alone.
 * @param {string} folder
 */
export async function mend(folder) {
  const names = [];
  const here = await folderOf(folder);
  for await (const handle of here.values()) {
    if (handle.kind !== "file") continue;
    const file = await handle.getFile();
    if (await isComplete(file.size, async (at) => file.slice(at).arrayBuffer())) continue;
    // One that cannot be mended stays as it is, and is played as far as it goes.
    const state = await mendFile(handle).catch(() => "left");
    if (state === "mended") names.push(handle.name);
    if (state === "empty") await here.removeEntry(handle.name);
  }
  return names;
}

/**
 * Whether a recording has its end.
 * @param {number} size @param {(at: number) => Promise<ArrayBuffer>} rest reads the file from an offset to its end
 */
async function isComplete(size, rest) {
  if (size <= 2 * FOOTER.length) return false;
  const end = new Uint8Array(await rest(size - FOOTER.length));
  return FOOTER.every((byte, index) => end[index] === byte);
}

/** @param {FileSystemFileHandle} handle @returns {Promise<"mended" | "empty" | "left">} */
async function mendFile(handle) {
  const access = await unlocked(handle);
  if (!access) return "left";
  try {
    // Not through the handle's file: while it is open for writing, browsers may not read it.
    const size = access.getSize();
    const read = (/** @type {number} */ at, /** @type {number} */ length) => {
      const part = new Uint8Array(length);
      access.read(part, { at });
      return part;
    };
    // The tab that wrote it may have ended it in the meantime, and saves it now.
    if (await isComplete(size, async (at) => read(at, size - at).buffer)) return "left";
    const bytes = {
      size: async () => BigInt(size),
      read: async (/** @type {bigint} */ offset, /** @type {bigint} */ length) => read(Number(offset), Number(length)),
    };
    const { length, tail, empty } = await salvaged(bytes, await decompressors());
    if (empty) return "empty";
    if (!tail) return "left";
    access.truncate(length);
    access.write(tail, { at: length });
    access.flush();
    return "mended";
  } finally {
    access.close();
  }
}

/** Open a file that no tab writes, or one whose tab is being closed; undefined if another tab goes on writing it. */
async function unlocked(/** @type {FileSystemFileHandle} */ handle) {
  for (let waited = 0; waited < CLOSING; waited += AGAIN) {
    try {
      return await handle.createSyncAccessHandle();
    } catch {
      await new Promise((resolve) => setTimeout(resolve, AGAIN));
    }
  }
  return undefined;
}

/** Where a bag is written: a file, or the browser's memory for blobs. */
export class Target {
  /** @type {FileSystemSyncAccessHandle | undefined} */
  #access;
  #position = 0;
  /** @type {Blob[]} */
  #pieces = [];
  /** What is not in a piece yet. @type {Uint8Array<ArrayBuffer>[]} */
  #parts = [];
  #size = 0;

  /** @param {FileSystemSyncAccessHandle} [access] */
  constructor(access) {
    this.#access = access;
  }

  /** @param {string} folder @param {string} name */
  static async open(folder, name) {
    try {
      const handle = await (await folderOf(folder)).getFileHandle(name, { create: true });
      return new Target(await handle.createSyncAccessHandle());
    } catch {
      return new Target();
    }
  }

  /** Whether what is written stays when the page is closed. */
  get kept() {
    return this.#access !== undefined;
  }

  /** @param {Uint8Array} bytes */
  write(bytes) {
    if (!this.#access) {
      this.#parts.push(new Uint8Array(bytes));
      this.#size += bytes.length;
      if (this.#size >= PIECE) this.#hand();
      return;
    }
    const written = this.#access.write(bytes, { at: this.#position });
    if (written < bytes.length) throw new DOMException("there is no more space", "QuotaExceededError");
    this.#position += written;
  }

  /** End it, and return its content if it is in no file. */
  close() {
    this.#access?.flush();
    this.#access?.close();
    if (this.kept) return undefined;
    this.#hand();
    return new Blob(this.#pieces, { type: "application/octet-stream" });
  }

  #hand() {
    this.#pieces.push(new Blob(this.#parts));
    this.#parts = [];
    this.#size = 0;
  }
}
