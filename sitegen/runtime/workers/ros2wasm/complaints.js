// @ts-check
// Report the errors of a script in the console of its node, each once.

// The largest number of reports, so that a script cannot fill the console.
const MOST = 50;

export class Complaints {
  #tell;
  /** @type {Set<string>} */
  #told = new Set();

  /** @param {(text: string) => void} tell */
  constructor(tell) {
    this.#tell = tell;
  }

  /** Report `text`, unless there was a report about `what` before. @param {string} what @param {string} text */
  add(what, text) {
    if (this.#told.has(what) || this.#told.size > MOST) return;
    this.#told.add(what);
    this.#tell(this.#told.size > MOST ? "further errors of this script are not shown" : text);
  }
}

/** Return a short description of a value that a script sent. @param {unknown} value */
export function shown(value) {
  if (typeof value === "object" && value) return Array.isArray(value) ? "a list" : "an object";
  const line = String(value).replace(/[\x00-\x1f\x7f]/g, " ");
  return line.length > 60 ? `${line.slice(0, 60)}…` : line;
}
