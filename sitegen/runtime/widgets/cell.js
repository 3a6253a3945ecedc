// @ts-check
// A Python cell of a page: its source, which can be edited, a button that runs it, and its output.

import { codeView } from "../ui/codeView.js";
import { button, create, setText } from "../ui/elements.js";
import { kernelOf } from "../ui/kernel.js";
import { say } from "../ui/words.js";

/** @import { Line, Ros } from "../protocol.js" */
/** @import { Outcome } from "../ui/kernel.js" */

/**
 * @typedef {{kind: "stdout" | "stderr" | "error", text: string}
 *   | {kind: "value", data: Record<string, string>}} Shown
 */

// What is shown of an image, by media type; other types are shown as text.
const IMAGES = ["image/png", "image/jpeg", "image/svg+xml"];
// More lines than this are removed, the oldest first.
const MOST = 1000;
const ESCAPES = /\x1b\[[\d;]*m/g;

/**
 * @param {HTMLElement} element
 * @param {Ros} ros
 * @param {{node: string, text: string, number: number, outputs?: Shown[]}} options `number` counts the cells of the
 *   page, `outputs` are those that its author saved
 * @returns {() => void} unmount
 */
export function mount(element, ros, { node: name, text: original, number, outputs = [] }) {
  const node = ros.nodes.get(name);
  if (!node) throw new Error(`cell: no node '${name}' on this page`);
  const kernel = kernelOf(node);
  let text = original;
  const output = new Output();
  const label = say("Python cell {}", number);
  const code = create("div", "ros-code");
  const run = async () => {
    state.dataset.state = "waiting";
    setText(state, "[*]");
    output.clear();
    const outcome = await kernel.run(text, output);
    output.end(outcome);
    state.dataset.state = outcome.status;
    setText(state, outcome.status === "ok" ? "[ok]" : "[!]");
    return outcome;
  };
  const state = create("span", "ros-count", "[ ]");
  state.setAttribute("role", "status");
  const start = button(say("Run"), "ros-start", run);
  start.setAttribute("aria-label", say("Run cell {}", number));
  start.title = say("Ctrl-Enter in the cell does the same");
  const reset = button(say("Reset"), "ros-clear", () => {
    view.set(original);
    view.focus();
  });
  reset.hidden = true;
  const side = create("div", "ros-controls ros-cell-side", state, start, reset);
  element.replaceChildren(create("div", "ros-cell-input", side, code), output.element);
  const view = codeView(code, original, label, (changed) => {
    text = changed;
    reset.hidden = text === original;
  }, run);
  for (const one of outputs) output.add(one);
  kernel.cells.set(number, run);
  return () => {
    if (kernel.cells.get(number) === run) kernel.cells.delete(number);
    view.destroy();
    element.replaceChildren();
  };
}

/** What a cell printed and showed. Text is never parsed as HTML. */
class Output {
  element = create("div", "ros-output");

  constructor() {
    this.element.setAttribute("role", "log");
    this.element.setAttribute("aria-label", say("Output"));
    this.element.tabIndex = 0;
    this.#show();
  }

  clear() {
    this.element.replaceChildren();
    this.#show();
  }

  /** @param {Line[]} lines */
  lines(lines) {
    for (const { severity, text } of lines) {
      const wrong = severity === "fatal" ? "error" : severity === "stdout" || severity === "info" ? "stdout" : "stderr";
      this.add({ kind: wrong, text });
    }
  }

  /** @param {Record<string, string>} data */
  show(data) {
    this.add({ kind: "value", data });
  }

  /** @param {Outcome} outcome */
  end({ traceback = [] }) {
    for (const text of traceback) this.add({ kind: "error", text });
  }

  /** @param {Shown} shown */
  add(shown) {
    const line = shown.kind === "value" ? value(shown.data) : create("pre", "", shown.text.replace(ESCAPES, ""));
    line.classList.add(`ros-${shown.kind}`);
    this.element.append(line);
    while (this.element.childElementCount > MOST) this.element.firstElementChild?.remove();
    this.#show();
  }

  #show() {
    this.element.hidden = !this.element.childElementCount;
  }
}

/** @param {Record<string, string>} data by media type */
function value(data) {
  const kind = IMAGES.find((one) => data[one]);
  if (!kind) return create("pre", "", data["text/plain"] ?? "");
  const image = create("img", "");
  image.src = `data:${kind};base64,${data[kind]}`;
  image.alt = data["text/plain"] ?? "";
  return image;
}
