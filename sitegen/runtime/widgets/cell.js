// @ts-check
// A Python cell of a page: its source, which can be edited, a button that runs it, and its output.

import { codeView, wrongLine } from "../ui/codeView.js";
import { button, create, setText } from "../ui/elements.js";
import { kernelOf } from "../ui/kernel.js";
import { say } from "../ui/words.js";
import { Output } from "./cell/output.js";

/** @import { Ros } from "../protocol.js" */
/** @import { Kernel } from "../ui/kernel.js" */
/** @import { Shown } from "./cell/output.js" */

/** @typedef {"none" | "waiting" | "running" | "ok" | "error" | "stale"} State */

// Check the syntax this long (ms) after the last key.
const PAUSE = 300;
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
  #original;
  #number;
  #text;
  #fromLink = false;
  /** @type {State} */
  #state = "none";
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #timer;
  #view;
  #label = create("span", "ros-cell-state");
  #note = create("p", "ros-cell-note");
  #reset = button(say("Reset"), "ros-clear", () => {
    this.#view.set(this.#original);
    this.#view.focus();
  });
  output;

  /** @param {HTMLElement} element @param {Ros} ros @param {Kernel} kernel @param {string} text @param {number} number */
  constructor(element, ros, kernel, text, number) {
    this.#kernel = kernel;
    this.#original = text;
    this.#text = text;
    this.#number = number;
    this.output = new Output(ros, () => kernel.around);
    ros.keep(element, { text: "string" }, () => ({ text: this.#changed ? this.#text : "" }), (state) => {
      this.#fromLink = true;
      this.#text = /** @type {string} */ (state.text ?? text);
    });
    for (const told of [this.#label, this.#note]) told.setAttribute("role", "status");
    const start = button(say("Run"), "ros-start", () => this.#run());
    start.setAttribute("aria-label", say("Run cell {}", number));
    start.title = say("Ctrl-Enter in the cell does the same");
    const side = create("div", "ros-controls ros-cell-side", this.#label, start, this.#reset);
    const code = create("div", "ros-code");
    element.replaceChildren(
      create("div", "ros-cell-input", side, create("div", "ros-cell-code", code, this.#note)), this.output.element);
    this.#view = codeView(code, this.#text, say("Python cell {}", number), (changed) => this.#typed(changed),
      () => this.#run(), () => this.#complete());
    this.#show("none");
    this.#check();
    kernel.cells.set(number, this);
  }

  run = () => this.#run();

  outdated = () => {
    if (this.#state === "ok" || this.#state === "error") this.#show("stale");
  };

  forgotten = () => this.#show("none");

  close() {
    clearTimeout(this.#timer);
    if (this.#kernel.cells.get(this.#number) === this) this.#kernel.cells.delete(this.#number);
    this.output.clear();
    this.#view.destroy();
  }

  get #changed() {
    return this.#text !== this.#original;
  }

  async #run() {
    this.#fromLink = false;
    this.#tell("");
    this.#show("waiting");
    this.output.clear();
    const { output } = this;
    const outcome = await this.#kernel.run(this.#text, {
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
  }

  /** @param {string} text the new content */
  #typed(text) {
    this.#text = text;
    this.#tell("");
    this.outdated();
    this.#kernel.changed(this.#number);
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => this.#check(), PAUSE);
  }

  /** Mark the first syntax error. */
  #check() {
    const line = wrongLine(this.#text);
    this.#view.mark(line);
    const foreign = this.#fromLink && this.#changed ? say("changed by the link: read it before you run it") : "";
    this.#tell(line ? say("syntax error in line {}", line) : foreign);
  }

  /** Complete the word before the cursor, as at the prompt. */
  async #complete() {
    const { text, at } = this.#view.cursor();
    const found = await this.#kernel.complete(text, at);
    // The visitor has typed on.
    if (!found || this.#view.cursor().at !== at || this.#view.cursor().text !== text) return;
    const { matches, start, end } = found;
    if (!matches.length) return;
    const common = matches.reduce(commonStart);
    if (common.length > end - start) this.#view.replace(start, end, common);
    const ends = matches.map((word) => word.slice(word.lastIndexOf(".") + 1));
    this.#tell(matches.length > 1 ? ends.join("  ") : "");
  }

  /** @param {string} note */
  #tell(note) {
    setText(this.#note, note);
    this.#note.hidden = !note;
    this.#reset.hidden = !this.#changed;
  }

  /** @param {State} state */
  #show(state) {
    this.#state = state;
    this.#label.dataset.state = state;
    setText(this.#label, {
      none: () => say("not run"),
      waiting: () => say("waiting"),
      running: () => say("running"),
      ok: () => say("done"),
      error: () => say("failed"),
      stale: () => say("outdated"),
    }[state]());
    this.#label.title = state === "stale" ? say("This cell or one above has changed since; run it again") : "";
  }
}

/** @param {string} a @param {string} b */
function commonStart(a, b) {
  let length = 0;
  while (length < a.length && a[length] === b[length]) length++;
  return a.slice(0, length);
}
