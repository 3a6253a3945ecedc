// @ts-check
// The lines that were entered, kept while the tab is open, and recalled with the arrow keys.

const LENGTH = 500;
const KEY = "sitegen:terminal-history";

export class History {
  /** @type {string[]} */
  lines = read();
  #at = this.lines.length;
  #draft = "";

  /** Append a line, unless it is blank or repeats the last one. @param {string} text */
  add(text) {
    if (text.trim() && text !== this.lines.at(-1)) this.lines.push(text);
    this.lines.splice(0, this.lines.length - LENGTH);
    this.#at = this.lines.length;
    try {
      sessionStorage.setItem(KEY, JSON.stringify(this.lines));
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

  /** Return the latest line that contains a text. @param {string} text */
  find(text) {
    return text ? this.lines.findLast((line) => line.includes(text)) : undefined;
  }
}

/** @returns {string[]} */
function read() {
  try {
    const found = JSON.parse(sessionStorage.getItem(KEY) ?? "[]");
    return Array.isArray(found) ? found.filter((line) => typeof line === "string").slice(-LENGTH) : [];
  } catch {
    return [];
  }
}
