// @ts-check
// A Python prompt on the page's ROS graph: an input line below the output.

import { button, create } from "../ui/elements.js";
import { showLines } from "../ui/lines.js";
import { createNeeds } from "../ui/needs.js";
import { NodeStateView } from "../ui/nodeState.js";
import { say } from "../ui/words.js";
import { InputLine } from "./prompt/inputLine.js";

/** @import { NodeHandle, Ros } from "../protocol.js" */

/**
 * Show a prompt that keeps the last `lines` lines of output.
 * @param {HTMLElement} element
 * @param {Ros} ros
 * @param {{node: string, lines?: number}} options
 * @returns {() => void} unmount
 */
export function mount(element, ros, { node: name, lines = 1000 }) {
  const node = ros.nodes.get(name);
  if (!node) throw new Error(`prompt: no node '${name}' on this page`);
  const prompt = new Prompt(ros, node);
  element.replaceChildren(prompt.bar, prompt.meter, prompt.needs);
  const shown = showLines(element, node, lines, {});
  element.append(prompt.line.element);
  return () => {
    prompt.close();
    shown.close();
    element.replaceChildren();
  };
}

class Prompt {
  #node;
  /** Lines that Python is not ready for yet. @type {string[]} */
  #waiting = [];
  #listening = new AbortController();
  #state;
  #start = button(say("Start"), "ros-start", () => {
    this.#node.start();
    this.line.focus();
  });
  #stop = button(say("Stop"), "ros-stop", () => this.#node.stop());
  #interrupt = button(say("Interrupt"), "ros-interrupt", () => {
    this.#node.interrupt();
    this.line.focus();
  });
  line = new InputLine({
    enter: (text) => this.#enter(text),
    complete: (text) => this.#node.type({ op: "complete", text }),
    interrupt: () => this.#node.interrupt(),
  });
  bar;
  meter;
  needs;

  /** @param {Ros} ros @param {NodeHandle} node */
  constructor(ros, node) {
    this.#node = node;
    this.#state = new NodeStateView(node, this.#listening.signal);
    this.#state.label.setAttribute("aria-live", "polite");
    this.#interrupt.title = say("Ctrl-C in the input line does the same");
    const title = create("div", "ros-node", create("span", "ros-name", node.name), this.#state.label);
    const controls = create("div", "ros-controls", this.#start, this.#stop, this.#interrupt);
    controls.setAttribute("role", "group");
    controls.setAttribute("aria-label", node.name);
    this.bar = create("div", "ros-bar", title, controls);
    this.meter = this.#state.meter;
    this.needs = createNeeds(ros, node, this.#listening.signal);
    this.#listen();
    this.#show();
  }

  close() {
    this.#listening.abort();
  }

  #listen() {
    const { signal } = this.#listening;
    this.#node.addEventListener("state", () => this.#show(), { signal });
    this.#node.addEventListener("ready", (event) => {
      const { detail: more } = /** @type {CustomEvent<boolean>} */ (event);
      this.line.expect(more ? "..." : ">>>");
      this.#feed();
    }, { signal });
    this.#node.addEventListener("reading", () => {
      this.line.expect("");
      this.#feed();
    }, { signal });
    this.#node.addEventListener("words", (event) => {
      const { text, words } = /** @type {CustomEvent<{text: string, words: string[]}>} */ (event).detail;
      if (words.length && text === this.line.word) this.#complete(text, words);
    }, { signal });
  }

  #show() {
    const { state } = this.#node;
    const over = state === "stopped" || state === "failed";
    if (state !== "running") this.line.ready = false;
    if (over) this.#waiting = [];
    this.#start.hidden = !over;
    this.#stop.hidden = over;
    this.#stop.disabled = state === "stopping";
    this.#interrupt.hidden = over;
    this.#interrupt.disabled = state !== "running";
    this.line.enable(!over, say("Press Start to run Python"));
  }

  /** @param {string} text */
  #enter(text) {
    this.#waiting.push(...text.split("\n"));
    // An empty line ends a block that was typed in one go.
    if (text.includes("\n")) this.#waiting.push("");
    this.#feed();
  }

  #feed() {
    const next = this.line.ready ? this.#waiting.shift() : undefined;
    if (next === undefined) return;
    this.line.ready = false;
    this.#node.type({ op: "line", text: next });
  }

  /** Insert what all completions have in common. @param {string} text @param {string[]} words */
  #complete(text, words) {
    const common = words.reduce(commonStart);
    this.line.insert(common.slice(text.length));
    if (words.length === 1 || common !== text) return;
    // As in a terminal, list the choices when there is nothing to insert.
    const ends = words.map((word) => word.slice(word.lastIndexOf(".") + 1));
    this.#node.dispatchEvent(new CustomEvent("lines", { detail: [{ severity: "debug", text: ends.join("  ") }] }));
  }
}

/** @param {string} a @param {string} b */
function commonStart(a, b) {
  let length = 0;
  while (length < a.length && a[length] === b[length]) length++;
  return a.slice(0, length);
}
