// @ts-check
// The recordings of a page in the browser's storage.

/** @import { Ros } from "../protocol.js" */

const ROOT = "sitegen-bags";

/** The folder of this page's recordings: all sites of one origin share the storage. */
export function folderOfPage() {
  return encodeURIComponent(location.pathname).replaceAll("%", "_").slice(-200) || "page";
}

/** Return the recordings, the newest first; undefined if the browser has no storage for them. */
export async function listed() {
  try {
    const files = [];
    for await (const handle of (await folder()).values()) {
      if (handle.kind === "file") files.push(await handle.getFile());
    }
    return files.sort((a, b) => b.lastModified - a.lastModified);
  } catch {
    return undefined;
  }
}

/** Return the names of the recordings, also of those that are being written; none if the browser has no storage. */
export async function storedNames() {
  const names = [];
  try {
    for await (const name of (await folder()).keys()) names.push(name);
  } catch {
    return [];
  }
  return names.sort();
}

/** @param {string} name */
export async function stored(name) {
  return (await (await folder()).getFileHandle(name)).getFile();
}

/** @param {string} name */
export async function removed(name) {
  await (await folder()).removeEntry(name);
}

/** Whether recordings can get other names in this browser. */
export const renames = "FileSystemFileHandle" in globalThis && "move" in FileSystemFileHandle.prototype;

/** @param {string} name @param {string} other which no recording has */
export async function renamed(name, other) {
  const handle = await (await folder()).getFileHandle(name);
  await /** @type {FileSystemFileHandle & {move(name: string): Promise<void>}} */ (handle).move(other);
}

/**
 * Complete the recordings that were interrupted, and resolve with their names.
 * @param {Ros} ros @returns {Promise<string[]>}
 */
export function mended(ros) {
  return new Promise((resolve) => {
    const done = (/** @type {string[]} */ names) => {
      worker.leave();
      resolve(names);
    };
    const worker = ros.join("bag/bagNode", (message) => done(message.names ?? []), () => done([]));
    worker.tell({ op: "mend", folder: folderOfPage() });
  });
}

/** A name for a recording that begins now, as `ros2 bag record` has it. */
export function freshName() {
  const date = new Date();
  const two = (/** @type {number} */ number) => String(number).padStart(2, "0");
  const day = [date.getFullYear(), two(date.getMonth() + 1), two(date.getDate())].join("_");
  return `rosbag2_${day}-${[date.getHours(), date.getMinutes(), date.getSeconds()].map(two).join("_")}.mcap`;
}

async function folder() {
  const root = await navigator.storage.getDirectory();
  return (await root.getDirectoryHandle(ROOT, { create: true })).getDirectoryHandle(folderOfPage(), { create: true });
}
