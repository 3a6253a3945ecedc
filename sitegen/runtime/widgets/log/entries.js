// @ts-check
// The entries of the log, in chronological order and each only once.

export const LEVELS = /** @type {const} */ ([
  [10, "debug"],
  [20, "info"],
  [30, "warn"],
  [40, "error"],
  [50, "fatal"],
]);

/** @typedef {{time: number, level: number, severity: string, node: string, text: string, key: string}} Entry */

export class Entries {
  #limit;
  /** The keys of recent entries, also of those that were cleared. @type {Set<string>} */
  #known = new Set();
  /** @type {Entry[]} */
  list = [];

  /** @param {number} limit how many are kept */
  constructor(limit) {
    this.#limit = limit;
  }

  /**
   * Add an entry where it belongs, unless it was added before: each new subscription to /rosout receives the
   * latest entries again.
   * @param {Entry} entry @returns {"last" | "between" | undefined} where it was added
   */
  add(entry) {
    if (this.#known.has(entry.key)) return undefined;
    this.#known.add(entry.key);
    if (this.#known.size > 4 * this.#limit) this.#known.delete(this.#known.values().next().value ?? "");
    const at = this.list.findLastIndex(({ time }) => time <= entry.time) + 1;
    const place = at === this.list.length ? "last" : "between";
    this.list.splice(at, 0, entry);
    if (this.list.length > this.#limit) this.list.shift();
    return place;
  }

  clear() {
    this.list = [];
  }
}

/** @param {any} message rcl_interfaces/msg/Log @returns {Entry} */
export function readEntry({ stamp, level, name, msg: text }) {
  const severity = LEVELS.findLast(([least]) => level >= least)?.[1] ?? "debug";
  const time = stamp.sec * 1000 + stamp.nanosec / 1e6;
  return { time, level, severity, node: name, text, key: `${stamp.sec} ${stamp.nanosec} ${name} ${text}` };
}
