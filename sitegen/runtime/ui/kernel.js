// @ts-check
// The interpreter that the cells of a page share: it runs them one at a time, in the order in which they were started.

/** @import { Line, NodeHandle } from "../protocol.js" */

/**
 * What a running cell is told: `lines` that the program printed, `shown` values by media type (images in base64).
 * @typedef {{lines(lines: Line[]): void, show(data: Record<string, string>): void}} Output
 * @typedef {{status: "ok" | "error", traceback?: string[]}} Outcome
 * @typedef {{code: string, output: Output, done(outcome: Outcome): void}} Request
 */

/** @type {WeakMap<NodeHandle, Kernel>} */
const kernels = new WeakMap();

/** Return the kernel that runs in `node`. @param {NodeHandle} node */
export function kernelOf(node) {
  const known = kernels.get(node) ?? new Kernel(node);
  kernels.set(node, known);
  return known;
}

export class Kernel {
  /** The cells of the page by their number, each as a function that runs it. @type {Map<number, () => Promise<Outcome>>} */
  cells = new Map();
  node;
  /** @type {Request[]} */
  #waiting = [];
  /** @type {Request | undefined} */
  #running;
  #ready = false;

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
    for (const [, run] of [...this.cells].sort(([one], [other]) => one - other)) {
      if ((await run()).status === "error") return;
    }
  }

  /** Start Python again, without the variables. */
  restart() {
    // Stop alone is an interrupt, which does not end a kernel.
    this.node.type({ op: "ask", text: JSON.stringify({ op: "end" }) });
    this.node.restart();
  }

  #next() {
    if (!this.#ready || this.#running || !this.#waiting.length) return;
    this.#running = this.#waiting.shift();
    const request = { op: "run", id: 1, code: this.#running?.code };
    this.node.type({ op: "ask", text: JSON.stringify(request) });
  }

  /** @param {{op: string, content?: Outcome, data?: Record<string, string>}} answer */
  #take({ op, content, data }) {
    if (op === "ready") {
      this.#ready = true;
      this.#next();
    } else if (op === "done" && content) {
      const running = this.#running;
      this.#running = undefined;
      running?.done(content);
      this.#next();
    } else if (data) {
      this.#running?.output.show(data);
    }
  }

  /** Python has ended: nothing that runs or waits will be answered. */
  #end() {
    const left = [...(this.#running ? [this.#running] : []), ...this.#waiting.splice(0)];
    this.#running = undefined;
    for (const { done } of left) done({ status: "error", traceback: [] });
  }
}
