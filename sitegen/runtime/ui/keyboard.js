// @ts-check
// The standard input of a program: a field below its output. Keys arrive as the characters that a terminal sends.

import { create } from "./elements.js";
import { say } from "./words.js";

/** @import { Keyboard, NodeHandle } from "../protocol.js" */

/** The escape sequences that terminals send for special keys. @type {Record<string, string>} */
const SEQUENCES = {
  Backspace: "\x7f", Escape: "\x1b", Delete: "\x1b[3~", Home: "\x1b[H", End: "\x1b[F",
  ArrowUp: "\x1b[A", ArrowDown: "\x1b[B", ArrowRight: "\x1b[C", ArrowLeft: "\x1b[D",
  PageUp: "\x1b[5~", PageDown: "\x1b[6~",
};
const INTERRUPT = "\x03";
const END = "\x04";

/**
 * Append the field to `element`. It is visible while the program reads its input.
 * @param {HTMLElement} element
 * @param {NodeHandle} node
 * @returns {() => void} remove it
 */
export function showKeyboard(element, node) {
  const field = new KeyboardField(node);
  element.append(field.element);
  return () => field.close();
}

class KeyboardField {
  #node;
  #input = create("input", "ros-input");
  element;
  #listening = new AbortController();
  /** @type {Record<Keyboard, string>} */
  #hints;

  /** @param {NodeHandle} node */
  constructor(node) {
    this.#node = node;
    this.#hints = {
      lines: say("Input for {}; press Enter to send the line", node.name),
      hidden: say("Hidden input for {}; press Enter to send it", node.name),
      keys: say("{} reads each key pressed here", node.name),
      raw: say("{} reads each key pressed here", node.name),
    };
    const sign = create("span", "ros-sign", "›");
    sign.ariaHidden = "true";
    this.#input.spellcheck = false;
    this.#input.setAttribute("autocapitalize", "off");
    this.#input.setAttribute("autocomplete", "off");
    this.#input.setAttribute("aria-label", say("Keyboard of {}", node.name));
    this.element = create("form", "ros-line", sign, this.#input);
    this.#listen();
    this.#show();
  }

  close() {
    this.#listening.abort();
    this.element.remove();
  }

  #listen() {
    const { signal } = this.#listening;
    this.#node.addEventListener("reading", () => this.#show(), { signal });
    this.#node.addEventListener("state", () => this.#show(), { signal });
    this.element.addEventListener("submit", (event) => event.preventDefault());
    // Characters are taken from the field instead of key events, because on-screen keyboards and input methods
    // send no useful key events.
    this.#input.addEventListener("input", (event) => {
      const { isComposing } = /** @type {InputEvent} */ (event);
      if (!this.#sendsLines && !isComposing) this.#sendCharacters();
    });
    this.#input.addEventListener("compositionend", () => {
      if (!this.#sendsLines) this.#sendCharacters();
    });
    this.#input.addEventListener("keydown", (event) => {
      if (this.#press(event)) event.preventDefault();
    });
  }

  /** Whether the program reads whole lines instead of single keys. */
  get #sendsLines() {
    return this.#node.keyboard === "lines" || this.#node.keyboard === "hidden";
  }

  #show() {
    const { keyboard } = this.#node;
    this.element.hidden = !keyboard;
    if (keyboard) {
      this.#input.type = keyboard === "hidden" ? "password" : "text";
      this.#input.placeholder = this.#hints[keyboard];
    } else {
      this.#input.value = "";
    }
  }

  /** Handle a key; return whether it has a meaning here. @param {KeyboardEvent} event */
  #press({ key, ctrlKey, altKey, metaKey, isComposing }) {
    if (isComposing || altKey || metaKey) return false;
    if (ctrlKey) return this.#pressControl(key);
    if (key === "Enter") {
      this.#enter();
    } else if (!this.#sendsLines && SEQUENCES[key]) {
      this.#send(SEQUENCES[key]);
    } else {
      return false;
    }
    return true;
  }

  /** @param {string} key pressed with Ctrl */
  #pressControl(key) {
    if (key === "c") {
      if (this.#input.selectionStart !== this.#input.selectionEnd) return false; // copy the selection
      this.#input.value = "";
      if (this.#node.keyboard === "raw") this.#send(INTERRUPT);
      else this.#node.interrupt();
    } else if (key === "d") {
      if (!this.#sendsLines) this.#send(END);
      else if (!this.#input.value) this.#send("");
    } else {
      return false;
    }
    return true;
  }

  #enter() {
    const lineEnd = this.#node.keyboard === "raw" ? "\r" : "\n";
    const text = this.#sendsLines ? `${this.#input.value}\n` : lineEnd;
    this.#input.value = "";
    this.#send(text);
  }

  #sendCharacters() {
    if (this.#input.value) this.#send(this.#input.value);
    this.#input.value = "";
  }

  /** @param {string} text */
  #send(text) {
    this.#node.type({ op: "keys", text });
  }
}
