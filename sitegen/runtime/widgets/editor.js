// @ts-check
// An editor for the source of a Python node. Changes stay in the visitor's browser, and are part of shared links.

import { button, create, enable, setText } from "../ui/elements.js";
import { codeView, PYTHON, wrongLine } from "../ui/codeView.js";
import { createNeeds } from "../ui/needs.js";
import { NodeStateView } from "../ui/nodeState.js";
import { say } from "../ui/words.js";

/** @import { Checked, Line, NodeHandle, Ros } from "../protocol.js" */

// Save, check and report changes this long (ms) after the last key.
const PAUSE = 300;

/**
 * Show a file of a node. `place` is where the file is installed, `text` its content in the workspace.
 * @param {HTMLElement} element
 * @param {Ros} ros
 * @param {{node: string, file: string, place: string, text: string}} options
 * @returns {() => void} unmount
 */
export function mount(element, ros, { node: name, ...source }) {
  const node = ros.nodes.get(name);
  if (!node) throw new Error(`editor: no node '${name}' on this page`);
  const editor = new Editor(element, ros, node, source);
  return () => {
    editor.close();
    element.replaceChildren();
  };
}

class Editor {
  #node;
  #place;
  #original;
  #text;
  /** Where localStorage keeps the edit. */
  #key;
  #fromLink = false;
  /** What is wrong in which line: a syntax error, or the last exception. Line 0 is none. */
  #fault = { line: 0, text: "" };
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #timer;
  #listening = new AbortController();
  #status = create("span", "ros-edited");
  #start = button(say("Run"), "ros-start", () => this.#run());
  #stop = button(say("Stop"), "ros-stop", () => this.#node.stop());
  #reset = button(say("Reset"), "ros-clear", () => {
    this.#view.set(this.#original);
    this.#view.focus();
  });
  #view;

  /**
   * @param {HTMLElement} element @param {Ros} ros @param {NodeHandle} node
   * @param {{file: string, place: string, text: string}} source
   */
  constructor(element, ros, node, { file, place, text: original }) {
    this.#node = node;
    this.#place = place;
    this.#original = original;
    this.#key = `sitegen:edit:${location.pathname}:${node.name}:${place}`;
    const saved = recall(this.#key);
    // An edit of an older version of the file would undo what the author has changed since.
    this.#text = saved?.of === original ? saved.text : original;
    ros.keep(element, { text: "string" }, () => ({ text: this.#changed ? this.#text : "" }), (state) => {
      this.#fromLink = true;
      this.#text = state.text;
    });
    // Code in a link is someone else's: it must not run before the visitor presses Run.
    if (this.#changed && !this.#fromLink) node.edit(place, this.#text);

    const code = create("div", "ros-code");
    const hint = create("p", "ros-leave", say("Press Esc, then Tab to leave the editor."));
    const state = new NodeStateView(node, this.#listening.signal);
    state.label.setAttribute("aria-live", "polite");
    element.replaceChildren(this.#createBar(file, state.label), state.meter, code, hint);
    state.meter.after(createNeeds(ros, node, this.#listening.signal));
    const label = say("Python source {}", file);
    this.#view = codeView(code, {
      text: this.#text, language: PYTHON, label, changed: (text) => this.#typed(text), run: () => this.#run(),
    });
    this.#listen();
    this.#check();
  }

  close() {
    this.#save();
    this.#listening.abort();
    this.#view.destroy();
  }

  get #changed() {
    return this.#text !== this.#original;
  }

  /** @param {string} file @param {HTMLElement} state */
  #createBar(file, state) {
    this.#status.setAttribute("role", "status");
    const title = create("div", "ros-node", create("span", "ros-name", file), create("div", "", state, this.#status));
    this.#start.title = say("Ctrl-Enter in the editor does the same");
    const controls = create("div", "ros-controls", this.#start, this.#stop, this.#reset);
    controls.setAttribute("role", "group");
    controls.setAttribute("aria-label", file);
    return create("div", "ros-bar", title, controls);
  }

  #listen() {
    const { signal } = this.#listening;
    this.#node.addEventListener("lines", (event) => {
      this.#findError(/** @type {CustomEvent<Line[]>} */ (event).detail);
    }, { signal });
    this.#node.addEventListener("state", () => {
      if (this.#node.state === "starting") this.#mark(0);
      else this.#show();
    }, { signal });
    this.#node.addEventListener("checked", (event) => {
      const { text, line, error } = /** @type {CustomEvent<Checked>} */ (event).detail;
      if (text === this.#text) this.#mark(line, say("line {}: {}", line, error));
    }, { signal });
    addEventListener("pagehide", () => this.#save(), { signal });
  }

  #run() {
    this.#fromLink = false;
    this.#save();
    this.#node.edit(this.#place, this.#changed ? this.#text : undefined);
    this.#node.restart();
  }

  /** @param {string} text the new content */
  #typed(text) {
    this.#text = text;
    this.#reset.disabled = !this.#changed;
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => {
      this.#save();
      this.#check();
    }, PAUSE);
  }

  /** Mark the first syntax error. The interpreter of a running node knows more, and answers with `checked`. */
  #check() {
    const line = wrongLine(this.#text, PYTHON);
    this.#mark(line, say("syntax error in line {}", line));
    this.#node.check(this.#text);
  }

  /** Mark the last line of this file that a traceback names: there the program stopped. @param {Line[]} lines */
  #findError(lines) {
    const reference = `File "/ros/${this.#place}", line `;
    let error = 0;
    for (const { severity, text } of lines) {
      const at = severity === "stderr" ? text.lastIndexOf(reference) : -1;
      if (at >= 0) error = Number.parseInt(text.slice(at + reference.length), 10) || 0;
    }
    if (error) this.#mark(error, say("error in line {}", error));
  }

  /** @param {number} line or 0 for none @param {string} text */
  #mark(line, text = "") {
    this.#fault = { line, text };
    this.#view.mark(line);
    this.#show();
  }

  #show() {
    const { state } = this.#node;
    const over = state === "stopped" || state === "failed";
    setText(this.#start, over ? say("Run") : say("Run again"));
    enable([[this.#stop, !over && state !== "stopping"], [this.#start, true], [this.#reset, this.#changed]]);
    setText(this.#status, this.#describe());
    this.#status.dataset.changed = String(this.#changed || this.#fault.line > 0);
  }

  #describe() {
    if (this.#fault.line) return this.#fault.text;
    if (!this.#changed) return say("unchanged");
    return this.#fromLink ? say("changed by the link: read it before you run it") : say("changed");
  }

  #save() {
    clearTimeout(this.#timer);
    if (this.#fromLink) return;
    remember(this.#key, this.#changed ? { of: this.#original, text: this.#text } : undefined);
  }
}

/** @param {string} key @returns {{of: string, text: string} | undefined} */
function recall(key) {
  try {
    const { of, text } = JSON.parse(localStorage.getItem(key) ?? "{}");
    return typeof of === "string" && typeof text === "string" ? { of, text } : undefined;
  } catch {
    return undefined; // no storage, or the value is not ours
  }
}

/** @param {string} key @param {{of: string, text: string} | undefined} edit */
function remember(key, edit) {
  try {
    if (edit) localStorage.setItem(key, JSON.stringify(edit));
    else localStorage.removeItem(key);
  } catch {
    // Without storage, the edit lasts until the page is closed.
  }
}
