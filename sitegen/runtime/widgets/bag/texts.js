// @ts-check
// Names, times, sizes and numbers of bags as visitors read them.

import { say } from "../../ui/words.js";

export const SUFFIX = ".mcap";

/** The name of a bag without that of its format. @param {string} name of its file */
export function plainName(name) {
  return name.endsWith(SUFFIX) ? name.slice(0, -SUFFIX.length) : name;
}

/** A time such as 1:02.3. @param {number} seconds */
export function clockText(seconds) {
  // Tenths are cut off, so that no time is shown before it has come.
  const tenths = Math.floor(seconds * 10 + 1e-6);
  const [minutes, rest] = [Math.floor(tenths / 600), tenths % 600];
  const hours = Math.floor(minutes / 60);
  const end = `${String(Math.floor(rest / 10)).padStart(2, "0")}.${rest % 10}`;
  return hours ? `${hours}:${String(minutes % 60).padStart(2, "0")}:${end}` : `${minutes}:${end}`;
}

/** @param {number} bytes */
export function sizeText(bytes) {
  if (bytes >= 1e6) return `${(bytes / 1e6).toFixed(bytes >= 1e8 ? 0 : 1)} MB`;
  return bytes >= 1000 ? `${(bytes / 1000).toFixed(1)} kB` : `${bytes} B`;
}

/** @param {number} count */
export function countText(count) {
  return count === 1 ? say("1 message") : say("{} messages", count.toLocaleString(document.documentElement.lang || undefined));
}
