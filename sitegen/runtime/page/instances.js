// @ts-check
// Programs that run once more, as `ros2 run` starts them: new processes, which are gone when they end.

/** @import { NodeEntry } from "../protocol.js" */
/** @import { Graph } from "./graph.js" */
/** @import { NodeProcess } from "./nodeProcess.js" */

/** @typedef {string | {package: string, executable: string} | NodeEntry & {javascript: object}} Program */

// Each is a worker with memory of its own.
const MOST = 50;

export class Instances {
  #nodes;
  #graph;
  #add;
  /** @type {Set<string>} */
  #names = new Set();

  /**
   * @param {Map<string, NodeProcess>} nodes of the page, by name @param {Graph} graph
   * @param {(name: string, entry: NodeEntry) => NodeProcess} add adds a node to the page
   */
  constructor(nodes, graph, add) {
    this.#nodes = nodes;
    this.#graph = graph;
    this.#add = add;
  }

  /** Whether a node was started by `run`. @param {string} name */
  has(name) {
    return this.#names.has(name);
  }

  /**
   * Start a program of the page once more; see Ros in protocol.js. Throws an Error if the page has no such program.
   * @param {Program} program
   * @param {{arguments?: string[], name?: string, environment?: Record<string, string>}} [options]
   */
  run(program, { arguments: words = [], name: wanted, environment } = {}) {
    const { python, needs: _, ...entry } = this.#entryOf(program);
    if (this.#names.size >= MOST) throw new Error(`${MOST} programs run already`);
    const name = this.#free(wanted ?? entry.executable);
    // A launch file sets it for the node that it starts, not for the program.
    if (typeof program !== "string") delete entry.environment;
    if (environment) entry.environment = environment;
    // Beside the others of its group, its modules would be theirs.
    const alone = python && { ...python, group: undefined };
    const instance = this.#add(name, { ...entry, ...(alone && { python: alone }), arguments: words, autostart: false });
    this.#names.add(name);
    instance.quiet = true;
    instance.addEventListener("state", () => {
      if (instance.state === "stopped" || instance.state === "failed") this.#remove(name);
    });
    instance.start();
    this.#graph.dispatchEvent(new Event("change"));
    return instance;
  }

  /** @param {Program} program @returns {NodeEntry} */
  #entryOf(program) {
    if (/** @type {Partial<NodeEntry>} */ (program).javascript) return /** @type {NodeEntry} */ (program);
    const all = [...this.#nodes.values()].filter(({ name }) => !this.has(name));
    const node = typeof program === "string" ? this.#nodes.get(program) : all.find(
      (one) => one.package === program.package && one.executable === program.executable);
    if (node) return node.entry;
    const named = typeof program === "string" ? program : `${program.package}/${program.executable}`;
    throw new Error(`this page has no program ${named}`);
  }

  /** @param {string} name */
  #remove(name) {
    this.#nodes.delete(name);
    this.#names.delete(name);
    this.#graph.dispatchEvent(new Event("change"));
  }

  /** Return a name that no node of the page has. @param {string} wanted */
  #free(wanted) {
    for (let number = 1; ; number++) {
      const name = number === 1 ? wanted : `${wanted}-${number}`;
      if (!this.#nodes.has(name)) return name;
    }
  }
}
