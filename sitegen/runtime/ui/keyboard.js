// @ts-check
// The keyboard of a program that reads one: a field below its lines, whose keys arrive as a terminal writes them.

import { create } from "./elements.js";
import { say } from "./words.js";

/** @import { Keyboard, NodeHandle } from "../protocol.js" */

/** What terminals write for keys that are no characters. @type {Record<string, string>} */
const SEQUENCES = {
  Backspace: "\x7f", Escape: "\x1b", Delete: "\x1b[3~", Home: "\x1b[H", End: "\x1b[F",
  ArrowUp: "\x1b[A", ArrowDown: "\x1b[B", ArrowRight: "\x1b[C", ArrowLeft: "\x1b[D",
  PageUp: "\x1b[5~", PageDown: "\x1b[6~",
};
const INTERRUPT = "\x03";
const END = "\x04";

/**
 * Add the field to `element`; it is there while the program runs and once it has begun to read.
 * @param {HTMLElement} element
 * @param {NodeHandle} node
 * @returns {() => void} end it
 */
export function showKeyboard(element, node) {
  const sign = create("span", "ros-sign", "›");
  sign.ariaHidden = "true";
  const input = create("input", "ros-input");
  input.spellcheck = false;
  input.setAttribute("autocapitalize", "off");
  input.setAttribute("autocomplete", "off");
  input.setAttribute("aria-label", say("Keyboard of {}", node.name));
  const field = create("form", "ros-line", sign, input);
  element.append(field);

  /** @type {Record<Keyboard, string>} */
  const hints = {
    lines: say("Input for {}; press Enter to send the line", node.name),
    hidden: say("Hidden input for {}; press Enter to send it", node.name),
    keys: say("{} reads each key pressed here", node.name),
    raw: say("{} reads each key pressed here", node.name),
  };
  const whole = () => node.keyboard === "lines" || node.keyboard === "hidden";
  const send = (/** @type {string} */ text) => node.type({ op: "keys", text });
  const sendCharacters = () => {
    if (input.value) send(input.value);
    input.value = "";
  };
  const show = () => {
    field.hidden = !node.keyboard;
    if (!node.keyboard) {
      input.value = "";
      return;
    }
    input.type = node.keyboard === "hidden" ? "password" : "text";
    input.placeholder = hints[node.keyboard];
  };

  const listening = new AbortController();
  const { signal } = listening;
  node.addEventListener("reading", show, { signal });
  node.addEventListener("state", show, { signal });
  field.addEventListener("submit", (event) => event.preventDefault(), { signal });
  // Characters come by the field, so that telephones and input methods can write them, too.
  input.addEventListener("input", (event) => {
    const { isComposing } = /** @type {InputEvent} */ (event);
    if (!whole() && !isComposing) sendCharacters();
  }, { signal });
  input.addEventListener("compositionend", () => {
    if (!whole()) sendCharacters();
  }, { signal });
  input.addEventListener("keydown", (event) => {
    const { key, ctrlKey, altKey, metaKey, isComposing } = event;
    if (isComposing || altKey || metaKey) return;
    if (ctrlKey && key === "c") {
      if (input.selectionStart !== input.selectionEnd) return; // it copies
      input.value = "";
      if (node.keyboard === "raw") send(INTERRUPT);
      else node.interrupt();
    } else if (ctrlKey && key === "d") {
      if (!whole()) send(END);
      else if (!input.value) send("");
    } else if (ctrlKey) {
      return;
    } else if (key === "Enter") {
      const text = whole() ? `${input.value}\n` : node.keyboard === "raw" ? "\r" : "\n";
      input.value = "";
      send(text);
    } else if (!whole() && SEQUENCES[key]) {
      send(SEQUENCES[key]);
    } else {
      return;
    }
    event.preventDefault();
  }, { signal });
  show();

  return () => {
    listening.abort();
    field.remove();
  };
}
