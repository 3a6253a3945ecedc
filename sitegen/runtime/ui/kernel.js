// @ts-check
// The interpreter that the cells of a page share: it runs them one at a time, in the order in which they were started.

/** @import { Line, NodeHandle } from "../protocol.js" */

/**
 * What a running cell is told: that it `starts`, `lines` that the program printed, `shown` values by media type (images
 * in base64).
 * @typedef {{starts(): void, lines(lines: Line[]): void, show(data: Record<string, string>): void}} Output
 * @typedef {{status: "ok" | "error", traceback?: string[]}} Outcome
 * @typedef {{code: string, output: Output, done(outcome: Outcome): void}} Request
 *
 * What can replace a part of a cell's text, and where this part is.
 * @typedef {{matches: string[], start: number, end: number}} Completion
 *
 * A cell of the page: `run` runs it, `outdated` tells it that a cell above has changed, `forgotten` that its variables
 * are gone.
 * @typedef {{run(): Promise<Outcome>, outdated(): void, forgotten(): void}} Cell
 */

// Requests other than cells have numbers above it.
const RUN = 1;

/** @type {WeakMap<NodeHandle, Kernel>} */
const kernels = new WeakMap();

/** Return the kernel that runs in `node`. @param {NodeHandle} node */
export function kernelOf(node) {
  const known = kernels.get(node) ?? new Kernel(node);
  kernels.set(node, known);
  return known;
}

export class Kernel {
  /** The cells of the page by their number. @type {Map<number, Cell>} */
  cells = new Map();
  node;
  /** What panels below cells need besides the graph. @type {{interfaces?: string, resources?: Record<string, string>}} */
  around = {};
  /** @type {Request[]} */
  #waiting = [];
  /** @type {Request | undefined} */
  #running;
  #ready = false;
  /** Questions that are not answered yet, by number. @type {Map<number, (content: any) => void>} */
  #asked = new Map();
  #last = RUN;

  /** @param {NodeHandle} node */
  constructor(node) {
    this.node = node;
    node.addEventListener("answer", (event) => {
      this.#take(JSON.parse(/** @type {CustomEvent<{text: string}>} */ (event).detail.text));
    });
    node.addEventListener("lines", (event) => {
      this.#running?.output.lines(/** @type {CustomEvent<Line[]>} */ (event).detail);
    });
    node.addEventListener("state", () => {
      if (node.state !== "running") this.#ready = false;
      if (node.state === "stopped" || node.state === "failed") this.#end();
    });
  }

  /**
   * Run a cell after those that wait, and start Python if it does not run.
   * @param {string} code @param {Output} output
   */
  run(code, output) {
    /** @type {Promise<Outcome>} */
    const outcome = new Promise((resolve) => this.#waiting.push({ code, output, done: resolve }));
    this.node.start();
    this.#next();
    return outcome;
  }

  /** Run all cells, until one fails. @param {number} count of the cells, which may come after the button, in any order */
  async runAll(count) {
    while (this.cells.size < count) await new Promise(requestAnimationFrame);
    for (const { run } of this.#inOrder(0)) {
      if ((await run()).status === "error") return;
    }
  }

  /** Tell the cells below that a cell has changed. @param {number} number of this cell */
  changed(number) {
    for (const cell of this.#inOrder(number)) cell.outdated();
  }

  /**
   * Ask what can follow at a place in a cell. There is no answer while a cell runs, or Python does not.
   * @param {string} code @param {number} at @returns {Promise<Completion | undefined>}
   */
  async complete(code, at) {
    if (!this.#ready || this.#running) return undefined;
    const id = ++this.#last;
    return new Promise((resolve) => {
      this.#asked.set(id, resolve);
      this.#send({ op: "complete", id, code, at });
    });
  }

  /** Start Python again, without the variables. */
  restart() {
    // Stop alone is an interrupt, which does not end a kernel.
    this.#send({ op: "end" });
    this.node.restart();
  }

  /** The cells below a number. @param {number} number */
  #inOrder(number) {
    return [...this.cells].filter(([one]) => one > number).sort(([one], [other]) => one - other).map(([, cell]) => cell);
  }

  #next() {
    if (!this.#ready || this.#running) return;
    this.#running = this.#waiting.shift();
    if (!this.#running) return;
    this.#running.output.starts();
    this.#send({ op: "run", id: RUN, code: this.#running.code });
  }

  /** @param {object} request */
  #send(request) {
    this.node.type({ op: "ask", text: JSON.stringify(request) });
  }

  /** @param {{op: string, id?: number, content?: any, data?: Record<string, string>}} answer */
  #take({ op, id = 0, content, data }) {
    if (op === "ready") {
      this.#ready = true;
      this.#send({ op: "at", address: document.baseURI });
      this.#next();
    } else if (op === "done" && id === RUN) {
      const running = this.#running;
      this.#running = undefined;
      running?.done(content);
      this.#next();
    } else if (op === "done") {
      this.#asked.get(id)?.(content);
      this.#asked.delete(id);
    } else if (data) {
      this.#running?.output.show(data);
    }
  }

  /** Python has ended: nothing that runs or waits will be answered, and the variables are gone. */
  #end() {
    const left = [...(this.#running ? [this.#running] : []), ...this.#waiting.splice(0)];
    this.#running = undefined;
    for (const { done } of left) done({ status: "error", traceback: [] });
    for (const answer of this.#asked.values()) answer(undefined);
    this.#asked.clear();
    for (const { forgotten } of this.cells.values()) forgotten();
  }
}
