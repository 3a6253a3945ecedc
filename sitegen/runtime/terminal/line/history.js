// @ts-check
// The lines that were entered, kept by the browser for the site, and recalled with the arrow keys.

const LENGTH = 500;
const KEY = "sitegen:terminal-history";

export class History {
  /** @type {string[]} */
  lines = read();
  #at = this.lines.length;
  #draft = "";

  /** Append a line, unless it is blank or repeats the last one. @param {string} text */
  add(text) {
    // Other tabs may have added lines. The array stays the same one.
    const all = merged(read(), this.lines);
    if (text.trim() && text !== all.at(-1)) all.push(text);
    this.lines.splice(0, Infinity, ...all.slice(-LENGTH));
    this.#at = this.lines.length;
    try {
      localStorage.setItem(KEY, JSON.stringify(this.lines));
    } catch {
      // A frame without storage, or a full one: the history ends with the page.
    }
  }

  /** Return the line `step` away from the one shown, or undefined at either end. @param {number} step @param {string} draft */
  recall(step, draft) {
    const to = Math.min(Math.max(this.#at + step, 0), this.lines.length);
    if (to === this.#at) return undefined;
    if (this.#at === this.lines.length) this.#draft = draft;
    this.#at = to;
    return this.lines[to] ?? this.#draft;
  }

  /** Return the latest line that contains a text, before `skipped` others of these. @param {string} text @param {number} [skipped] */
  find(text, skipped = 0) {
    if (!text) return undefined;
    return [...new Set(this.lines.toReversed())].filter((line) => line.includes(text))[skipped];
  }
}

/** Append the lines that only this tab has. @param {string[]} stored @param {string[]} own */
function merged(stored, own) {
  const known = new Set(stored);
  return [...stored, ...own.filter((line) => !known.has(line))];
}

/** @returns {string[]} */
function read() {
  try {
    const found = JSON.parse(localStorage.getItem(KEY) ?? "[]");
    return Array.isArray(found) ? found.filter((line) => typeof line === "string").slice(-LENGTH) : [];
  } catch {
    return [];
  }
}
