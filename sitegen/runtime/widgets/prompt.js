// @ts-check
// A Python prompt: what is typed runs on the page's graph, what it prints stands above.

import { button, create, setText } from "../ui/elements.js";
import { showLines } from "../ui/lines.js";
import { say, states } from "../ui/words.js";

/** @import { Ros } from "../protocol.js" */

// How much of what was typed can be had again.
const HISTORY = 200;
const WORD = /[\w.]*$/;

/**
 * Show a prompt; `lines` is how many it keeps.
 * @param {HTMLElement} element
 * @param {Ros} ros
 * @param {{node: string, lines?: number}} options
 * @returns {() => void} unmount
 */
export function mount(element, ros, { node: name, lines = 1000 }) {
  const node = ros.nodes.get(name);
  if (!node) throw new Error(`prompt: no node '${name}' on this page`);

  const state = create("span", "ros-state");
  state.setAttribute("aria-live", "polite");
  const title = create("div", "ros-node", create("span", "ros-name", name), state);
  const start = button(say("Start"), "ros-start", () => {
    node.start();
    input.focus();
  });
  const stop = button(say("Stop"), "ros-stop", () => node.stop());
  const interrupt = button(say("Interrupt"), "ros-interrupt", () => {
    node.interrupt();
    input.focus();
  });
  interrupt.title = say("Ctrl-C in the input line does the same");
  const controls = create("div", "ros-controls", start, stop, interrupt);
  controls.setAttribute("role", "group");
  controls.setAttribute("aria-label", name);
  const sign = create("span", "ros-sign", ">>>");
  sign.ariaHidden = "true";
  const input = create("textarea", "ros-input");
  input.rows = 1;
  input.spellcheck = false;
  input.setAttribute("aria-label", say("Python"));
  input.setAttribute("autocapitalize", "off");
  input.setAttribute("autocomplete", "off");
  const line = create("form", "ros-line", sign, input);
  element.replaceChildren(create("div", "ros-bar", title, controls));
  const end = showLines(element, node, lines, {});
  element.append(line);

  /** What was typed before Python was ready for it. @type {string[]} */
  let waiting = [];
  /** @type {string[]} */
  const history = [];
  // Where in the history the line is from; its end stands for what is being typed.
  let at = 0;
  let draft = "";
  let ready = false;
  let more = false;

  const fit = () => {
    input.rows = Math.min(input.value.split("\n").length, 12);
  };
  /** @param {string} text */
  const put = (text) => {
    input.value = text;
    fit();
  };
  const showState = () => {
    const over = node.state === "stopped" || node.state === "failed";
    if (node.state !== "running") ready = false;
    if (over) waiting = [];
    start.hidden = !over;
    stop.hidden = over;
    stop.disabled = node.state === "stopping";
    interrupt.hidden = over;
    interrupt.disabled = node.state !== "running";
    input.disabled = over;
    input.placeholder = over ? say("Press Start to run Python") : "";
    state.dataset.state = node.state;
    setText(state, states[node.state]);
  };
  const feed = () => {
    const next = ready ? waiting.shift() : undefined;
    if (next === undefined) return;
    ready = false;
    node.type({ op: "line", text: next });
  };
  const enter = () => {
    const text = input.value;
    if (text.trim() && text !== history.at(-1)) history.push(text);
    history.splice(0, history.length - HISTORY);
    at = history.length;
    put("");
    waiting.push(...text.split("\n"));
    // A block that was typed as one ends with it, unless another line of it could follow.
    if (text.includes("\n")) waiting.push("");
    feed();
  };
  /** @param {number} step */
  const recall = (step) => {
    const to = Math.min(Math.max(at + step, 0), history.length);
    if (to === at) return;
    if (at === history.length) draft = input.value;
    at = to;
    put(history[at] ?? draft);
    input.setSelectionRange(input.value.length, input.value.length);
  };
  const beginning = () => WORD.exec(input.value.slice(0, input.selectionStart))?.[0] ?? "";

  const listening = new AbortController();
  const { signal } = listening;
  node.addEventListener("state", showState, { signal });
  node.addEventListener("ready", (event) => {
    more = /** @type {CustomEvent<boolean>} */ (event).detail;
    setText(sign, more ? "..." : ">>>");
    ready = true;
    feed();
  }, { signal });
  node.addEventListener("reading", () => {
    setText(sign, "");
    ready = true;
    feed();
  }, { signal });
  node.addEventListener("words", (event) => {
    const { text, words } = /** @type {CustomEvent<{text: string, words: string[]}>} */ (event).detail;
    if (!words.length || text !== beginning()) return;
    const common = words.reduce((a, b) => {
      let n = 0;
      while (n < a.length && a[n] === b[n]) n++;
      return a.slice(0, n);
    });
    input.setRangeText(common.slice(text.length), input.selectionStart, input.selectionEnd, "end");
    fit();
    // As a terminal does: what there is to choose from, when the common part is there already.
    if (words.length > 1 && common === text) {
      const ends = words.map((word) => word.slice(word.lastIndexOf(".") + 1));
      node.dispatchEvent(new CustomEvent("lines", { detail: [{ severity: "debug", text: ends.join("  ") }] }));
    }
  }, { signal });
  line.addEventListener("submit", (event) => event.preventDefault(), { signal });
  input.addEventListener("input", fit, { signal });
  input.addEventListener("keydown", (event) => {
    const { key, shiftKey, ctrlKey, altKey, metaKey } = event;
    if (event.isComposing || altKey || metaKey) return;
    const first = !input.value.slice(0, input.selectionStart).includes("\n");
    const last = !input.value.slice(input.selectionEnd).includes("\n");
    if (key === "Enter" && !shiftKey && !ctrlKey) {
      enter();
    } else if (key === "ArrowUp" && first) {
      recall(-1);
    } else if (key === "ArrowDown" && last) {
      recall(1);
    } else if (key === "c" && ctrlKey && input.selectionStart === input.selectionEnd) {
      put("");
      node.interrupt();
    } else if (key === "Tab" && !shiftKey && !ctrlKey && ready && input.value.trim()) {
      // At the beginning of a line it indents; in an empty prompt it goes on to what follows.
      if (beginning()) node.type({ op: "complete", text: beginning() });
      else input.setRangeText("    ", input.selectionStart, input.selectionEnd, "end");
    } else {
      return;
    }
    event.preventDefault();
  }, { signal });
  showState();

  return () => {
    listening.abort();
    end();
    element.replaceChildren();
  };
}
