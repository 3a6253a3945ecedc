// @ts-check
// Diagnostic statuses by name, as a tree: "/Arm/Motors/left" and "arm: left motor" are paths.

import { LEVELS, levelOf, worse } from "./level.js";

/** @import { Level } from "./level.js" */

// A status without news for this long (ms) is stale, as in rqt_robot_monitor.
const STALE = 5000;
/** How many statuses are kept. */
export const MOST = 2000;
const DEEPEST = 12;
const MOST_VALUES = 500;

/**
 * @typedef {{level: Level, message: string, hardware: string, values: {key: string, value: string}[],
 *   received: number}} Status `received` in ms, of the page's clock
 * @typedef {{path: string, name: string, status: Status | undefined, level: Level, levels: Set<Level>,
 *   children: Map<string, Branch>}} Branch `level` is the worst of its status and of what it contains, `levels` are all
 */

export class StatusTree {
  /** @type {Map<string, Branch>} */
  #all = new Map();
  /** @type {Map<string, Branch>} */
  #roots = new Map();
  /** How many statuses have each level. @type {Record<Level, number>} */
  counts = { error: 0, stale: 0, warn: 0, ok: 0 };
  size = 0;
  /** Whether a status was left out. */
  full = false;

  get roots() {
    return this.#roots.values();
  }

  get paths() {
    return this.#all.keys();
  }

  /** @param {string} path */
  find(path) {
    return this.#all.get(path);
  }

  clear() {
    this.#all.clear();
    this.#roots.clear();
    this.size = 0;
    this.full = false;
  }

  /** @param {any[] | undefined} statuses of a message @param {number} received */
  add(statuses, received) {
    for (const { level, name, message, hardware_id: hardware, values } of statuses ?? []) {
      const branch = this.#branch(name);
      if (!branch) continue;
      if (!branch.status) this.size += 1;
      branch.status = { level: levelOf(level), message, hardware, values: values.slice(0, MOST_VALUES), received };
    }
  }

  /** Find which statuses are stale, and the levels of all branches. @param {number} now */
  grade(now) {
    for (const level of LEVELS) this.counts[level] = 0;
    for (const branch of this.#roots.values()) this.#grade(branch, now);
  }

  /** @param {Branch} branch @param {number} now */
  #grade(branch, now) {
    branch.levels.clear();
    const { status } = branch;
    if (status && now - status.received > STALE) status.level = "stale";
    branch.level = status?.level ?? "ok";
    if (status) {
      branch.levels.add(status.level);
      this.counts[status.level] += 1;
    }
    for (const child of branch.children.values()) {
      this.#grade(child, now);
      branch.level = worse(branch.level, child.level);
      for (const level of child.levels) branch.levels.add(level);
    }
  }

  /** Return the branch of a name, which is new if there is room. @param {string} name */
  #branch(name) {
    const parts = name.split(/[/:]/).map((part) => part.trim().slice(0, 200)).filter(Boolean).slice(0, DEEPEST);
    if (!parts.length) parts.push("?");
    const known = this.#all.get(parts.join("/"));
    if (!known?.status && this.size >= MOST) {
      this.full = true;
      return undefined;
    }
    let path = "";
    let level = this.#roots;
    /** @type {Branch | undefined} */
    let branch;
    for (const part of parts) {
      path = path ? `${path}/${part}` : part;
      branch = level.get(part);
      if (!branch) {
        branch = { path, name: part, status: undefined, level: "ok", levels: new Set(), children: new Map() };
        level.set(part, branch);
        this.#all.set(path, branch);
      }
      level = branch.children;
    }
    return branch;
  }
}
