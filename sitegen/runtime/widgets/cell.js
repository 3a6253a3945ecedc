// @ts-check
// A Python cell of a page: its source, which can be edited, a button that runs it, and its output.

import { kernelOf } from "../ui/kernel.js";
import { say } from "../ui/words.js";
import { CellView, PYTHON } from "./cell/view.js";

/** @import { Ros } from "../protocol.js" */
/** @import { Kernel } from "../ui/kernel.js" */
/** @import { Shown } from "./cell/output.js" */

/** @typedef {"none" | "waiting" | "running" | "ok" | "error" | "stale"} State */

// As tracebacks name cells.
const LINE = /File "<cell \d+>", line (\d+)/g;

/**
 * @param {HTMLElement} element
 * @param {Ros} ros
 * @param {{node: string, text: string, number: number, outputs?: Shown[]}} options `number` counts the cells of the
 *   page, `outputs` are those that its author saved
 * @returns {() => void} unmount
 */
export function mount(element, ros, { node: name, text, number, outputs = [] }) {
  const node = ros.nodes.get(name);
  if (!node) throw new Error(`cell: no node '${name}' on this page`);
  const cell = new Cell(element, ros, kernelOf(node), text, number);
  for (const one of outputs) cell.output.add(one);
  return () => {
    cell.close();
    element.replaceChildren();
  };
}

class Cell {
  #kernel;
  #number;
  /** @type {State} */
  #state = "none";
  #view;

  /** @param {HTMLElement} element @param {Ros} ros @param {Kernel} kernel @param {string} text @param {number} number */
  constructor(element, ros, kernel, text, number) {
    this.#kernel = kernel;
    this.#number = number;
    const source = {
      text, language: PYTHON, label: say("Python cell {}", number), runs: say("Run cell {}", number),
    };
    this.#view = new CellView(element, ros, source, {
      run: this.run, complete: () => this.#complete(),
      changed: () => {
        this.outdated();
        kernel.changed(number);
      },
    }, () => kernel.around);
    kernel.cells.set(number, this);
  }

  get output() {
    return this.#view.output;
  }

  outdated = () => {
    if (this.#state === "ok" || this.#state === "error") this.#show("stale");
  };

  forgotten = () => this.#show("none");

  close() {
    if (this.#kernel.cells.get(this.#number) === this) this.#kernel.cells.delete(this.#number);
    this.#view.close();
  }

  run = async () => {
    this.#view.begin();
    this.#show("waiting");
    const { output } = this.#view;
    output.clear();
    const outcome = await this.#kernel.run(this.#view.text, {
      starts: () => this.#show("running"),
      lines: (lines) => output.lines(lines),
      show: (data) => output.show(data),
    });
    output.end(outcome);
    const { traceback = [] } = outcome;
    // Without a traceback, Python has ended, which is told by forgotten().
    if (outcome.status === "ok" || traceback.length) this.#show(outcome.status);
    const [at] = [...traceback.join("\n").matchAll(LINE)].slice(-1);
    this.#view.mark(Number(at?.[1] ?? 0));
    this.#kernel.changed(this.#number);
    return outcome;
  };

  /** Complete the word before the cursor, as at the prompt. */
  async #complete() {
    const { text, at } = this.#view.cursor;
    const found = await this.#kernel.complete(text, at);
    // The visitor has typed on.
    if (!found || this.#view.cursor.at !== at || this.#view.cursor.text !== text) return;
    const { matches, start, end } = found;
    if (!matches.length) return;
    const common = matches.reduce(commonStart);
    if (common.length > end - start) this.#view.replace(start, end, common);
    const ends = matches.map((word) => word.slice(word.lastIndexOf(".") + 1));
    this.#view.tell(matches.length > 1 ? ends.join("  ") : "");
  }

  /** @param {State} state */
  #show(state) {
    this.#state = state;
    const text = {
      none: () => say("not run"),
      waiting: () => say("waiting"),
      running: () => say("running"),
      ok: () => say("done"),
      error: () => say("failed"),
      stale: () => say("outdated"),
    }[state]();
    this.#view.show(state, text, state === "stale" ? say("This cell or one above has changed since; run it again") : "");
  }
}

/** @param {string} a @param {string} b */
function commonStart(a, b) {
  let length = 0;
  while (length < a.length && a[length] === b[length]) length++;
  return a.slice(0, length);
}
