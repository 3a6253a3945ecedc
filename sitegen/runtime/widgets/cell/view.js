// @ts-check
// What each cell of a page shows: its source, which can be edited, its buttons, its state and its output.

import { codeView, wrongLine } from "../../ui/codeView.js";
import { button, create, setText } from "../../ui/elements.js";
import { say } from "../../ui/words.js";
import { Output } from "./output.js";

/** @import { Ros } from "../../protocol.js" */
/** @import { Language } from "../../ui/codeView.js" */
/** @import { Around } from "./panel.js" */

// In the same bundle, since those who show code need both.
export { PYTHON } from "../../ui/codeView.js";

/**
 * @typedef {{text: string, language: Language, label: string, runs: string, stops?: string}} Source with the names of the
 *   editor and of its buttons
 * @typedef {{run(): void, stop?: () => void, changed(): void, complete?: () => void}} Actions of visitors: they press
 *   Run, Stop, or keys
 */

// Check the syntax this long (ms) after the last key.
const PAUSE = 300;

export class CellView {
  /** The text now. @type {string} */
  text;
  /** What the link changed is foreign until the visitor runs it. */
  #fromLink = false;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #timer;
  #source;
  #actions;
  #code;
  #label = create("span", "ros-cell-state");
  #note = create("p", "ros-cell-note");
  #start;
  /** In place of Run, while there is something to stop. */
  #stop;
  #reset = button(say("Reset"), "ros-clear", () => {
    this.#code.set(this.#source.text);
    this.#code.focus();
  });
  output;

  /**
   * @param {HTMLElement} element @param {Ros} ros @param {Source} source @param {Actions} actions
   * @param {() => Around} [around] what panels in the output need besides
   */
  constructor(element, ros, source, actions, around = () => ({})) {
    this.output = new Output(ros, around);
    this.#source = source;
    this.#actions = actions;
    this.text = source.text;
    ros.keep(element, { text: "string" }, () => ({ text: this.#changed ? this.text : "" }), (state) => {
      this.#fromLink = true;
      this.text = /** @type {string} */ (state.text ?? source.text);
    });
    for (const told of [this.#label, this.#note]) told.setAttribute("role", "status");
    this.#start = button(say("Run"), "ros-start", actions.run);
    this.#start.setAttribute("aria-label", source.runs);
    this.#start.title = say("Ctrl-Enter in the cell does the same");
    this.#stop = button(say("Stop"), "ros-stop", () => actions.stop?.());
    if (source.stops) this.#stop.setAttribute("aria-label", source.stops);
    this.#stop.hidden = true;
    const side = create("div", "ros-controls ros-cell-side", this.#label, this.#start, this.#stop, this.#reset);
    const code = create("div", "ros-code");
    element.replaceChildren(
      create("div", "ros-cell-input", side, create("div", "ros-cell-code", code, this.#note)), this.output.element);
    this.#code = codeView(code, {
      text: this.text, language: source.language, label: source.label, complete: actions.complete,
      changed: (text) => this.#typed(text), run: actions.run,
    });
    this.show("none", say("not run"));
    this.#check();
  }

  /** The cell runs now. */
  begin() {
    this.#fromLink = false;
    this.tell("");
  }

  close() {
    clearTimeout(this.#timer);
    this.output.clear();
    this.#code.destroy();
  }

  /** The text and the place of the cursor. */
  get cursor() {
    return this.#code.cursor();
  }

  /** Replace a part of the text. @param {number} start @param {number} end @param {string} text */
  replace(start, end, text) {
    this.#code.replace(start, end, text);
  }

  /** Mark a line as wrong; 0 removes the mark. @param {number} line */
  mark(line) {
    this.#code.mark(line);
  }

  /** @param {string} note below the text */
  tell(note) {
    setText(this.#note, note);
    this.#note.hidden = !note;
    this.#reset.hidden = !this.#changed;
  }

  /**
   * Show the state of the cell.
   * @param {string} state for style sheets @param {string} text @param {string} [title]
   * @param {boolean} [running] whether Stop ends something
   */
  show(state, text, title = "", running = false) {
    this.#label.dataset.state = state;
    setText(this.#label, text);
    this.#label.title = title;
    const [shown, other] = running ? [this.#stop, this.#start] : [this.#start, this.#stop];
    const focused = document.activeElement === other;
    shown.hidden = false;
    other.hidden = true;
    if (focused) shown.focus();
  }

  get #changed() {
    return this.text !== this.#source.text;
  }

  /** @param {string} text the new content */
  #typed(text) {
    this.text = text;
    this.tell("");
    this.#actions.changed();
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => this.#check(), PAUSE);
  }

  /** Mark the first syntax error. */
  #check() {
    const line = wrongLine(this.text, this.#source.language);
    this.mark(line);
    const foreign = this.#fromLink && this.#changed ? say("changed by the link: read it before you run it") : "";
    this.tell(line ? say("syntax error in line {}", line) : foreign);
  }
}
