// @ts-check
// The input line of a prompt, with history, completion and the keys of a terminal.

import { create, setText } from "../../ui/elements.js";
import { say } from "../../ui/words.js";
import { History } from "./history.js";

/**
 * @typedef {{enter(text: string): void, complete(word: string): void, interrupt(): void}} Actions
 *   what the line calls for Enter, Tab after a word, and Ctrl-C
 */

const MOST_ROWS = 12;
const WORD = /[\w.]*$/;

export class InputLine {
  #actions;
  #history = new History();
  #sign = create("span", "ros-sign", ">>>");
  #input = create("textarea", "ros-input");
  element = create("form", "ros-line", this.#sign, this.#input);
  /** Whether Python waits for a line. */
  ready = false;
  /** What is shown in front of the first row. */
  #first = ">>>";
  /** Whether Tab moves the focus, as it does after Esc. */
  #leaving = false;

  /** @param {Actions} actions */
  constructor(actions) {
    this.#actions = actions;
    this.#sign.ariaHidden = "true";
    const input = this.#input;
    input.rows = 1;
    input.spellcheck = false;
    input.setAttribute("aria-label", say("Python"));
    input.title = say("Press Esc, then Tab to leave the prompt.");
    input.setAttribute("autocapitalize", "off");
    input.setAttribute("autocomplete", "off");
    this.element.addEventListener("submit", (event) => event.preventDefault());
    input.addEventListener("input", () => this.#fit());
    input.addEventListener("keydown", (event) => {
      if (this.#press(event)) event.preventDefault();
    });
  }

  focus() {
    this.#input.focus();
  }

  /** Accept input, or show `hint` instead. @param {boolean} on @param {string} hint */
  enable(on, hint) {
    this.#input.disabled = !on;
    this.#input.placeholder = on ? "" : hint;
  }

  /** Accept the next line. @param {string} sign shown in front of it */
  expect(sign) {
    this.#first = sign;
    this.ready = true;
    this.#fit();
  }

  /** The word before the cursor, possibly empty. */
  get word() {
    return WORD.exec(this.#input.value.slice(0, this.#input.selectionStart))?.[0] ?? "";
  }

  /** Insert at the cursor. @param {string} text */
  insert(text) {
    this.#input.setRangeText(text, this.#input.selectionStart, this.#input.selectionEnd, "end");
    this.#fit();
  }

  /** Handle a key; return whether it has a meaning here. @param {KeyboardEvent} event */
  #press(event) {
    const { key, shiftKey, ctrlKey, altKey, metaKey } = event;
    if (event.isComposing || altKey || metaKey) return false;
    const leaving = this.#leaving;
    if (key !== "Shift") this.#leaving = key === "Escape";
    const { value, selectionStart, selectionEnd } = this.#input;
    if (key === "Enter" && !shiftKey && !ctrlKey) {
      this.#enter();
    } else if (key === "ArrowUp" && !value.slice(0, selectionStart).includes("\n")) {
      this.#recall(-1);
    } else if (key === "ArrowDown" && !value.slice(selectionEnd).includes("\n")) {
      this.#recall(1);
    } else if (key === "c" && ctrlKey && selectionStart === selectionEnd) {
      this.#put("");
      this.#actions.interrupt();
    } else if (key === "Tab" && !leaving && !shiftKey && !ctrlKey && this.ready && value.trim()) {
      // Tab indents where no word begins. In an empty line it moves the focus, as everywhere else.
      if (this.word) this.#actions.complete(this.word);
      else this.insert("    ");
    } else {
      return false;
    }
    return true;
  }

  #enter() {
    const text = this.#input.value;
    this.#history.add(text);
    this.#put("");
    this.#actions.enter(text);
  }

  /** @param {number} step */
  #recall(step) {
    const text = this.#history.recall(step, this.#input.value);
    if (text === undefined) return;
    this.#put(text);
    this.#input.setSelectionRange(text.length, text.length);
  }

  /** @param {string} text */
  #put(text) {
    this.#input.value = text;
    this.#fit();
  }

  #fit() {
    const rows = Math.min(this.#input.value.split("\n").length, MOST_ROWS);
    this.#input.rows = rows;
    // As in a terminal, "..." stands before each further line. A program that reads its input has no sign.
    setText(this.#sign, [this.#first, ...Array(rows - 1).fill(this.#first && "...")].join("\n"));
  }
}
